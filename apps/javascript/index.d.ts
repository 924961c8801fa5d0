/** Alpha shapes, concave hulls and Delaunay triangulations of points in the plane.
 *
 * Every decision is exact, also on grids, duplicates and collinear points; the result depends on the set of points and on alpha alone. Alpha is a
 * radius in the units of the points. Points on one line, and fewer than three, have no triangle.
 *
 *     import { load } from "rbpa";
 *     const rbpa = await load();
 *     rbpa.alphaShape([[0, 0], [1, 0], [1, 1], [0, 1], [9, 9]], 1).area   // 1
 */

/** Points as [x, y] each, or as numbers x0, y0, x1, y1, …; a typed array is fastest. */
export type Points = ArrayLike<readonly number[]> | ArrayLike<number>;

/** A radius, or a rule: "plateau:K", in the K-th of the ranges in which the shape hardly changes, the best first; "plateau" is the first; "auto", the least that
 * covers every point in one solid component; "min", the least that covers every point. */
export type Alpha = number | "auto" | "min" | "plateau" | `plateau:${number}`;

/** A value that is not what was expected; the message says which. */
export class InvalidInput extends Error {}

/** Triangles of circumradius at most alpha; indices are those of points. */
export interface Triangulation {
  /** Three corners each, counter-clockwise where y points up, the least first; in lexicographic order. Of equal points the first is a corner. */
  triangles: Uint32Array;
  /** Number 3 t + k is the triangle across from corner k of triangle t, or -1. */
  neighbors: Int32Array;
  /** Side 3 t + k goes from corner k of triangle t to the next; here is the same side of the triangle beyond, or -1. */
  halfedges: Int32Array;
  /** Two ends of each side with a triangle on one side only, which is the left one. */
  boundary: Uint32Array;
  /** Distinct points in no triangle. */
  isolated: Uint32Array;
  /** Pairs: a point that is equal to one before it, and that one. */
  duplicates: Uint32Array;
}

export interface Polygon {
  /** Indices of points, counter-clockwise, the first not repeated. */
  shell: Uint32Array;
  /** The same of holes, clockwise. */
  holes: Uint32Array[];
  /** Without the holes. */
  area: number;
  /** Of all rings. */
  perimeter: number;
}

export interface AlphaShape extends Triangulation {
  /** The radius that was given or chosen; null where there is none, as all points are on one line. */
  alpha: number | null;
  /** One of each solid component: simple, valid by the rules of OGC. */
  polygons: Polygon[];
  area: number;
  perimeter: number;
  toGeoJSON(): { type: "MultiPolygon"; coordinates: number[][][][] };
}

export interface Plateau {
  from: number;
  /** Infinity: it has no end. */
  to: number;
  ratio: number;
  /** The radius to choose. */
  alpha: number;
  kind: "structured" | "one piece";
  isLong: boolean;
}

/** What changes as alpha grows: one entry of each array for each radius at which something does. */
export interface Filtration {
  alpha: Float64Array;
  triangles: Uint32Array;
  solidComponents: Uint32Array;
  components: Uint32Array;
  holes: Uint32Array;
  covered: Uint32Array;
  area: Float64Array;
  /** The radii of the rules of that name; null where there is none. */
  auto: number | null;
  min: number | null;
  /** The longest first. */
  plateaus: Plateau[];
}

/** A Delaunay triangulation with the members of the package delaunator, whose triangles are clockwise where y points up. */
export interface Delaunator<T extends ArrayLike<number> = Float64Array> {
  coords: T;
  triangles: Uint32Array;
  halfedges: Int32Array;
  hull: Uint32Array;
  trianglesLen: number;
  /** Computes it anew, of coordinates that were changed. */
  update(): void;
}

export interface DelaunatorConstructor {
  new <T extends ArrayLike<number>>(coords: T): Delaunator<T>;
  from<P>(points: ArrayLike<P>, getX?: (p: P) => number, getY?: (p: P) => number): Delaunator<Float64Array>;
}

/** All functions throw InvalidInput, and RangeError where memory does not suffice. */
export interface Rbpa {
  /** The Delaunay triangles of circumradius at most alpha, by default all. */
  triangulate(points: Points, alpha?: number): Triangulation;
  /** The same with polygons, by default of the rule "plateau". Smaller holes are filled, and smaller polygons left out. */
  alphaShape(points: Points, alpha?: Alpha, options?: { minHoleArea?: number; minPartArea?: number }): AlphaShape;
  /** The outline of the points as a closed ring of points, without holes, by default of the rule "auto", so that it holds every point; the largest where there are
   * several; as concaveman returns it. */
  concaveHull<P extends readonly number[]>(points: ArrayLike<P>, alpha?: Alpha): P[];
  concaveHull(points: ArrayLike<number>, alpha?: Alpha): number[][];
  /** What every alpha would give. */
  filtration(points: Points): Filtration;
  Delaunator: DelaunatorConstructor;
  /** How much memory the instance has. */
  readonly memoryBytes: number;
}

/** A new instance, which works from then on without waiting. Nothing has to be freed. WebAssembly's memory grows and never shrinks: after one very large
 * run forget the instance, and load another. */
export function load(): Promise<Rbpa>;
export default load;
