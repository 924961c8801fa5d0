// What: formats lengths and areas in the unit of the coordinates, and computes the scale bar of the picture.
"use strict";

/** The texts after a length and an area, by the name of the unit in the data of the page. */
const unitSigns = {
  metre: { length: " m", area: " m²" },
  foot: { length: " ft", area: " ft²" },
  "US survey foot": { length: " US ft", area: " US ft²" },
  degree: { length: "°", area: " deg²" },
  none: { length: " units", area: " units²" },
};

const signsOf = (unit) => unitSigns[unit] ?? unitSigns.none;

/** Returns a number as text with four significant digits, or fewer if they are exact, and with separators of thousands.
 *  */
function fourDigits(number) {
  if (!Number.isFinite(number)) return "∞";
  const size = Math.abs(number), isExact = Number(number.toPrecision(4)) === number;
  if (size !== 0 && (size >= 9999500 || size < 1e-4))
    return number.toExponential(isExact ? undefined : 3).replace("+", "");
  return number.toLocaleString("en", { maximumSignificantDigits: 4, minimumSignificantDigits: isExact ? 1 : 4 });
}

/** Returns a length with its unit as text. Lengths from 1000 meters on are in kilometers; an unknown unit is "units".
 *  */
function lengthText(length, unit) {
  if (unit === "metre" && Number(length.toPrecision(4)) >= 1000) return `${fourDigits(length / 1000)} km`;
  if (unit === null && length === 1) return "1 unit";
  return fourDigits(length) + signsOf(unit).length;
}

function areaText(area, unit) {
  if (unit === "metre" && Number(area.toPrecision(4)) >= 1e6) return `${fourDigits(area / 1e6)} km²`;
  return fourDigits(area) + signsOf(unit).area;
}

/** Returns the greatest of 1, 2 and 5 times a power of ten that is at most `most`; 0 if there is none. */
function roundLength(most) {
  if (!(most > 0 && most < Infinity)) return 0;
  for (let power = Math.floor(Math.log10(most)) + 1; power >= -324; --power)
    for (const digit of [5, 2, 1]) {
      const length = Number(`${digit}e${power}`);
      if (length <= most) return length;
    }
  return 0;
}

/** Returns the scale bar of a view, at most `most` pixels long: its length in units of the coordinates, and in pixels.
 *  Returns null if no round length is both positive and finite. */
function scaleBar(view, most) {
  const length = roundLength(view.lengthOf(most));
  const pixels = view.pixelsOf(length);
  return length > 0 && pixels > 0 && pixels <= most * (1 + 1e-9) ? { length, pixels } : null;
}
