// Alpha shapes, concave hulls and Delaunay triangulations of points in the plane. Types and documentation: index.d.ts.

/** Returns a new instance. Its memory grows as needed, and is freed with the instance. */
export async function load() {
  return new Rbpa(new Module(await instance()));
}
export default load;

/** Returns [rule, radius]: the rule is null if alpha is a number. Values of other types become texts, which the module
* refuses, as it refuses all texts that are no rule. */
function ruleAndRadius(alpha) {
  if (typeof alpha === "number") return [null, alpha];
  return [typeof alpha === "string" ? alpha : (JSON.stringify(alpha) ?? String(alpha)), Infinity];
}

class Rbpa {
  #module;
  constructor(module) {
    this.#module = module;
    const update = (coords) => this.#delaunator(coords);
    this.Delaunator = class Delaunator {
      static from(points, getX = (p) => p[0], getY = (p) => p[1]) {
        const coords = new Float64Array(2 * points.length);
        for (let i = 0; i < points.length; ++i) {
          coords[2 * i] = getX(points[i]);
          coords[2 * i + 1] = getY(points[i]);
        }
        return new Delaunator(coords);
      }
      constructor(coords) {
        if (coords.length > 1 && typeof coords[0] !== "number") throw new Error("Expected coords to contain numbers.");
        this.coords = coords;
        this.update();
      }
      update() {
        Object.assign(this, update(this.coords));
      }
    };
  }

  get memoryBytes() {
    return this.#module.memoryBytes;
  }

  alphaComplex(points, alpha = Infinity) {
    check(alpha, "alpha", (a) => a > 0, "a radius above 0, or Infinity");
    const coords = flat(points, 2, "points");
    return this.#module.call("rbpa_alpha_complex", [coords], coords.length / 2, [alpha], (made) => triangulation(made, 0));
  }

  alphaShape(points, alpha = "plateau", { minHoleArea = 0, minPartArea = 0 } = {}) {
    const [rule, radius] = ruleAndRadius(alpha);
    check(minHoleArea, "minHoleArea", (area) => area >= 0, "an area");
    check(minPartArea, "minPartArea", (area) => area >= 0, "an area");
    const coords = flat(points, 2, "points");
    const numbers = [radius, minHoleArea, minPartArea];
    return this.#module.call("rbpa_alpha_shape", [coords, rule], coords.length / 2, numbers, (made) => {
      const [chosen] = made.doubles(0);
      const [area, perimeter] = made.doubles(12);
      return new AlphaShape(coords, {
        alpha: chosen > 0 ? chosen : null,
        ...triangulation(made, 1),
        polygons: polygons(made, 7),
        area,
        perimeter,
      });
    });
  }

  concaveHull(points, alpha = "auto") {
    const shape = this.alphaShape(points, alpha, { minHoleArea: Infinity });
    let largest;
    for (const polygon of shape.polygons) if (!largest || polygon.area > largest.area) largest = polygon;
    if (!largest) return [];
    const given = typeof points[0] === "number" ? (i) => [points[2 * i], points[2 * i + 1]] : (i) => points[i];
    const ring = Array.from(largest.shell, given).reverse();
    return [...ring, ring[0]];
  }

  filtration(points) {
    const coords = flat(points, 2, "points");
    return this.#module.call("rbpa_filtration", [coords], coords.length / 2, [], (made) => {
      const [auto, min] = made.doubles(7);
      return {
        alpha: made.doubles(0),
        triangles: made.indices(1),
        solidComponents: made.indices(2),
        components: made.indices(3),
        holes: made.indices(4),
        covered: made.indices(5),
        area: made.doubles(6),
        auto: auto > 0 ? auto : null,
        min: min > 0 ? min : null,
        plateaus: plateaus(made.doubles(8)),
      };
    });
  }

  #delaunator(coords) {
    const even = coords.length % 2 === 0 ? coords : coords.slice(0, -1);
    return this.#module.call("rbpa_delaunator", [even], even.length / 2, [], (made) => {
      const triangles = made.indices(0);
      const hull = hullOf(made.indices(2), coords);
      return { triangles, halfedges: made.integers(1), trianglesLen: triangles.length, hull };
    });
  }
}

class AlphaShape {
  #coords;
  constructor(coords, made) {
    this.#coords = coords;
    Object.assign(this, made);
  }
  toGeoJSON() {
    const position = (i) => [this.#coords[2 * i], this.#coords[2 * i + 1]];
    const closed = (ring) => [...Array.from(ring, position), position(ring[0])];
    return {
      type: "MultiPolygon",
      coordinates: this.polygons.map(({ shell, holes }) => [closed(shell), ...holes.map(closed)]),
    };
  }
}

function triangulation(made, first) {
  return {
    halfedges: made.integers(first),
    triangles: made.indices(first + 1),
    neighbors: made.integers(first + 2),
    boundary: made.indices(first + 3),
    isolated: made.indices(first + 4),
    duplicates: made.indices(first + 5),
  };
}

function polygons(made, first) {
  const [firstRing, firstPoint, points] = [made.indices(first), made.indices(first + 1), made.indices(first + 2)];
  const [area, perimeter] = [made.doubles(first + 3), made.doubles(first + 4)];
  const ring = (i) => points.slice(firstPoint[i], firstPoint[i + 1]);
  return Array.from(area, (_, p) => {
    const holes = [];
    for (let i = firstRing[p] + 1; i < firstRing[p + 1]; ++i) holes.push(ring(i));
    return { shell: ring(firstRing[p]), holes, area: area[p], perimeter: perimeter[p] };
  });
}

function plateaus(numbers) {
  return Array.from({ length: numbers.length / 6 }, (_, i) => {
    const [from, to, ratio, alpha, structured, long] = numbers.subarray(6 * i, 6 * i + 6);
    return { from, to, ratio, alpha, kind: structured ? "structured" : "one piece", isLong: long !== 0 };
  });
}

/** Returns the points of the hull in Delaunator's order: against the direction of the sides. If there are no sides, as
* all points are on one line, returns the distinct points in their order on the line. */
function hullOf(sides, coords) {
  if (sides.length === 0) {
    const all = Uint32Array.from({ length: coords.length >> 1 }, (_, i) => i);
    const compare = (i, j) => coords[2 * i] - coords[2 * j] || coords[2 * i + 1] - coords[2 * j + 1];
    return all.sort(compare).filter((i, k, sorted) => k === 0 || compare(sorted[k - 1], i) !== 0);
  }
  const before = new Map();
  for (let i = 0; i < sides.length; i += 2) before.set(sides[i + 1], sides[i]);
  const hull = new Uint32Array(sides.length / 2);
  for (let i = 0, at = sides[0]; i < hull.length; ++i, at = before.get(at)) hull[i] = at;
  return hull;
}
