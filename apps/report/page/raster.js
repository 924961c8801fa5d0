// What: finds the triangle under each pixel, once for a view. The picture at any step is then one pass over the pixels,
//       whatever the number of triangles: a pixel is in the shape if the number of its triangle is small enough.
// Law:  a pixel belongs to the triangle that contains its center; where triangles meet, to one of them.
"use strict";

const noTriangle = 0xffffffff;

class Raster {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.triangle = new Uint32Array(width * height);
    // The largest 1 + firstAt[p] of the points p whose dots cover the pixel, 0 if no dot does. The value exceeds the
    // number of triangles of a step if one of these points is isolated at the step.
    this.dot = new Uint32Array(width * height);
  }

  /** Finds the triangles and dots under the pixels. `x` and `y` are the positions of all points, in pixels. */
  lay(complex, x, y, dotRadius) {
    this.triangle.fill(noTriangle);
    this.dot.fill(0);
    const { triangles, size } = complex;
    for (let t = 0; t < size; ++t) {
      const a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
      this.layTriangle(t, x[a], y[a], x[b], y[b], x[c], y[c]);
    }
    for (let p = 0; p < x.length; ++p) this.layDot(complex.firstAt[p] + 1, x[p], y[p], dotRadius);
  }

  layTriangle(t, ax, ay, bx, by, cx, cy) {
    const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
    const bottom = Math.min(this.height, Math.ceil(Math.max(ay, by, cy) - 0.5));
    if (!(top < bottom)) return;
    // Skip triangles between the centers of two columns, which cover no pixel.
    const left = Math.min(ax, bx, cx), right = Math.max(ax, bx, cx);
    if (!(Math.ceil(left - 0.5) < Math.ceil(right - 0.5)) || right < 0 || left > this.width) return;
    for (let row = top; row < bottom; ++row) {
      const y = row + 0.5;
      let first = Infinity, last = -Infinity;
      if (ay <= y !== by <= y) {
        const at = crossing(ax, ay, bx, by, y);
        first = at;
        last = at;
      }
      if (by <= y !== cy <= y) {
        const at = crossing(bx, by, cx, cy, y);
        if (at < first) first = at;
        if (at > last) last = at;
      }
      if (cy <= y !== ay <= y) {
        const at = crossing(cx, cy, ax, ay, y);
        if (at < first) first = at;
        if (at > last) last = at;
      }
      const end = row * this.width + Math.min(this.width, Math.ceil(last - 0.5));
      for (let i = row * this.width + Math.max(0, Math.ceil(first - 0.5)); i < end; ++i) this.triangle[i] = t;
    }
  }

  layDot(value, x, y, radius) {
    const column = Math.floor(x), row = Math.floor(y);
    const left = Math.max(0, column - radius), right = Math.min(this.width - 1, column + radius);
    const top = Math.max(0, row - radius), bottom = Math.min(this.height - 1, row + radius);
    for (let r = top; r <= bottom; ++r)
      for (let i = r * this.width + left; i <= r * this.width + right; ++i)
        if (this.dot[i] < value) this.dot[i] = value;
  }

  /** Returns the triangle under a pixel, or −1. */
  at(column, row) {
    if (column < 0 || row < 0 || column >= this.width || row >= this.height) return -1;
    const t = this.triangle[row * this.width + column];
    return t === noTriangle ? -1 : t;
  }

  /** Sets `pixels`, one element for each pixel, to the given colors. Marked triangles are lit, whether present or not.
   *  */
  paint(pixels, count, marked, colors, { outline, dots }) {
    const { width, height, triangle, dot } = this;
    const { paper, fill, line, isolated, lit, litGap } = colors;
    for (let row = 0, i = 0; row < height; ++row) {
      for (let column = 0; column < width; ++column, ++i) {
        const t = triangle[i];
        const inside = t < count;
        let color = inside ? fill : paper;
        if (marked !== null && t !== noTriangle && marked[t] === 1) color = inside ? lit : litGap;
        if (outline) {
          const right = column + 1 < width ? triangle[i + 1] < count : inside;
          const below = row + 1 < height ? triangle[i + width] < count : inside;
          if (inside !== right || inside !== below) color = line;
        }
        if (dots && dot[i] > count) color = isolated;
        pixels[i] = color;
      }
    }
  }
}

/** Returns the x at height y of the side from a to b. The bits do not depend on the direction of the side. */
function crossing(ax, ay, bx, by, y) {
  return ay < by ? ax + (y - ay) * ((bx - ax) / (by - ay)) : bx + (y - by) * ((ax - bx) / (ay - by));
}
