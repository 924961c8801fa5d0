// Surfaces of points in space. Types and documentation: space.d.ts.

/** Returns a new instance. Its memory grows as needed, and is freed with the instance. */
export async function load() {
  return new RbpaInSpace(new Module(await instance()));
}
export default load;

class RbpaInSpace {
  #module;
  constructor(module) {
    this.#module = module;
  }

  get memoryBytes() {
    return this.#module.memoryBytes;
  }

  surface(points, radius, normals = null) {
    check(radius, "radius", (r) => r > 0 && r < Infinity, "a number above 0");
    const input = [flat(points, 3, "points"), normals === null ? null : flat(normals, 3, "normals")];
    const count = input[0].length / 3;
    if (normals !== null && input[1].length !== input[0].length)
      throw new InvalidInput(`normals: found ${input[1].length / 3}, expected one for each point, ${count}`);
    return this.#module.call("rbpa_surface", input, count, [radius], (made) => ({
      triangles: made.indices(0),
      neighbors: made.integers(1),
    }));
  }
}
