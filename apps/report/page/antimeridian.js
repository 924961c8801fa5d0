// What: cuts polygons at longitude 180, as GeoJSON demands (RFC 7946, 3.1.9) and as `rbpa shape` does.
// How:  each triangle across the line is split there. The polygons of the triangles on either side are the parts.
// Law:  all longitudes of the parts are from -180 to 180. A point keeps its longitude, or changes it by exactly 360.
"use strict";

/** Returns the corners of the part of a convex polygon on one side (−1: left, 1: right) of the vertical line at `x`; no
 *  corners if that part has no area. Both triangles at an edge get the same number for its crossing. */
function cornersBeside(corners, x, side) {
  const kept = corners.flatMap((from, k) => {
    const to = corners[(k + 1) % corners.length];
    const own = side * (from[0] - x) >= 0 ? [from] : [];
    if (Math.sign(from[0] - x) * Math.sign(to[0] - x) >= 0) return own;
    const [p, q] = from[0] < to[0] ? [from, to] : [to, from];
    return [...own, [x, p[1] + (q[1] - p[1]) * ((x - p[0]) / (q[0] - p[0]))]];
  });
  return kept.length > 2 ? kept : [];
}

/** Returns the polygons of triangles whose corners are positions. A polygon is a list of rings, a ring a list of
 *  positions; positions within a straight piece on one of the vertical lines at `lines` are left out. */
function polygonsOfTriangles(triangles, lines) {
  const corners = new Map(triangles.flat().map((p) => [String(p), p]));
  const sorted = [...corners.values()].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const number = new Map(sorted.map((p, i) => [String(p), i]));
  const rows = triangles.map((t) => t.map((p) => number.get(String(p)))).filter((row) => new Set(row).size === 3);
  const complex = new Complex({ points: sorted.flat(), triangles: Uint32Array.from(rows.flat()), radii: [] });
  const isOn = (x) => (p) => sorted[p][0] === x;
  const isCorner = (p, i, ring) => !lines.some((x) => [ring.at(i - 1), p, ring[(i + 1) % ring.length]].every(isOn(x)));
  const positions = (ring) => ring.filter(isCorner).map((p) => sorted[p]);
  return polygonsAt(complex, rows.length).map(({ shell, holes }) => [shell, ...holes].map(positions));
}

/** Returns a function that splits a polygon of the first `count` triangles into parts. A part is a list of rings, a
 *  ring a list of positions. With `cuts`, points are longitudes and latitudes, longitudes within ±360, and parts are
 *  within ±180; otherwise the polygon is its only part. */
function splitterOf(complex, count, cuts) {
  const { points } = complex.data;
  const { label } = complex.solidComponents(count);
  const at = (p) => [points[2 * p], points[2 * p + 1]];
  const trianglesOf = (component) =>
    [...label.keys()].filter((t) => label[t] === component).map((t) => [...complex.triangles.subarray(3 * t, 3 * t + 3)].map(at));
  const splitAt = (x) => (triangles) =>
    [-1, 1].map((side) =>
      triangles.flatMap((t) => {
        const [first, ...others] = cornersBeside(t, x, side);
        return others.slice(1).map((p, i) => [first, others[i], p]);
      }),
    );
  return ({ shell, holes, component }) => {
    const rings = [shell, ...holes].map((ring) => ring.map(at));
    if (!cuts) return [rings];
    const lines = [-180, 180].filter((x) => rings[0].some((p) => p[0] < x) && rings[0].some((p) => p[0] > x));
    const sides = () => lines.reduce((all, x) => all.flatMap(splitAt(x)), [trianglesOf(component)]);
    const parts = lines.length === 0 ? [rings] : sides().flatMap((triangles) => polygonsOfTriangles(triangles, lines));
    return parts.map((part) => {
      const shift = part[0].some(([x]) => x > 180) ? -360 : part[0].some(([x]) => x < -180) ? 360 : 0;
      return part.map((ring) => ring.map(([x, y]) => [x + shift, y]));
    });
  };
}
