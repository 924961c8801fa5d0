// What: maps coordinates to pixels and back, by the visible part of the plane and its scale.
// Why:  coordinates may be anything from 10⁻³²⁴ to 10³⁰⁸. They are first moved and scaled to a square of −1 … 1.
"use strict";

class View {
  constructor(points) {
    this.count = points.length / 2;
    this.u = new Float64Array(this.count);
    this.v = new Float64Array(this.count);
    this.x = new Float64Array(this.count);
    this.y = new Float64Array(this.count);
    this.normalize(points);
    Object.assign(this, { width: 1, height: 1 });
    this.fit();
  }

  normalize(points) {
    let size = 0;
    for (const value of points) size = Math.max(size, Math.abs(value));
    const power = size > 2 ** 500 ? 2 ** -600 : 1; // no difference overflows
    let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
    for (let p = 0; p < this.count; ++p) {
      const x = (this.u[p] = points[2 * p] * power), y = (this.v[p] = points[2 * p + 1] * power);
      left = Math.min(left, x);
      right = Math.max(right, x);
      bottom = Math.min(bottom, y);
      top = Math.max(top, y);
    }
    const middleX = (left + right) / 2, middleY = (bottom + top) / 2;
    const half = Math.max(right - left, top - bottom) / 2 || 1;
    this.unit = half / power; // length 1 of the normalized plane, in units of the coordinates
    for (let p = 0; p < this.count; ++p) {
      this.u[p] = (this.u[p] - middleX) / half;
      this.v[p] = (this.v[p] - middleY) / half;
    }
    this.halfWidth = (right - left) / 2 / half;
    this.halfHeight = (top - bottom) / 2 / half;
  }

  /** Adapts to a new size. A fitted view is fitted again. A view that was moved or zoomed keeps its middle, and is
   *  enlarged `by` times. */
  resize(width, height, by = 1) {
    const dx = this.left - this.width / 2, dy = this.top - this.height / 2;
    Object.assign(this, { width, height });
    if (this.fitted) return this.show(this.fitted);
    this.scale *= by;
    this.left = width / 2 + dx * by;
    this.top = height / 2 + dy * by;
  }

  /** Shows the points with a margin; without `points`, shows all. */
  fit(points = []) {
    const all = { left: -this.halfWidth, right: this.halfWidth, bottom: -this.halfHeight, top: this.halfHeight };
    this.show({ ...(points.length === 0 ? all : this.boxOf(points)), share: 0.94 });
  }

  /** Returns the box of points in the normalized plane. */
  boxOf(points) {
    let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
    for (const p of points) {
      left = Math.min(left, this.u[p]);
      right = Math.max(right, this.u[p]);
      bottom = Math.min(bottom, this.v[p]);
      top = Math.max(top, this.v[p]);
    }
    return { left, right, bottom, top };
  }

  /** Shows a box of the normalized plane; the box takes the share `box.share` of the picture. */
  show(box) {
    const { left, right, bottom, top, share } = box;
    this.fitted = box;
    const width = Math.max(right - left, 1e-14), height = Math.max(top - bottom, 1e-14);
    this.scale = share * Math.min(this.width / width, this.height / height);
    this.left = this.width / 2 - (this.scale * (left + right)) / 2;
    this.top = this.height / 2 + (this.scale * (bottom + top)) / 2;
  }

  pan(dx, dy) {
    this.fitted = null;
    this.left += dx;
    this.top += dy;
  }

  /** Zooms. The point at pixel (x, y) keeps its place. */
  zoom(factor, x, y) {
    this.fitted = null;
    const limit = 1e14;
    const by = Math.min(limit, Math.max(0.05 * Math.min(this.width, this.height), this.scale * factor)) / this.scale;
    this.scale *= by;
    this.left = x + (this.left - x) * by;
    this.top = y + (this.top - y) * by;
  }

  /** Computes x and y of every point, in pixels. */
  project() {
    const { u, v, x, y, scale, left, top } = this;
    for (let p = 0; p < this.count; ++p) {
      x[p] = left + scale * u[p];
      y[p] = top - scale * v[p];
    }
  }

  /** Return the length of some pixels in the unit of the coordinates, and the pixels of a length. */
  lengthOf(pixels) {
    return (pixels / this.scale) * this.unit;
  }

  pixelsOf(length) {
    return (length / this.unit) * this.scale;
  }

  /** Returns the distance between neighbors, in pixels, that points spread evenly over their box would have. */
  spacing() {
    return this.scale * Math.sqrt((4 * (this.halfWidth || 1e-3) * (this.halfHeight || 1e-3)) / Math.max(1, this.count));
  }

  /** Shows the points if they are out of sight or too small to see. Returns whether the view has changed. */
  bringToView(points) {
    const { left, right, bottom, top } = this.boxOf(points);
    const at = (u) => this.left + this.scale * u, down = (v) => this.top - this.scale * v;
    const seen = at(left) >= 0 && at(right) <= this.width && down(top) >= 0 && down(bottom) <= this.height;
    const large = Math.max(right - left, top - bottom) * this.scale >= 24;
    if (seen && large) return false;
    this.show({ left, right, bottom, top, share: large ? 0.8 : 0.3 });
    return true;
  }
}
