// The installed package rbpa: the plane.
import assert from "node:assert/strict";
import { test } from "node:test";
import { InvalidInput, load } from "rbpa";

const rbpa = await load();

/** Returns pseudorandom numbers in [0, 1) of a fixed sequence. */
function numbers(count, seed = 1) {
  let state = seed;
  return Float64Array.from({ length: count }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  });
}

const double = (coords, a, b, c) =>
  (coords[2 * b] - coords[2 * a]) * (coords[2 * c + 1] - coords[2 * a + 1]) -
  (coords[2 * c] - coords[2 * a]) * (coords[2 * b + 1] - coords[2 * a + 1]);

function checkHalfedges({ triangles, halfedges }, coords, sign) {
  assert.equal(halfedges.length, triangles.length);
  const next = (e) => (e % 3 === 2 ? e - 2 : e + 1);
  for (let t = 0; t < triangles.length; t += 3)
    assert.ok(sign * double(coords, triangles[t], triangles[t + 1], triangles[t + 2]) > 0);
  for (let e = 0; e < halfedges.length; ++e) {
    const twin = halfedges[e];
    if (twin < 0) continue;
    assert.equal(halfedges[twin], e);
    assert.equal(triangles[twin], triangles[next(e)]);
    assert.equal(triangles[next(twin)], triangles[e]);
  }
}

test("triangles, neighbors and halfedges are consistent", () => {
  for (const count of [0, 1, 2, 3, 4, 50, 20000]) {
    const coords = numbers(2 * count);
    for (const alpha of [Infinity, 0.01, 0.2]) {
      const made = rbpa.alphaComplex(coords, alpha);
      checkHalfedges(made, coords, 1);
      assert.equal(made.boundary.length, 2 * made.halfedges.filter((e) => e < 0).length);
      for (let s = 0; s < made.halfedges.length; ++s) {
        const beyond = made.neighbors[s - (s % 3) + ((s % 3) + 2) % 3];
        assert.equal(made.halfedges[s] < 0 ? -1 : Math.floor(made.halfedges[s] / 3), beyond);
      }
      const seen = new Set([...made.triangles, ...made.isolated]);
      assert.equal(seen.size, count);
    }
  }
});

test("points may be numbers, pairs or typed arrays; their order does not matter", () => {
  const coords = numbers(2000);
  const pairs = Array.from({ length: 1000 }, (_, i) => [coords[2 * i], coords[2 * i + 1]]);
  const expected = rbpa.alphaComplex(coords, 0.05);
  for (const points of [pairs, Array.from(coords), pairs.map((p) => Float64Array.from(p))])
    assert.deepEqual(rbpa.alphaComplex(points, 0.05), expected);
  const reversed = rbpa.alphaComplex([...pairs].reverse(), 0.05);
  const rows = ({ triangles }, index) => {
    const all = [];
    for (let t = 0; t < triangles.length; t += 3)
      all.push([...triangles.slice(t, t + 3)].map(index).sort((a, b) => a - b).join());
    return all.sort();
  };
  assert.deepEqual(rows(reversed, (i) => 999 - i), rows(expected, (i) => i));
});

test("the class Delaunator has the members of the package delaunator", () => {
  const square = new rbpa.Delaunator([0, 0, 4, 0, 4, 4, 0, 4, 2, 1]);
  checkHalfedges(square, square.coords, -1);  // clockwise if y points up
  assert.equal(square.trianglesLen, 12);
  assert.deepEqual([...square.hull].sort(), [0, 1, 2, 3]);
  const at = square.hull.indexOf(3);
  assert.deepEqual([0, 1, 2, 3].map((i) => square.hull[(at + i) % 4]), [3, 2, 1, 0]);
  const from = rbpa.Delaunator.from([{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }], (p) => p.x, (p) => p.y);
  assert.equal(from.triangles.length, 3);
  from.coords[2] = 0;
  from.coords[3] = 2;
  from.update();
  assert.equal(from.triangles.length, 0);  // on a line
  assert.deepEqual([...new rbpa.Delaunator([0, 0, 2, 2, 1, 1, 0, 0]).hull], [0, 2, 1]);
  assert.deepEqual([...new rbpa.Delaunator([]).hull], []);
  const many = numbers(60000, 7);
  const delaunator = new rbpa.Delaunator(many);
  checkHalfedges(delaunator, many, -1);
  assert.equal(delaunator.triangles.length / 3, 2 * 30000 - 2 - delaunator.hull.length);
  assert.throws(() => new rbpa.Delaunator([[0, 0], [1, 1]]), /Expected coords to contain numbers/);
});

test("an alpha shape has polygons with holes", () => {
  const grid = [];
  for (let x = 0; x < 6; ++x)
    for (let y = 0; y < 6; ++y) if (x < 2 || x > 3 || y < 2 || y > 3) grid.push([x, y]);
  grid.push([20, 20]);
  const shape = rbpa.alphaShape(grid, 0.8);
  assert.equal(shape.alpha, 0.8);
  assert.equal(shape.polygons.length, 1);
  assert.equal(shape.polygons[0].holes.length, 1);
  assert.equal(shape.area, 18);
  assert.ok(Math.abs(shape.perimeter - (24 + 4 * Math.SQRT2)) < 1e-12);
  assert.deepEqual([...shape.isolated], [grid.length - 1]);
  assert.equal(rbpa.alphaShape(grid, 0.8, { minHoleArea: 100 }).area, 25);
  assert.equal(rbpa.alphaShape(grid, 0.8, { minPartArea: 100 }).polygons.length, 0);
  const geojson = shape.toGeoJSON();
  assert.equal(geojson.type, "MultiPolygon");
  assert.equal(geojson.coordinates[0].length, 2);
  for (const ring of geojson.coordinates[0]) assert.deepEqual(ring[0], ring.at(-1));
});

test("rules choose the alpha that the filtration names", () => {
  const coords = numbers(4000, 3).map((x, i) => x + (i < 2000 ? 0 : 3));  // two squares
  const filtration = rbpa.filtration(coords);
  for (const rule of ["auto", "min"]) assert.equal(rbpa.alphaShape(coords, rule).alpha, filtration[rule]);
  assert.equal(rbpa.alphaShape(coords, "plateau").alpha, filtration.plateaus[0].alpha);
  assert.equal(rbpa.alphaShape(coords, "plateau:2").alpha, filtration.plateaus[1].alpha);
  assert.equal(rbpa.alphaShape(coords).alpha, filtration.plateaus[0].alpha);
  assert.deepEqual(rbpa.concaveHull(coords), rbpa.concaveHull(coords, "auto"));
  const auto = rbpa.alphaShape(coords, "auto");
  assert.equal(auto.alpha, filtration.auto);
  assert.equal(auto.polygons.length, 1);
  const step = filtration.alpha.indexOf(auto.alpha);
  assert.equal(filtration.triangles[step], auto.triangles.length / 3);
  assert.equal(filtration.solidComponents[step], 1);
  assert.equal(filtration.covered[step], 2000);
  assert.ok(Math.abs(filtration.area[step] - auto.area) < 1e-12);
  assert.throws(() => rbpa.alphaShape(coords, "plateau:999999"), /^InvalidInput: alpha plateau:999999: there are only \d plateaus$/);
  for (const none of [[], [[1, 2]], [[0, 0], [1, 1]], [[0, 0], [1, 1], [2, 2]], [[0, 0], [1, 0], [1, 0]]]) {
    const line = rbpa.alphaShape(none);
    assert.equal(line.alpha, null);
    assert.equal(line.polygons.length, 0);
  }
  assert.equal(rbpa.alphaShape([[0, 0], [1, 0], [0, 1]]).area, 0.5);
  assert.equal(rbpa.alphaShape([[0, 0], [1, 0], [0, 1], [1, 1]]).area, 1);
  assert.deepEqual([rbpa.filtration([]).auto, rbpa.filtration([]).plateaus.length], [null, 0]);
});

test("a concave hull is a closed ring of the given points", () => {
  const points = [[0, 0, "a"], [4, 0, "b"], [4, 4, "c"], [2, 3, "d"], [0, 4, "e"]];
  const ring = rbpa.concaveHull(points);
  assert.deepEqual(ring.map((p) => p[2]).join(""), "edcbae");
  assert.equal(ring[0], points[4]);
  assert.deepEqual(rbpa.concaveHull(points.flatMap(([x, y]) => [x, y])), ring.map(([x, y]) => [x, y]));
  assert.deepEqual(rbpa.concaveHull([[0, 0], [1, 1]]), []);
  assert.equal(rbpa.concaveHull(points, Infinity).length, 5);
});

test("invalid input is refused with what was found and what was expected", () => {
  const refused = (call, message) => assert.throws(call, (e) => e instanceof InvalidInput && message.test(e.message));
  refused(() => rbpa.alphaComplex([[0, NaN]]), /point 0 is \(0, NaN\), expected finite coordinates/);
  refused(() => rbpa.alphaComplex([0, 1, Infinity, 0.5]), /point 1 is \(Infinity, 0.5\)/);
  refused(() => rbpa.alphaComplex([0, 1, 2]), /points: found 3 numbers, expected 2 for each point/);
  refused(() => rbpa.alphaComplex(null), /points: found null/);
  refused(() => rbpa.alphaComplex([[0, 0], "x"]), /found "x" at 1/);
  refused(() => rbpa.alphaComplex([[0, 0], null]), /found null at 1/);
  for (const alpha of [0, -1, NaN, "1", null]) refused(() => rbpa.alphaComplex([], alpha), /^alpha: found/);
  for (const alpha of [0, -1, NaN]) refused(() => rbpa.alphaShape([], alpha), /^alpha is .*expected a radius above 0/);
  for (const alpha of ["best", "", "1", "plateau:0", "plateau:", null, {}, ["auto"]])
    refused(() => rbpa.alphaShape([], alpha), /^alpha: found '.*', expected a radius .*, auto, min, plateau or plateau:K$/);
  refused(() => rbpa.alphaShape([], 1, { minHoleArea: -1 }), /^minHoleArea: found -1/);
  assert.equal(rbpa.alphaComplex([[0, 0], [1, 0], [0, 1]]).triangles.length, 3);  // works after refusals
});

test("nothing leaks in ten thousand calls", async () => {
  const own = await load();
  const coords = numbers(400);
  for (let i = 0; i < 100; ++i) own.alphaShape(coords);
  const before = own.memoryBytes;
  for (let i = 0; i < 10000; ++i) {
    if (i % 3 === 0) own.alphaShape(coords, "plateau");
    else if (i % 3 === 1) new own.Delaunator(coords);
    else
      try {
        own.alphaComplex([0, NaN]);
      } catch {}
  }
  assert.equal(own.memoryBytes, before);
});

test("a million points grow the memory, and views follow it", async () => {
  const own = await load();
  const before = own.memoryBytes;
  const coords = numbers(2_000_000, 5);
  const made = new own.Delaunator(coords);
  assert.ok(own.memoryBytes > before);
  assert.equal(made.triangles.length / 3, 2_000_000 - 2 - made.hull.length);
});

/** Returns twice the area of a closed ring. */
const doubleOf = (ring) =>
  ring.slice(1).reduce((sum, [x, y], k) => sum + ring[k][0] * y - ring[k][1] * x, 0);

test("Voronoi cells tile the box, hold their points, and know their neighbors", () => {
  const coords = numbers(2000, 3);
  const cells = rbpa.voronoi(coords, [0, 0, 1, 1]);
  let area = 0;
  for (const cell of cells.cellPolygons()) {
    area += doubleOf(cell) / 2;
    const [x, y] = [coords[2 * cell.index], coords[2 * cell.index + 1]];
    for (let k = 0; k + 1 < cell.length; ++k)
      assert.ok((cell[k + 1][0] - cell[k][0]) * (y - cell[k][1]) - (cell[k + 1][1] - cell[k][1]) * (x - cell[k][0]) >= 0);
    for (const other of cells.neighbors(cell.index)) assert.ok([...cells.neighbors(other)].includes(cell.index));
    assert.deepEqual(cells.cellPolygon(cell.index), [...cell]);
  }
  assert.ok(Math.abs(area - 1) < 1e-12);
  assert.equal(cells.points.length, 1000);
  const four = rbpa.voronoi([[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]);
  assert.deepEqual(four.cellPolygon(0), [[-0.2, -0.2], [1, -0.2], [1, 1], [-0.2, 1], [-0.2, -0.2]]);
  assert.equal(four.cellPolygon(4), null);
  assert.deepEqual([...four.neighbors(0)].sort(), [1, 3]);
  assert.deepEqual([...rbpa.voronoi([]).cellPolygons()], []);
  assert.throws(() => rbpa.voronoi(coords, [0, 0, 0, 1]), InvalidInput);
  assert.throws(() => rbpa.voronoi([[NaN, 1]]), InvalidInput);
});

test("segments are edges of the constrained triangulation; crossings are refused or split", () => {
  const square = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [3, 1], [3, 3], [1, 3]];
  const rings = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
  const made = rbpa.constrainedDelaunay(square, rings);
  checkHalfedges(made, square.flat(), 1);
  assert.equal(made.triangles.length / 3, 10);
  assert.deepEqual([...made.isInside].sort(), [0, 1]);
  assert.deepEqual([...made.segments], [0, 1, 0, 3, 1, 2, 2, 3, 4, 5, 4, 7, 5, 6, 6, 7]);
  assert.equal(made.constrained.reduce((a, b) => a + b), 4 + 2 * 4);
  const diagonals = [[0, 2], [1, 3]];
  assert.throws(() => rbpa.constrainedDelaunay(square, diagonals), /segment 0 from \(0, 0\) to \(4, 4\) and segment 1/);
  const split = rbpa.constrainedDelaunay(square.slice(0, 4), diagonals, { splitCrossings: true });
  assert.deepEqual([...split.points.slice(8)], [2, 2]);
  assert.deepEqual([...split.crossed], [0, 1]);
  for (const wrong of [[[0, 8]], [[-1, 2]], [[0.5, 1]]])
    assert.throws(() => rbpa.constrainedDelaunay(square, wrong), InvalidInput);
});
