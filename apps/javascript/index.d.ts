/** Alpha shapes, concave hulls, Delaunay triangulations and Voronoi cells of points in the plane.
 *
 * Every decision is exact, also on grids, duplicates and collinear points; the result depends only on the set of points and on alpha. Alpha is a
 * radius in the units of the points. Points on one line, and fewer than three points, have no triangle.
 *
 *     import { load } from "rbpa";
 *     const rbpa = await load();
 *     rbpa.alphaShape([[0, 0], [1, 0], [1, 1], [0, 1], [9, 9]], 1).area   // 1
 */

/** Points, each as [x, y], or numbers x0, y0, x1, y1, …; a typed array is fastest. */
export type Points = ArrayLike<readonly number[]> | ArrayLike<number>;

/** A radius, or a rule: "plateau:K" is a radius in the K-th plateau, a range in which parts and holes hardly change, the
 * best first; "plateau" means "plateau:1"; "auto" is the least radius that covers every point in one solid
 * component; "min" is the least that covers every point. */
export type Alpha = number | "auto" | "min" | "plateau" | `plateau:${number}`;

/** Thrown for an invalid argument, which the message names. */
export class InvalidInput extends Error {}

/** Triangles of circumradius at most alpha; corners are indices of points. */
export interface AlphaComplex {
  /** Three corners per triangle, counter-clockwise if y points up, the least index first; triangles are in
   * lexicographic order. Only the first of equal points is a corner. */
  triangles: Uint32Array;
  /** Number 3 t + k is the triangle opposite to corner k of triangle t, or -1. */
  neighbors: Int32Array;
  /** Side 3 t + k goes from corner k of triangle t to the next; number 3 t + k is the same side of the triangle
   * beyond, or -1. */
  halfedges: Int32Array;
  /** The two ends of each side with a triangle on its left only. */
  boundary: Uint32Array;
  /** Distinct points in no triangle. */
  isolated: Uint32Array;
  /** Pairs: a point that is equal to an earlier one, and that earlier point. */
  duplicates: Uint32Array;
}

export interface Polygon {
  /** Indices of points, counter-clockwise, the first not repeated. */
  shell: Uint32Array;
  /** Indices of the points of each hole, clockwise. */
  holes: Uint32Array[];
  /** Area without the holes, in squared units of the points. */
  area: number;
  /** Length of all rings. */
  perimeter: number;
}

export interface AlphaShape extends AlphaComplex {
  /** The given or chosen radius; null if the rule chooses none, as all points are on one line. */
  alpha: number | null;
  /** One polygon per solid component: simple, and valid by the rules of the OGC. */
  polygons: Polygon[];
  area: number;
  perimeter: number;
  toGeoJSON(): { type: "MultiPolygon"; coordinates: number[][][][] };
}

export interface Plateau {
  from: number;
  /** Infinity if the plateau has no end. */
  to: number;
  ratio: number;
  /** The radius to choose. */
  alpha: number;
  kind: "structured" | "one piece";
  isLong: boolean;
}

/** Properties of the alpha shape for every alpha: one entry of each array for each radius at which something
 * changes. */
export interface Filtration {
  alpha: Float64Array;
  triangles: Uint32Array;
  solidComponents: Uint32Array;
  components: Uint32Array;
  holes: Uint32Array;
  covered: Uint32Array;
  area: Float64Array;
  /** The radius of the rule "auto", and of "min"; null if there is none. */
  auto: number | null;
  min: number | null;
  /** The longest first. */
  plateaus: Plateau[];
}

/** Voronoi cells within a box, which they tile: neighbors have the same corners, also after rounding. */
export interface VoronoiCells {
  /** Coordinates of the corners: x0, y0, x1, y1, … */
  vertices: Float64Array;
  /** Cells whose corners are indices of vertices. */
  polygons: Polygon[];
  /** For each polygon the point of its cell; of equal points the first. */
  points: Uint32Array;
  /** Returns the cell of a point as a closed ring, counter-clockwise if y points up; null for a point that is equal to an
   * earlier one, or whose cell is outside of the box. */
  cellPolygon(i: number): number[][] | null;
  /** Returns all cells, each with the index of its point. */
  cellPolygons(): Iterable<number[][] & { index: number }>;
  /** Returns the points whose cells have a side in common with the cell of point i. */
  neighbors(i: number): Iterable<number>;
}

/** A constrained Delaunay triangulation: every segment is an edge, or a chain of edges where it passes points. */
export interface ConstrainedDelaunay extends Omit<AlphaComplex, "isolated"> {
  /** Coordinates of the given points; then of the places where segments that cross were split. */
  points: Float64Array;
  /** For each such place two of the segments that cross there. */
  crossed: Uint32Array;
  /** Number 3 t + k is 1 if the side opposite to corner k of triangle t is on a segment, or else 0. */
  constrained: Uint8Array;
  /** The two ends of each edge on a segment, the smaller index first. */
  segments: Uint32Array;
  /** The region of each triangle; segments bound regions. */
  region: Uint32Array;
  /** For each region 1 if it is inside by the even-odd rule, that is, if a path from outside crosses an odd number of
   * segments, or else 0. */
  isInside: Uint8Array;
}

/** A Delaunay triangulation with the members of the package delaunator; triangles are clockwise if y points up. */
export interface Delaunator<T extends ArrayLike<number> = Float64Array> {
  coords: T;
  triangles: Uint32Array;
  halfedges: Int32Array;
  hull: Uint32Array;
  trianglesLen: number;
  /** Recomputes the triangulation after a change of coords. */
  update(): void;
}

export interface DelaunatorConstructor {
  new <T extends ArrayLike<number>>(coords: T): Delaunator<T>;
  from<P>(points: ArrayLike<P>, getX?: (p: P) => number, getY?: (p: P) => number): Delaunator<Float64Array>;
}

/** All functions throw InvalidInput, and RangeError if memory does not suffice. */
export interface Rbpa {
  /** Returns the Delaunay triangles of circumradius at most alpha, by default all. */
  alphaComplex(points: Points, alpha?: number): AlphaComplex;
  /** Returns these triangles and their outline as polygons; alpha is "plateau" by default. Holes smaller than
   * minHoleArea are filled, and polygons smaller than minPartArea are left out. */
  alphaShape(points: Points, alpha?: Alpha, options?: { minHoleArea?: number; minPartArea?: number }): AlphaShape;
  /** Returns the outline of the points as a closed ring of points, without holes, in the form of concaveman; the
   * largest if there are several. alpha is "auto" by default, so that the ring encloses every point. */
  concaveHull<P extends readonly number[]>(points: ArrayLike<P>, alpha?: Alpha): P[];
  concaveHull(points: ArrayLike<number>, alpha?: Alpha): number[][];
  /** Returns the properties of the alpha shape for every alpha. */
  filtration(points: Points): Filtration;
  /** Returns the Voronoi cells within a box, [least x, least y, greatest x, greatest y], by default one around the
   * points. */
  voronoi(points: Points, box?: ArrayLike<number>): VoronoiCells;
  /** Returns the constrained Delaunay triangulation. Segments are pairs of indices of points; they may touch and
   * overlap. Those that cross are refused, or split at the nearest numbers. */
  constrainedDelaunay(points: Points, segments: Points, options?: { splitCrossings?: boolean }): ConstrainedDelaunay;
  Delaunator: DelaunatorConstructor;
  /** Size of the instance's memory in bytes. */
  readonly memoryBytes: number;
}

/** Returns a new instance, whose functions are synchronous. Nothing has to be freed. WebAssembly's memory grows and
 * never shrinks: after a very large run, drop the instance and load another. */
export function load(): Promise<Rbpa>;
export default load;
