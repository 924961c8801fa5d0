// What: draws the counts against alpha, and births against deaths, once. The page draws a mark for the current alpha
//       over these plots.
"use strict";

const plotMargin = { left: 44, right: 14, top: 10, bottom: 24 };

function drawRadiusTicks(context, axis, top, bottom, colors) {
  context.lineWidth = 1;
  context.textAlign = "center";
  for (const power of axis.ticks(6)) {
    const x = axis.at(10 ** power);
    drawLine(context, colors.grid, x, top, x, bottom);
    context.fillStyle = colors.text;
    context.fillText(powerOfTenText(power), x, bottom + 16);
  }
}

/** The counts that are drawn, each with the name of its color. */
const plottedCounts = [
  ["covered", "faint"],
  ["solidComponents", "edge"],
  ["components", "line"],
  ["holes", "holes"],
];

class CountsPlot {
  constructor(canvas) {
    this.canvas = canvas;
  }

  draw(complex, colors) {
    const { context, width, height } = prepared(this.canvas, colors.panel);
    const { left, right, top, bottom } = plotMargin;
    const { radii, counts } = complex.data;
    this.axis = LogAxis.of(radii, complex.reach(), left, width - right);
    this.drawPlateaus(context, complex.data.plateaus.slice(0, maxPlateaus), top, height - bottom, colors);
    drawRadiusTicks(context, this.axis, top, height - bottom, colors);
    let most = 1;
    for (const [name] of plottedCounts) for (const count of counts[name]) most = Math.max(most, count);
    const up = (count) => height - bottom - (Math.log10(1 + count) / Math.log10(1 + most)) * (height - bottom - top);
    context.textAlign = "right";
    for (const count of [0, ...Array.from({ length: Math.floor(Math.log10(most)) + 1 }, (_, i) => 10 ** i)]) {
      drawLine(context, colors.grid, left, up(count), width - right, up(count));
      context.fillStyle = colors.text;
      context.fillText(count >= 10000 ? count.toExponential(0).replace("+", "") : String(count), left - 4, up(count) + 4);
    }
    context.lineWidth = 1.5;
    for (const [name, color] of plottedCounts) this.drawCurve(context, radii, counts[name], up, colors[color]);
  }

  drawPlateaus(context, plateaus, top, bottom, colors) {
    context.fillStyle = colors.fill;
    for (const { from, to } of plateaus) {
      const left = this.axis.at(from);
      context.globalAlpha = 0.55;
      context.fillRect(left, top, this.axis.at(to) - left - 1, bottom - top);
    }
    context.globalAlpha = 1;
    context.textAlign = "center";
    context.fillStyle = colors.text;
    plateaus.forEach(({ alpha }, i) => context.fillText(`${i + 1}`, this.axis.at(alpha), top + 10));
  }

  /** Draws a curve. Each column of pixels shows its least, greatest and last value. */
  drawCurve(context, radii, counts, up, color) {
    context.strokeStyle = color;
    context.beginPath();
    context.moveTo(this.axis.from, up(0));
    let last = up(0);
    for (let step = 0; step < radii.length; ) {
      const column = Math.round(this.axis.at(radii[step]));
      let least = Infinity, greatest = -Infinity;
      context.lineTo(column, last);
      for (; step < radii.length && Math.round(this.axis.at(radii[step])) === column; ++step) {
        last = up(counts[step]);
        least = Math.min(least, last);
        greatest = Math.max(greatest, last);
      }
      context.lineTo(column, greatest);
      context.lineTo(column, least);
      context.lineTo(column, last);
    }
    context.lineTo(this.axis.to, last);
    context.stroke();
  }
}

class PersistenceDiagram {
  constructor(canvas) {
    this.canvas = canvas;
  }

  draw(complex, colors) {
    const { context, width, height } = prepared(this.canvas, colors.panel);
    const { left, right, top, bottom } = plotMargin;
    const { radii, pairs } = complex.data;
    const never = top + 4; // position of the deaths of pairs that never die
    this.births = LogAxis.of(radii, complex.reach(), left, width - right);
    this.deaths = LogAxis.of(radii, complex.reach(), height - bottom, top + 18);
    drawRadiusTicks(context, this.births, top, height - bottom, colors);
    context.textAlign = "right";
    for (const power of this.deaths.ticks(5)) {
      const y = this.deaths.at(10 ** power);
      drawLine(context, colors.grid, left, y, width - right, y);
      context.fillStyle = colors.text;
      context.fillText(powerOfTenText(power), left - 4, y + 4);
    }
    context.fillText("never", left - 4, never + 4);
    drawLine(context, colors.grid, left, never, width - right, never);
    drawLine(context, colors.text, left, this.deaths.at(this.births.radiusAt(left)), width - right, top + 18);
    // Draw only the longest pair of dots of one color at one pixel: the first pair, as the longest pairs come first.
    this.dots = new Map();
    for (let p = 0; p < pairs.count; ++p) {
      const x = Math.round(this.births.at(radii[pairs.birth[p]]));
      const y = pairs.death[p] < radii.length ? Math.round(this.deaths.at(radii[pairs.death[p]])) : never;
      const key = (pairs.dimension[p] * 4096 + y) * 8192 + x;
      if (!this.dots.has(key)) this.dots.set(key, { x, y, pair: p });
    }
    for (const { x, y, pair } of this.dots.values()) {
      context.fillStyle = pairs.dimension[pair] === 0 ? colors.line : colors.holes;
      context.fillRect(x - 2, y - 2, 4, 4);
    }
  }

  /** Returns the pair whose dot is nearest, less than twelve pixels away; −1 if there is none. */
  pairNear(x, y) {
    let best = { distance: 12, pair: -1 };
    for (const dot of this.dots.values()) {
      const distance = Math.hypot(dot.x - x, dot.y - y);
      if (distance < best.distance) best = { distance, pair: dot.pair };
    }
    return best.pair;
  }

  placeOf(complex, pair) {
    const { radii, pairs } = complex.data;
    const death = pairs.death[pair];
    return {
      x: this.births.at(radii[pairs.birth[pair]]),
      y: death < radii.length ? this.deaths.at(radii[death]) : plotMargin.top + 4,
    };
  }
}

/** Returns the `most` pairs of a dimension with the greatest ratios of death to birth. */
function longestPairs(complex, dimension, most) {
  const { radii, pairs } = complex.data;
  const length = (p) => (pairs.death[p] < radii.length ? Math.log(radii[pairs.death[p]]) - Math.log(radii[pairs.birth[p]]) : Infinity);
  const all = [];
  for (let p = 0; p < pairs.count; ++p) if (pairs.dimension[p] === dimension) all.push(p);
  return all.sort((p, q) => (length(p) === length(q) ? p - q : length(q) - length(p))).slice(0, most);
}
