// What: provides the complex at every step, with the neighbors of triangles and the connected components.
// Law:  triangles are in the order in which they appear: the first `count` triangles are the complex of a step.
"use strict";

/** Return the triangle of a side, and the next side of that triangle. */
const triangleOf = (side) => (side / 3) | 0;
const nextSide = (side) => (side % 3 === 2 ? side - 2 : side + 1);

class Complex {
  constructor(data) {
    this.data = data;
    this.triangles = data.triangles;
    this.size = data.triangles.length / 3;
    this.steps = data.radii.length;
    this.pointCount = data.points.length / 2;
    this.listSidesAtPoints();
    this.findTwins();
    this.findFirstTriangles();
  }

  /** Sets `begin` and `sides`: the sides that begin at point p are sides[begin[p]] to sides[begin[p + 1] - 1]. */
  listSidesAtPoints() {
    const { triangles, pointCount } = this;
    const begin = new Uint32Array(pointCount + 1);
    for (const p of triangles) ++begin[p + 1];
    for (let p = 0; p < pointCount; ++p) begin[p + 1] += begin[p];
    const sides = new Uint32Array(triangles.length);
    const next = begin.slice();
    for (let side = 0; side < triangles.length; ++side) sides[next[triangles[side]]++] = side;
    this.begin = begin;
    this.sides = sides;
  }

  /** Sets `twin`: for each side the opposite side of the triangle across, or −1. */
  findTwins() {
    const { triangles, begin, sides } = this;
    const twin = new Int32Array(triangles.length).fill(-1);
    for (let side = 0; side < triangles.length; ++side) {
      if (twin[side] >= 0) continue;
      const from = triangles[side], to = triangles[nextSide(side)];
      for (let i = begin[to]; i < begin[to + 1]; ++i) {
        if (triangles[nextSide(sides[i])] !== from) continue;
        twin[side] = sides[i];
        twin[sides[i]] = side;
        break;
      }
    }
    this.twin = twin;
  }

  /** Sets `firstAt`: the first triangle of each point; `size` if the point has no triangle. */
  findFirstTriangles() {
    this.firstAt = new Uint32Array(this.pointCount).fill(this.size);
    for (let side = this.triangles.length - 1; side >= 0; --side) this.firstAt[this.triangles[side]] = triangleOf(side);
  }

  /** Returns the diagonal of the box of all points: a circle of this radius looks straight along any part of the set.
   *  */
  reach() {
    const { points } = this.data;
    let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
    for (let i = 0; i < points.length; i += 2) {
      left = Math.min(left, points[i]);
      right = Math.max(right, points[i]);
      bottom = Math.min(bottom, points[i + 1]);
      top = Math.max(top, points[i + 1]);
    }
    return Math.hypot(right - left, top - bottom);
  }

  /** Returns the last step whose radius is at most alpha; −1 if the first radius is larger. */
  stepAt(alpha) {
    return lastAtMost(this.data.radii, alpha);
  }

  /** Returns the number of triangles at a step. */
  countAt(step) {
    return step < 0 ? 0 : this.data.counts.triangles[step];
  }

  /** Returns the corners of the triangles of a step, with repetitions. */
  cornersAt(step) {
    return this.triangles.subarray(0, 3 * this.countAt(step));
  }

  /** Returns the counts of a step, named like those of `rbpa alpha --json`. */
  numbersAt(step) {
    const { counts, areas, radii } = this.data;
    const isolated = this.pointCount - (step < 0 ? 0 : counts.covered[step]);
    const at = (count) => (step < 0 ? 0 : count[step]);
    return {
      alpha: step < 0 ? 0 : radii[step],
      triangles: at(counts.triangles),
      solidComponents: at(counts.solidComponents),
      components: at(counts.components),
      holes: at(counts.holes),
      covered: at(counts.covered),
      isolated,
      area: at(areas),
    };
  }

  /** Returns whether a side is on the boundary: its triangle is among the first `count`, and the triangle across is
   *  not. */
  isBoundary(side, count) {
    const twin = this.twin[side];
    return side < 3 * count && (twin < 0 || twin >= 3 * count);
  }

  isAlive(pair, step) {
    const { birth, death } = this.data.pairs;
    return birth[pair] <= step && step < death[pair];
  }

  /** Returns the triangles of a pair at a step: of its component, connected through points, or of its hole. Returns
   *  null if the pair is not alive at the step, or has more triangles than `limit`. */
  regionOf(pair, step, limit = Infinity) {
    if (!this.isAlive(pair, step)) return null;
    const { dimension, triangle } = this.data.pairs;
    return dimension[pair] === 0
      ? this.componentAt(triangle[pair], this.countAt(step), limit)
      : this.gapAt(triangle[pair], this.countAt(step), limit);
  }

  /** Returns the pair whose component or hole contains the triangle at a step; −1 for the outside. */
  pairAt(triangle, step) {
    const { pairs } = this.data;
    const inside = triangle < this.countAt(step);
    const count = this.countAt(step);
    const region = new Set(inside ? this.componentAt(triangle, count) : this.gapAt(triangle, count));
    for (let p = 0; p < pairs.count; ++p)
      if (pairs.dimension[p] === (inside ? 0 : 1) && this.isAlive(p, step) && region.has(pairs.triangle[p])) return p;
    return -1;
  }

  componentAt(triangle, count, limit = Infinity) {
    const { triangles, begin, sides } = this;
    const seenTriangle = new Uint8Array(count), seenPoint = new Uint8Array(this.pointCount);
    const region = [triangle];
    seenTriangle[triangle] = 1;
    for (let i = 0; i < region.length; ++i) {
      if (region.length > limit) return null;
      for (let corner = 3 * region[i]; corner < 3 * region[i] + 3; ++corner) {
        const p = triangles[corner];
        if (seenPoint[p]) continue;
        seenPoint[p] = 1;
        for (let j = begin[p]; j < begin[p + 1]; ++j) {
          const t = triangleOf(sides[j]);
          if (t >= count || seenTriangle[t]) continue;
          seenTriangle[t] = 1;
          region.push(t);
        }
      }
    }
    return region;
  }

  /** Returns the missing triangles that are connected to a missing triangle through sides; null if there are more than
   *  `limit`. */
  gapAt(triangle, count, limit = Infinity) {
    const seen = new Uint8Array(this.size - count);
    const region = [triangle];
    seen[triangle - count] = 1;
    for (let i = 0; i < region.length; ++i) {
      if (region.length > limit) return null;
      for (let side = 3 * region[i]; side < 3 * region[i] + 3; ++side) {
        const t = this.twin[side] < 0 ? -1 : triangleOf(this.twin[side]);
        if (t < count || seen[t - count]) continue;
        seen[t - count] = 1;
        region.push(t);
      }
    }
    return region;
  }

  /** Numbers the solid components of the first `count` triangles from 0. Returns the number of each triangle, and the
   *  count. */
  solidComponents(count) {
    const label = new Int32Array(count).fill(-1);
    const stack = [];
    let components = 0;
    for (let first = 0; first < count; ++first) {
      if (label[first] >= 0) continue;
      label[first] = components;
      stack.push(first);
      while (stack.length > 0) {
        const t = stack.pop();
        for (let side = 3 * t; side < 3 * t + 3; ++side) {
          const twin = this.twin[side];
          if (twin < 0 || twin >= 3 * count || label[triangleOf(twin)] >= 0) continue;
          label[triangleOf(twin)] = components;
          stack.push(triangleOf(twin));
        }
      }
      ++components;
    }
    return { label, components };
  }
}
