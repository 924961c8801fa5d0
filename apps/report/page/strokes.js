// What: draws smooth lines and dots over the shape, piece by piece while the page is idle.
// Why:  the picture of a step has to appear immediately; raster.js draws it as pixels. Lines take longer and can wait.
"use strict";

const mostBoundary = 60000; // with more sides in view the boundary is drawn as pixels
const mostTriangles = 15000;
const mostDots = 20000;

/** Returns the sides in view of the first `count` triangles: `boundary` and `inner` sides. `inner` is null if there are
 *  too many inner sides; both are null if there are too many boundary sides. */
function sidesInView(complex, view, count) {
  const { triangles } = complex;
  const boundary = [], inner = [];
  for (let side = 0; side < 3 * count; ++side) {
    const isBoundary = complex.isBoundary(side, count);
    if (!isBoundary && (inner === null || complex.twin[side] > side)) continue;
    if (!crossesView(view, triangles[side], triangles[nextSide(side)])) continue;
    if (isBoundary) boundary.push(side);
    else inner.push(side);
    if (boundary.length > mostBoundary) return { boundary: null, inner: null };
  }
  return { boundary, inner: inner.length > 1.5 * mostTriangles ? null : inner };
}

function crossesView(view, a, b) {
  const { x, y, width, height } = view;
  return Math.max(x[a], x[b]) >= 0 && Math.min(x[a], x[b]) <= width && Math.max(y[a], y[b]) >= 0 &&
    Math.min(y[a], y[b]) <= height;
}

/** Returns the edges in view that are in no triangle at a step. */
function freeEdgesInView(complex, view, step) {
  const { freeEdges } = complex.data;
  const count = complex.countAt(step);
  const sides = [];
  for (let e = 0; e < freeEdges.step.length && freeEdges.step[e] <= step; ++e) {
    const side = freeEdges.side[e];
    if (side >= 3 * count && crossesView(view, complex.triangles[side], complex.triangles[nextSide(side)]))
      sides.push(side);
  }
  return sides;
}

function isolatedInView(complex, view, count) {
  const dots = [];
  for (let p = 0; p < complex.pointCount; ++p)
    if (complex.firstAt[p] >= count && crossesView(view, p, p)) dots.push(p);
  return dots;
}

/** Draws sides as lines. Pauses after every thousand lines. */
function* strokeSides(context, complex, view, sides, color, width) {
  const { x, y } = view;
  context.strokeStyle = color;
  context.lineWidth = width;
  context.lineCap = "round";
  for (let begin = 0; begin < sides.length; begin += 1000) {
    context.beginPath();
    for (const side of sides.slice(begin, begin + 1000)) {
      const a = complex.triangles[side], b = complex.triangles[nextSide(side)];
      context.moveTo(x[a], y[a]);
      context.lineTo(x[b], y[b]);
    }
    context.stroke();
    yield;
  }
}

function* fillDots(context, view, dots, color, radius) {
  context.fillStyle = color;
  for (let begin = 0; begin < dots.length; begin += 1000) {
    context.beginPath();
    for (const p of dots.slice(begin, begin + 1000)) {
      context.moveTo(view.x[p] + radius, view.y[p]);
      context.arc(view.x[p], view.y[p], radius, 0, 2 * Math.PI);
    }
    context.fill();
    yield;
  }
}

/** Draws the whole picture. fill(outline, dots) draws the pixels, on request with a boundary and with dots as pixels.
 *  */
function* fineDrawing(context, complex, view, step, shown, colors, ratio, fill) {
  const count = complex.countAt(step);
  const { boundary, inner } = sidesInView(complex, view, count);
  yield;
  const dots = shown.isolated ? isolatedInView(complex, view, count) : [];
  fill(boundary === null, dots.length > mostDots);
  yield;
  if (inner !== null && shown.edges) yield* strokeSides(context, complex, view, inner, colors.edge, 0.6 * ratio);
  if (shown.freeEdges)
    yield* strokeSides(context, complex, view, freeEdgesInView(complex, view, step), colors.free, ratio);
  if (boundary !== null) yield* strokeSides(context, complex, view, boundary, colors.line, 1.6 * ratio);
  if (dots.length <= mostDots) yield* fillDots(context, view, dots, colors.isolated, 2.2 * ratio);
}
