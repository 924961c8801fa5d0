// What: computes the shape at a step as polygons with holes, one for each solid component, ordered as in `rbpa shape`.
// How:  docs/explanation/plane.md, Outlines as polygons. Points are numbered in lexicographic order: comparing two
//       points means comparing their numbers.
"use strict";

/** Returns the double as a multiple of 2⁻¹⁰⁷⁴. */
function wholeNumberOf(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  const bits = view.getBigUint64(0);
  const exponent = (bits >> 52n) & 0x7ffn;
  const fraction = bits & 0xfffffffffffffn;
  const magnitude = exponent === 0n ? fraction : (fraction | 0x10000000000000n) << (exponent - 1n);
  return bits >> 63n === 1n ? -magnitude : magnitude;
}

/** Returns a number > 0 if the points a, b, c run counter-clockwise, < 0 if clockwise, 0 if they are on a line. The
 *  sign is exact. */
function orientation(points, a, b, c) {
  const left = (points[2 * b] - points[2 * a]) * (points[2 * c + 1] - points[2 * a + 1]);
  const right = (points[2 * b + 1] - points[2 * a + 1]) * (points[2 * c] - points[2 * a]);
  const size = Math.abs(left) + Math.abs(right);
  // Use Shewchuk's bound. Leave products near the ends of the range of double to whole numbers.
  if (size > 1e-290 && size < 1e300 && Math.abs(left - right) > 4e-16 * size) return left - right;
  const [ax, ay, bx, by, cx, cy] = [a, b, c].flatMap((p) => [points[2 * p], points[2 * p + 1]]).map(wholeNumberOf);
  const exact = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  return exact > 0n ? 1 : exact < 0n ? -1 : 0;
}

/** Returns the boundary side after `side`, within one fan of triangles. */
function nextBoundarySide(complex, side, count) {
  let next = nextSide(side);
  while (!complex.isBoundary(next, count)) next = nextSide(complex.twin[next]);
  return next;
}

/** Splits a closed curve that passes points several times into rings that pass each point once. Adds them to `rings`.
 *  */
function splitIntoRings(curve, place, rings) {
  const walked = [];
  for (const p of curve) {
    if (place[p] >= 0) {
      const ring = walked.splice(place[p]);
      for (const q of ring) place[q] = -1;
      rings.push(ring);
    }
    place[p] = walked.length;
    walked.push(p);
  }
  for (const q of walked) place[q] = -1;
  rings.push(walked);
}

/** Rotates a ring so that its lowest index is first. */
function fromLeastPoint(ring) {
  let least = 0;
  for (let i = 1; i < ring.length; ++i) if (ring[i] < ring[least]) least = i;
  return ring.slice(least).concat(ring.slice(0, least));
}

const byFirstPoints = (a, b) => a[0] - b[0] || a[1] - b[1];

/** Returns the signed area, rounded; positive if the ring runs counter-clockwise. */
function ringArea(points, ring) {
  const x = points[2 * ring[0]], y = points[2 * ring[0] + 1];
  let twice = 0;
  for (let i = 1; i + 1 < ring.length; ++i) {
    const p = 2 * ring[i], q = 2 * ring[i + 1];
    twice += (points[p] - x) * (points[q + 1] - y) - (points[p + 1] - y) * (points[q] - x);
  }
  return twice / 2;
}

function ringLength(points, ring) {
  let length = 0;
  for (let i = 0; i < ring.length; ++i) {
    const p = 2 * ring[i], q = 2 * ring[(i + 1) % ring.length];
    length += Math.hypot(points[q] - points[p], points[q + 1] - points[p + 1]);
  }
  return length;
}

function polygonOf(points, rings) {
  const sorted = rings.map(fromLeastPoint).sort(byFirstPoints);
  const shell = sorted.findIndex((ring) => orientation(points, ring[ring.length - 1], ring[0], ring[1]) > 0);
  const holes = sorted.filter((_, i) => i !== shell);
  const sum = (measure) => sorted.reduce((total, ring) => total + measure(points, ring), 0);
  return { shell: sorted[shell], holes, area: sum(ringArea), perimeter: sum(ringLength) };
}

/** Returns the polygons of the first `count` triangles, each with the number of its solid component. Rings are lists of
 *  point numbers. */
function polygonsAt(complex, count) {
  const { label, components } = complex.solidComponents(count);
  const rings = Array.from({ length: components }, () => []);
  const walked = new Uint8Array(3 * count);
  const place = new Int32Array(complex.pointCount).fill(-1);
  for (let first = 0; first < 3 * count; ++first) {
    if (walked[first] || !complex.isBoundary(first, count)) continue;
    const curve = [];
    let side = first;
    do {
      walked[side] = 1;
      curve.push(complex.triangles[side]);
      side = nextBoundarySide(complex, side, count);
    } while (side !== first);
    splitIntoRings(curve, place, rings[label[triangleOf(first)]]);
  }
  return rings.map((of, component) => ({ ...polygonOf(complex.data.points, of), component })).sort((a, b) => byFirstPoints(a.shell, b.shell));
}
