// What: exports the shape as GeoJSON and the view as SVG.
// Law:  GeoJSON has the coordinates of the input, to the last bit, except where polygons are cut at longitude 180.
"use strict";

/** Returns the shortest text that reads back to the number, with the sign of zero; "null" if the number is not finite.
 *  */
function textOf(number) {
  if (!Number.isFinite(number)) return "null";
  return Object.is(number, -0) ? "-0" : String(number);
}

/** Returns a FeatureCollection with a Feature for each polygon of the first `count` triangles, like that of `rbpa
 *  shape`. With `cuts`, points are longitudes and latitudes, and polygons are cut at longitude 180. */
function geojsonOf(complex, count, cuts) {
  const split = splitterOf(complex, count, cuts);
  const positionText = ([x, y]) => `[${textOf(x)},${textOf(y)}]`;
  const partText = (rings) => `[${rings.map((ring) => `[${[...ring, ring[0]].map(positionText).join(",")}]`).join(",")}]`;
  const features = polygonsAt(complex, count).map((polygon) => {
    const parts = split(polygon).map(partText);
    const { holes, area, perimeter } = polygon;
    return (
      `{"type":"Feature","properties":{"area":${textOf(area)},"perimeter":${textOf(perimeter)},"holes":${holes.length}},` +
      `"geometry":{"type":"${parts.length > 1 ? "MultiPolygon" : "Polygon"}","coordinates":${parts.length > 1 ? `[${parts.join(",")}]` : parts[0]}}}`
    );
  });
  return `{"type":"FeatureCollection","features":[${features.map((text) => "\n" + text).join(",")}\n]}\n`;
}

/** Returns a length as text, rounded to a hundredth of a pixel. */
const pixelText = (value) => String(Math.round(100 * value) / 100);

function pathOf(points, x, y) {
  return points.map((p, i) => `${i === 0 ? "M" : "L"}${pixelText(x[p])} ${pixelText(y[p])}`).join("");
}

/** Returns the picture as SVG. Rings wholly outside of the picture are left out. `width`, `height`, and `x` and `y` of
 *  each point are in pixels; `regions` are lists of triangles to light up, with a color; `lines` are pairs of points to
 *  join; `dots` are points to draw; `bar` is the scale bar, or null. */
function svgOf({ width, height, x, y, polygons, regions, lines, dots, colors, bar, unit, title }) {
  const touches = (points) =>
    points.some((p) => x[p] >= 0) && points.some((p) => x[p] <= width) &&
    points.some((p) => y[p] >= 0) && points.some((p) => y[p] <= height);
  const parts = [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">`,
    `<title>${title.replace(/&/g, "&amp;").replace(/</g, "&lt;")}</title>`,
    `<rect width="${width}" height="${height}" fill="${colors.paper}"/>`,
  ];
  const shape = polygons
    .filter(({ shell }) => touches(shell))
    .map(({ shell, holes }) => [shell, ...holes.filter(touches)].map((ring) => pathOf(ring, x, y) + "Z").join(""));
  const attributes = `fill-rule="evenodd" stroke-linejoin="round"`;
  for (const path of shape) parts.push(`<path d="${path}" fill="${colors.fill}" ${attributes}/>`);
  for (const { triangles, color } of regions)
    parts.push(`<path d="${triangles.filter(touches).map((t) => pathOf(t, x, y) + "Z").join("")}" fill="${color}"/>`);
  if (lines.length > 0)
    parts.push(
      `<path d="${lines.filter(touches).map((ends) => pathOf(ends, x, y)).join("")}" fill="none" ` +
        `stroke="${colors.edge}" stroke-width="0.5"/>`,
    );
  for (const path of shape) parts.push(`<path d="${path}" fill="none" stroke="${colors.line}" stroke-width="1.5"/>`);
  for (const p of dots.filter((p) => touches([p])))
    parts.push(`<circle cx="${pixelText(x[p])}" cy="${pixelText(y[p])}" r="2" fill="${colors.isolated}"/>`);
  if (bar !== null)
    parts.push(
      `<path d="M10 ${height - 16}v6h${pixelText(bar.pixels)}v-6" fill="none" stroke="${colors.text}" stroke-width="2"/>`,
      `<text x="10" y="${height - 20}" font-family="sans-serif" font-size="12" fill="${colors.text}">${lengthText(bar.length, unit)}</text>`,
    );
  parts.push("</svg>");
  return parts.join("\n") + "\n";
}
