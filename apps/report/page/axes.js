// What: provides a logarithmic axis for radii with its ticks, and a canvas to draw on.
"use strict";

class LogAxis {
  /** Maps the logarithms to base ten from `low` to `high` to the positions from `from` to `to`. */
  constructor(low, high, from, to) {
    Object.assign(this, { low, high, from, to });
  }

  /** Returns an axis for sorted radii, with room at both ends. Radii above `reach` lie at the end: they belong to flat
   *  triangles of the convex hull, and may be arbitrarily large. */
  static of(radii, reach, from, to) {
    const last = radii.length === 0 ? 1 : Math.min(reach, radii[radii.length - 1], Number.MAX_VALUE);
    const low = radii.length === 0 ? 0 : Math.log10(radii[0]);
    const high = Math.max(low, Math.log10(last));
    const margin = high > low ? (high - low) / 40 : 0.5;
    return new LogAxis(low - margin, high + margin, from, to);
  }

  at(radius) {
    const share = (Math.log10(radius) - this.low) / (this.high - this.low);
    return this.from + Math.min(1, Math.max(0, share)) * (this.to - this.from);
  }

  /** Returns the radius at `position`; Infinity at the end of the axis. */
  radiusAt(position) {
    const share = (position - this.from) / (this.to - this.from);
    if (share >= 1) return Infinity;
    return 10 ** (this.low + Math.max(0, share) * (this.high - this.low));
  }

  /** Returns the exponents of at most `most` + 1 powers of ten, or both ends if fewer than two such powers are inside.
   *  */
  ticks(most) {
    const stride = Math.max(1, Math.ceil((this.high - this.low) / most));
    const powers = [];
    for (let power = stride * Math.ceil(this.low / stride); power <= this.high; power += stride) powers.push(power);
    return powers.length >= 2 ? powers : [this.low, this.high];
  }
}

/** Returns a number as text with at most four significant digits. */
function short(number) {
  if (!Number.isFinite(number)) return "∞";
  if (number === 0) return "0";
  const size = Math.abs(number);
  return size >= 1e6 || size < 1e-4 ? number.toExponential(3) : String(Number(number.toPrecision(4)));
}

/** Returns 10 to the power `power` as text, even beyond the range of double. */
function powerOfTenText(power) {
  if (power === Math.round(power) && power >= -3 && power <= 5) return short(10 ** power);
  const whole = Math.floor(power);
  const digits = Number((10 ** (power - whole)).toPrecision(3));
  return whole >= -3 && whole <= 5 ? short(Number((digits * 10 ** whole).toPrecision(3))) : `${digits}e${whole}`;
}

/** Fits a canvas to its element, and fills the canvas with the background. Returns its context, width and height; all
 *  lengths are in CSS pixels. */
function prepared(canvas, background) {
  const ratio = Math.min(2, devicePixelRatio || 1);
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.fillStyle = background;
  context.fillRect(0, 0, width, height);
  context.font = "11px system-ui, sans-serif";
  return { context, width, height };
}

function drawLine(context, color, x1, y1, x2, y2) {
  context.strokeStyle = color;
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}
