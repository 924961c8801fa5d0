// What: saves the shape as GeoJSON and the view as SVG.
"use strict";

function shapeAsGeojson({ complex, step }) {
  const { points, facts } = complex.data;
  const greatest = points.reduce((most, x, i) => (i % 2 === 0 ? Math.max(most, Math.abs(x)) : most), 0);
  return geojsonOf(complex, complex.countAt(step), facts.unit === "degree" && greatest > 180 && greatest <= 360);
}

function viewAsSvg(page) {
  const { complex, view, step, shown, colors } = page;
  const count = complex.countAt(step);
  view.project();
  page.light(Infinity);
  const corners = (t) => [...complex.triangles.subarray(3 * t, 3 * t + 3)];
  const ends = (side) => [complex.triangles[side], complex.triangles[nextSide(side)]];
  const inner = shown.edges ? (sidesInView(complex, view, count).inner ?? []) : [];
  const free = shown.freeEdges ? freeEdgesInView(complex, view, step) : [];
  const isHole = page.pair >= 0 && complex.data.pairs.dimension[page.pair] === 1;
  return svgOf({
    width: view.width,
    height: view.height,
    x: view.x,
    y: view.y,
    polygons: polygonsAt(complex, count),
    regions: page.region.length === 0 ? [] : [{ triangles: page.region.map(corners), color: isHole ? colors.litGap : colors.lit }],
    lines: [...inner, ...free].map(ends),
    dots: shown.isolated ? isolatedInView(complex, view, count) : [],
    colors,
    bar: page.scaleBar(),
    unit: page.unit,
    title: `${complex.data.facts.source}, alpha ${page.alpha}`,
  });
}

/** Lets the browser save a text in a file named after the points and the radius. */
function saveFile({ complex, alpha }, ending, type, text) {
  const link = document.createElement("a");
  const name = complex.data.facts.source.replace(/\.[^.]*$/, "") || "shape";
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = `${name}.alpha-${short(alpha)}.${ending}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}
