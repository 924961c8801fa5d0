/** Surfaces of points in space, by ball pivoting: exact, and the same for points in any order.
 *
 *     import { load } from "rbpa/space";
 *     const rbpa = await load();
 *     const { triangles } = rbpa.surface(points, 0.2);
 */

/** Points as [x, y, z] each, or as numbers x0, y0, z0, x1, …; a typed array is fastest. */
export type Points = ArrayLike<readonly number[]> | ArrayLike<number>;

/** A value that is not what was expected; the message says which. */
export class InvalidInput extends Error {}

export interface Surface {
  /** Three corners each, counter-clockwise seen from outside, the least first; in lexicographic order. */
  triangles: Uint32Array;
  /** Number 3 t + k is the triangle to which the ball rolls over the side across from corner k of triangle t, or -1. */
  neighbors: Int32Array;
}

export interface RbpaInSpace {
  /** The triangles on which a ball of the radius rests, outside as normals say, which are vectors of any length; without them they are estimated. Throws
   * InvalidInput, and RangeError where memory does not suffice. */
  surface(points: Points, radius: number, normals?: Points | null): Surface;
  /** How much memory the instance has. */
  readonly memoryBytes: number;
}

/** A new instance, which works from then on without waiting. Nothing has to be freed. */
export function load(): Promise<RbpaInSpace>;
export default load;
