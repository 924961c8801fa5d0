/** Surfaces of points in space, by ball pivoting; the result is exact and does not depend on the order of the points.
 *
 *     import { load } from "rbpa/space";
 *     const rbpa = await load();
 *     const { triangles } = rbpa.surface(points, 0.2);
 */

/** Points, each as [x, y, z], or numbers x0, y0, z0, x1, …; a typed array is fastest. */
export type Points = ArrayLike<readonly number[]> | ArrayLike<number>;

/** Thrown for an invalid argument, which the message names. */
export class InvalidInput extends Error {}

export interface Surface {
  /** Three corners per triangle, counter-clockwise seen from outside, the least index first; triangles are in
   * lexicographic order. */
  triangles: Uint32Array;
  /** Number 3 t + k is the triangle to which the ball rolls over the side opposite to corner k of triangle t, or -1. */
  neighbors: Int32Array;
}

export interface RbpaInSpace {
  /** Returns the triangles on which a ball of that radius rests, outside as the normals point. Normals are vectors
   * of any length but 0; they are estimated if not given. Throws InvalidInput, and RangeError if memory does not
   * suffice. */
  surface(points: Points, radius: number, normals?: Points | null): Surface;
  /** Size of the instance's memory in bytes. */
  readonly memoryBytes: number;
}

/** Returns a new instance, whose functions are synchronous. Nothing has to be freed. */
export function load(): Promise<RbpaInSpace>;
export default load;
