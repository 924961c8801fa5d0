// The installed package rbpa: surfaces in space.
import assert from "node:assert/strict";
import { test } from "node:test";
import { InvalidInput, load } from "rbpa/space";

const rbpa = await load();

function sphere(count) {
  return Array.from({ length: count }, (_, i) => {
    const z = (2 * i + 1) / count - 1, r = Math.sqrt(1 - z * z);
    return [r * Math.cos(2.4 * i), r * Math.sin(2.4 * i), z];
  });
}

test("a sphere is closed, with normals and without", () => {
  const points = sphere(2000);
  for (const normals of [null, points, points.flat()]) {
    const { triangles, neighbors } = rbpa.surface(points, 0.2, normals);
    assert.equal(triangles.length / 3, 3996);  // 2 n − 4
    assert.ok(neighbors.every((n) => n >= 0 && n < 3996));
    let volume = 0;
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => points[triangles[t + k]]);
      volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    assert.ok(Math.abs(volume / 6 - (4 / 3) * Math.PI) < 0.02);
  }
});

test("opposite normals give the surface seen from inside", () => {
  const points = sphere(500);
  const inside = rbpa.surface(points, 0.4, points.map((p) => p.map((x) => -x)));
  const outside = rbpa.surface(points, 0.4, points);
  assert.equal(inside.triangles.length, outside.triangles.length);
  assert.notDeepEqual(inside.triangles, outside.triangles);
});

test("invalid input is refused", () => {
  const refused = (call, message) => assert.throws(call, (e) => e instanceof InvalidInput && message.test(e.message));
  for (const radius of [0, -1, NaN, Infinity, "1", undefined]) refused(() => rbpa.surface([], radius), /^radius: found/);
  refused(() => rbpa.surface([[0, 0, 0]], 1, [[0, 0, 1], [0, 0, 1]]), /normals: found 2, expected one for each point, 1/);
  refused(() => rbpa.surface([[0, 0, 0]], 1, [[0, 0, 0]]), /normal 0/);
  refused(() => rbpa.surface([0, 0], 1), /points: found 2 numbers, expected 3 for each point/);
  assert.equal(rbpa.surface([], 1).triangles.length, 0);
});
