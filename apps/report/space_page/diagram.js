// What: draws births against deaths in three colors. Pairs that can be chosen have a ring.
"use strict";

const diagramMargin = { left: 44, right: 14, top: 24, bottom: 24 };
const dimensionNames = ["component", "tunnel", "void"];

class SpaceDiagram {
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    const { radii, pairs } = data;
    const deaths = pairs.map(({ death }) => death).filter(Number.isFinite);
    const births = pairs.map(({ birth }) => birth).filter((birth) => birth > 0);
    const low = Math.min(radii[0] ?? 1, ...births.slice(0, 1), ...deaths.slice(0, 1));
    const high = Math.max(radii[radii.length - 1] ?? 1, low);
    this.range = Float64Array.of(low, high);
  }

  draw(colors, alpha, chosen) {
    const { context, width, height } = prepared(this.canvas, colors.panel);
    const { left, right, top, bottom } = diagramMargin;
    this.births = LogAxis.of(this.range, Infinity, left, width - right);
    this.deaths = LogAxis.of(this.range, Infinity, height - bottom, top);
    this.shade(context, colors, alpha);
    this.drawGrid(context, colors, width, height);
    for (const pair of this.data.pairs) this.dot(context, pair, 2, colors[dimensionNames[pair.dimension] + "s"], true);
    for (const pair of this.data.representatives) this.dot(context, pair, 4, colors[dimensionNames[pair.dimension] + "s"], false);
    if (chosen !== null) this.dot(context, chosen, 7, colors.text, false);
  }

  place({ birth, death }) {
    return { x: birth > 0 ? this.births.at(birth) : diagramMargin.left, y: Number.isFinite(death) ? this.deaths.at(death) : 8 };
  }

  dot(context, pair, size, color, isFilled) {
    const { x, y } = this.place(pair);
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.fillStyle = context.strokeStyle = color;
    if (isFilled) context.fill();
    else context.stroke();
  }

  shade(context, colors, alpha) {
    if (!(alpha > 0)) return;
    const { left } = diagramMargin;
    const x = this.births.at(alpha), y = this.deaths.at(alpha);
    context.fillStyle = colors.fill;
    context.globalAlpha = 0.5;
    context.fillRect(left, 0, x - left, y);
    context.globalAlpha = 1;
  }

  drawGrid(context, colors, width, height) {
    const { left, right, top, bottom } = diagramMargin;
    context.lineWidth = 1;
    context.fillStyle = colors.faint;
    for (const power of this.births.ticks(5)) {
      const x = this.births.at(10 ** power), y = this.deaths.at(10 ** power);
      drawLine(context, colors.grid, x, top, x, height - bottom);
      drawLine(context, colors.grid, left, y, width - right, y);
      context.textAlign = "center";
      context.fillText(powerOfTenText(power), x, height - 8);
      context.textAlign = "right";
      context.fillText(powerOfTenText(power), left - 4, y + 4);
    }
    drawLine(context, colors.grid, left, height - bottom, width - right, top);
    context.textAlign = "right";
    context.fillText("never", left - 4, 12);
  }

  /** Returns the representative whose ring is nearest, less than twelve pixels away; null if there is none. */
  representativeNear(x, y) {
    let best = null, least = 12;
    for (const one of this.data.representatives) {
      const at = this.place(one);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (distance < least) [best, least] = [one, distance];
    }
    return best;
  }
}
