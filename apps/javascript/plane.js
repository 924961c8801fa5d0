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

  voronoi(points, box = null) {
    if (box !== null && !(box.length === 4 && Array.from(box).every(Number.isFinite) && box[0] < box[2] && box[1] < box[3]))
      throw new InvalidInput(`box: found ${JSON.stringify(box)}, expected [least x, least y, greatest x, greatest y]`);
    const coords = flat(points, 2, "points");
    return this.#module.call("rbpa_voronoi", [coords, box], coords.length / 2, [], (made) => {
      return new VoronoiCells(coords.length / 2, made.doubles(0), made.indices(1), polygons(made, 2));
    });
  }

  constrainedDelaunay(points, segments, { splitCrossings = false } = {}) {
    const coords = flat(points, 2, "points");
    const ends = flat(segments, 2, "segments");
    for (let i = 0; i < ends.length; ++i)
      if (!(Number.isInteger(ends[i]) && ends[i] >= 0 && ends[i] < coords.length / 2))
        throw new InvalidInput(`segments: found ${ends[i]} in segment ${i >> 1}, expected an index of ${coords.length / 2} points`);
    const numbers = [ends.length / 2, splitCrossings ? 1 : 0];
    return this.#module.call("rbpa_constrained_delaunay", [coords, ends], coords.length / 2, numbers, (made) => {
      const bits = made.indices(2);
      return {
        points: made.doubles(0),
        crossed: made.indices(1),
        constrained: Uint8Array.from({ length: 3 * bits.length }, (_, s) => (bits[Math.floor(s / 3)] >> s % 3) & 1),
        segments: made.indices(3),
        region: made.indices(4),
        isInside: Uint8Array.from(made.indices(5)),
        halfedges: made.integers(6),
        triangles: made.indices(7),
        neighbors: made.integers(8),
        boundary: made.indices(9),
        duplicates: made.indices(10),
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

class VoronoiCells {
  #of = new Map(); // the polygon of each point that has a cell
  #beyond; // for each side of a polygon, "from to", the point of the cell on its left
  constructor(count, vertices, points, polygons) {
    Object.assign(this, { count, vertices, points, polygons });
    points.forEach((point, i) => this.#of.set(point, polygons[i]));
  }
  cellPolygon(i) {
    const polygon = this.#of.get(i);
    if (!polygon) return null;
    const ring = Array.from(polygon.shell, (v) => [this.vertices[2 * v], this.vertices[2 * v + 1]]);
    return [...ring, ring[0]];
  }
  *cellPolygons() {
    for (let i = 0; i < this.count; ++i) {
      const cell = this.cellPolygon(i);
      if (cell) yield Object.assign(cell, { index: i });
    }
  }
  *neighbors(i) {
    const sides = ({ shell }) => Array.from(shell, (v, k) => [v, shell[(k + 1) % shell.length]]);
    if (!this.#beyond) {
      this.#beyond = new Map();
      this.polygons.forEach((polygon, p) => sides(polygon).forEach(([a, b]) => this.#beyond.set(`${a} ${b}`, this.points[p])));
    }
    const polygon = this.#of.get(i);
    const found = new Set(polygon ? sides(polygon).map(([a, b]) => this.#beyond.get(`${b} ${a}`)) : []);
    found.delete(undefined);
    yield* found;
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
