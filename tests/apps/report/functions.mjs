// Compares the functions of the page with `rbpa` for the same points, without a browser.
// usage: node functions.mjs RBPA REPOSITORY
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import vm from "node:vm";

const [rbpa, repository] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "rbpa-report-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

const run = (...options) => execFileSync(rbpa, options, { encoding: "utf8", maxBuffer: 1 << 28 });

/** The scripts as they stand in the page, all but the last, which is the page itself. */
const page = (() => {
  const file = join(folder, "p.xy");
  writeFileSync(file, "0 0\n1 0\n0 1\n");
  const html = run("report", file, "-o", "-", "-q");
  const script = html.slice(html.lastIndexOf("<script>") + 8, html.lastIndexOf("</script>"));
  const begin = script.lastIndexOf("// What:");
  assert(begin > 0);
  const names = ["decode", "Complex", "Raster", "View", "LogAxis", "polygonsAt", "geojsonOf", "svgOf", "orientation",
    "longestPairs", "powerOfTenText", "short", "textOf", "freeEdgesInView", "isolatedInView", "noTriangle", "triangleOf",
    "nextSide", "fourDigits", "lengthText", "areaText", "roundLength", "scaleBar"];
  return vm.runInThisContext(`(() => { ${script.slice(0, begin)}\nreturn { ${names.join(", ")} }; })()`);
})();

function complexOf(file) {
  const html = run("report", file, "-o", "-", "-q");
  return new page.Complex(page.decode((name) => html.match(new RegExp(`id="data-${name}">([^<]*)</script>`))[1]));
}

let cases = 0;
function test(name, body) {
  try {
    body();
    ++cases;
  } catch (error) {
    console.error(`FAILED: ${name}\n`, error);
    process.exitCode = 1;
  }
}

/** A generator of numbers that is the same everywhere. */
function random(seed) {
  let state = seed;
  return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

function file(name, points) {
  const path = join(folder, name);
  writeFileSync(path, points.map(([x, y]) => `${x} ${y}`).join("\n") + "\n");
  return path;
}

const next = random(3);
const dataOf = (name) => join(repository, "tests/data", name);
const sets = {
  scattered: file("scattered.xy", Array.from({ length: 400 }, () => [next(), next()])),
  "a grid with gaps": file("grid.xy", Array.from({ length: 300 }, () => [Math.floor(20 * next()), Math.floor(20 * next())])),
  "far from zero": file("far.xy", Array.from({ length: 200 }, () => [6e5 + 0.01 * Math.floor(900 * next()), 5e6 + 0.01 * Math.floor(900 * next())])),
  enormous: file("enormous.xy", Array.from({ length: 60 }, () => [(2 * next() - 1) * 1.7e308, (2 * next() - 1) * 1.7e308])),
  minute: file("minute.xy", Array.from({ length: 60 }, () => [(next() - 0.5) * 3e-322, (next() - 0.5) * 3e-322])),
  clusters: dataOf("shape_hdbscan_clusterable.xy"),
  quakes: dataOf("geo_usgs_quakes_week.xy"),
};
const complexes = Object.fromEntries(Object.entries(sets).map(([name, path]) => [name, complexOf(path)]));

/** Some steps, the first and the last among them. */
function stepsOf(complex, most) {
  const stride = Math.max(1, Math.floor(complex.steps / most));
  const steps = [];
  for (let step = 0; step < complex.steps; step += stride) steps.push(step);
  return [...steps, complex.steps - 1];
}

for (const [name, complex] of Object.entries(complexes)) {
  test(`${name}: polygons are those of rbpa shape, and numbers those of rbpa alpha`, () => {
    const { critical } = JSON.parse(run("alpha", sets[name], "--json", "-q"));
    assert.equal(complex.steps, critical.length);
    for (const step of stepsOf(complex, 6)) {
      const alpha = critical[step].alpha;
      const numbers = complex.numbersAt(complex.stepAt(alpha === "inf" ? Infinity : alpha));
      assert.equal(numbers.alpha, alpha === "inf" ? Infinity : alpha);
      assert.equal(numbers.area, critical[step].area === "inf" ? Infinity : critical[step].area);
      for (const [ours, theirs] of [["triangles", "triangles"], ["solidComponents", "solid_components"],
        ["components", "components"], ["holes", "holes"], ["covered", "covered"]])
        assert.equal(numbers[ours], critical[step][theirs]);
      const shape = JSON.parse(run("shape", sets[name], "--alpha", String(alpha), "-o", "-", "--output-format", "geojson", "-q"));
      const mine = JSON.parse(page.geojsonOf(complex, complex.countAt(step), false));
      assert.equal(mine.features.length, numbers.solidComponents);
      assert.equal(mine.features.length, shape.features.length);
      shape.features.forEach((feature, i) => {
        assert.deepEqual(mine.features[i].geometry, feature.geometry);
        assert.equal(mine.features[i].properties.holes, feature.properties.holes);
        for (const measure of ["area", "perimeter"]) {
          const expected = feature.properties[measure], found = mine.features[i].properties[measure];
          // Subnormal numbers have fewer digits.
          if (expected > 1e-290) assert(Math.abs(found - expected) <= 1e-9 * expected, `${measure} ${found}, ${expected}`);
        }
      });
    }
  });

  test(`${name}: each living pair lights up a region of its own, and together they are all`, () => {
    const { pairs } = complex.data;
    for (const step of stepsOf(complex, 4)) {
      const seen = new Set();
      const living = [0, 0];
      for (let p = 0; p < pairs.count; ++p) {
        const region = complex.regionOf(p, step);
        assert.equal(region !== null, complex.isAlive(p, step));
        if (region === null) continue;
        ++living[pairs.dimension[p]];
        for (const t of region) {
          assert.equal(t < complex.countAt(step), pairs.dimension[p] === 0);
          assert(!seen.has(t));
          seen.add(t);
        }
        const one = region[region.length >> 1];
        if (p % 17 === 0) assert.equal(complex.pairAt(one, step), p);
        if (region.length > 1) assert.equal(complex.regionOf(p, step, region.length - 1), null);
      }
      const numbers = complex.numbersAt(step);
      assert.deepEqual(living, [numbers.components, numbers.holes]);
      for (let t = 0; t < complex.countAt(step); ++t) assert(seen.has(t));
      // Triangles in no region are connected with the outside.
      for (let t = complex.countAt(step); t < complex.size; t += 31) if (!seen.has(t)) assert.equal(complex.pairAt(t, step), -1);
    }
  });

  if (complex.size < 1500) test(`${name}: a pixel has the triangle that its center is in`, () => {
    const view = new page.View(complex.data.points);
    view.resize(61, 47);
    view.fit();
    for (const zoom of [1, 1.7, 9]) {
      view.zoom(zoom, 13, 29);
      view.project();
      const raster = new page.Raster(61, 47);
      raster.lay(complex, view.x, view.y, 1);
      const side = (a, b, x, y) => (view.x[b] - view.x[a]) * (y - view.y[a]) - (view.y[b] - view.y[a]) * (x - view.x[a]);
      for (let row = 0; row < 47; ++row)
        for (let column = 0; column < 61; ++column) {
          const [x, y] = [column + 0.5, row + 0.5];
          let strictly = -1;
          const near = new Set([-1]);
          for (let t = 0; t < complex.size; ++t) {
            const [a, b, c] = complex.triangles.subarray(3 * t, 3 * t + 3);
            const signs = [side(a, b, x, y), side(b, c, x, y), side(c, a, x, y)];
            const size = 1e-9 * (1 + Math.max(...signs.map(Math.abs)));
            if (signs.every((s) => s < -size)) strictly = t;
            if (signs.every((s) => s < size)) near.add(t);
          }
          const found = raster.at(column, row);
          if (strictly >= 0) assert.equal(found, strictly);
          else assert(near.has(found));
        }
      const pixels = new Uint32Array(61 * 47);
      const colors = { paper: 1, fill: 2, line: 3, isolated: 4, lit: 5, litGap: 6 };
      const count = complex.countAt(complex.steps >> 1);
      const marked = new Uint8Array(complex.size);
      marked[raster.at(30, 23)] = 1;
      raster.paint(pixels, count, marked, colors, { outline: false, dots: false });
      pixels.forEach((color, i) => {
        const t = raster.triangle[i];
        if (t === page.noTriangle) assert.equal(color, 1);
        else if (marked[t] === 1) assert.equal(color, t < count ? 5 : 6);
        else assert.equal(color, t < count ? 2 : 1);
      });
      // Just before and just after the first triangle at a point has come.
      const p = complex.firstAt.findIndex((first, p) => first > 0 && view.x[p] > 2 && view.x[p] < 59 && view.y[p] > 2 && view.y[p] < 45);
      if (p < 0) continue;
      const at = Math.floor(view.y[p]) * 61 + Math.floor(view.x[p]);
      const alone = new page.Raster(61, 47);
      alone.layDot(complex.firstAt[p] + 1, view.x[p], view.y[p], 1);
      for (const [then, color] of [[complex.firstAt[p], 4], [complex.firstAt[p] + 1, 1]]) {
        alone.triangle.fill(page.noTriangle);
        alone.paint(pixels, then, null, colors, { outline: false, dots: true });
        assert.deepEqual([pixels[at], pixels[at + 1], pixels[at - 61], pixels[at + 2]], [color, color, color, 1]);
      }
    }
  });

  test(`${name}: sides, points and edges are what the full complex has`, () => {
    for (let side = 0; side < complex.twin.length; ++side) {
      const twin = complex.twin[side];
      if (twin < 0) continue;
      assert.equal(complex.twin[twin], side);
      assert.equal(complex.triangles[twin], complex.triangles[page.nextSide(side)]);
      assert.equal(complex.triangles[page.nextSide(twin)], complex.triangles[side]);
    }
    const view = new page.View(complex.data.points);
    view.resize(100, 100);
    view.fit();
    view.project();
    for (const step of stepsOf(complex, 4)) {
      const numbers = complex.numbersAt(step);
      assert.equal(page.isolatedInView(complex, view, numbers.triangles).length, numbers.isolated);
      const alpha = numbers.alpha === Infinity ? "inf" : String(numbers.alpha);
      const stats = join(folder, "stats.json");
      run("mesh", sets[name], "--alpha", alpha, "--complex", "full", "--stats", stats, "-q");
      assert.equal(page.freeEdgesInView(complex, view, step).length, JSON.parse(readFileSync(stats)).dangling_edges);
    }
  });
}

test("a view of the shape leaves out what is far off, and everything is a view away", () => {
  const far = file("outliers.xy", [[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5], [1e6, 2e5], [-3e6, 1e6]]);
  const complex = complexOf(far);
  const { recommended } = complex.data.facts;
  const step = complex.stepAt(recommended.alpha);
  assert(new Set(complex.cornersAt(step)).size === 5, "the square is recommended, without the outliers");
  const view = new page.View(complex.data.points);
  view.resize(200, 100);
  const inside = (p) => view.x[p] >= 0 && view.x[p] <= 200 && view.y[p] >= 0 && view.y[p] <= 100;
  const seen = () => {
    view.project();
    return [...view.x.keys()].filter(inside).length;
  };
  const spread = () => Math.max(...complex.cornersAt(step).map((p) => view.y[p])) - Math.min(...complex.cornersAt(step).map((p) => view.y[p]));
  view.fit();
  assert.equal(seen(), 7);
  assert(spread() < 1);
  view.fit(complex.cornersAt(step));
  assert.equal(seen(), 5);
  assert(Math.abs(spread() - 94) < 1e-3);
  const { scale } = view;
  view.fit(complex.cornersAt(-1)); // no triangle: all
  assert(view.scale < 1e-5 * scale);
  assert.equal(seen(), 7);
});

test("GeoJSON is cut at longitude 180 as that of rbpa shape", () => {
  const longitudes = [(x) => x, (x) => (x < 0 ? x + 360 : x), (x) => (x > 0 ? x - 360 : x)];
  const ring = Array.from({ length: 400 }, () => [2 * Math.PI * next(), 0.6 + 0.4 * next()]);
  const around = ring.map(([turn, r]) => [180 + 9.7 * r * Math.cos(turn), 7 * r * Math.sin(turn)]);
  const grid = Array.from({ length: 90 }, (_, i) => [175 + (i % 10), Math.floor(i / 10)]); // with points on the line
  const far = Array.from({ length: 30 }, () => [100 + next(), next()]);
  for (const [name, points] of [["around", around], ["grid", grid], ["all", [...around, ...far]]])
    for (const shown of longitudes) {
      const path = join(folder, `${name}.csv`);
      const within = (x) => (x > 180 ? x - 360 : x);
      writeFileSync(path, ["lon,lat", ...points.map(([x, y]) => `${shown(within(x))},${y}`)].join("\n") + "\n");
      const complex = complexOf(path);
      const cuts = complex.data.points.some((x, i) => i % 2 === 0 && Math.abs(x) > 180);
      for (const step of stepsOf(complex, 4)) {
        const alpha = String(complex.numbersAt(step).alpha).replace("Infinity", "inf");
        const wanted = JSON.parse(run("shape", path, "--alpha", alpha, "-o", "-", "--output-format", "geojson", "-q"));
        const found = JSON.parse(page.geojsonOf(complex, complex.countAt(step), cuts));
        const parts = ({ geometry }) =>
          (geometry.type === "Polygon" ? [geometry.coordinates] : geometry.coordinates).map(([shell, ...holes]) => JSON.stringify([shell, ...holes.sort()])).sort();
        assert.deepEqual(found.features.map(parts), wanted.features.map(parts));
        if (cuts) for (const [, x] of JSON.stringify(found).matchAll(/\[(-?[\d.e-]+),/g)) assert(Math.abs(x) <= 180);
      }
    }
});

test("orientation is exact", () => {
  const points = Float64Array.from([0, 0, 12, 12, 24, 24, 0.5, 0.5 + 2 ** -53, 0.5, 0.5, 1e308, 1e308, -1e308, 1e308, 5e-324, 0, 0, 5e-324]);
  assert.equal(page.orientation(points, 0, 1, 2), 0);
  assert(page.orientation(points, 0, 1, 3) > 0);
  assert(page.orientation(points, 3, 1, 2) > 0);
  assert.equal(page.orientation(points, 4, 1, 2), 0);
  assert(page.orientation(points, 0, 5, 6) > 0);
  assert(page.orientation(points, 0, 6, 5) < 0);
  assert(page.orientation(points, 0, 7, 8) > 0);
  assert(page.orientation(points, 0, 8, 7) < 0);
});

test("text of numbers reads back, zero with its sign; what is no number is null", () => {
  for (const value of [0, -0, 0.1, 1e21, 5e-324, -1.7976931348623157e308])
    assert(Object.is(JSON.parse(page.textOf(value)), value));
  assert.equal(page.textOf(Infinity), "null");
  assert.equal(page.textOf(NaN), "null");
});

test("an axis and its ticks agree, up to the ends of the range of double", () => {
  for (const radii of [[0.05, 3, 200], [5e-324, 1e308], [2], [], [1e-300, Infinity], [1e300, 1e301]]) {
    const axis = page.LogAxis.of(Float64Array.from(radii), Infinity, 40, 400);
    for (const radius of radii.filter(Number.isFinite)) {
      assert(axis.at(radius) >= 40 && axis.at(radius) <= 400);
      const back = axis.radiusAt(axis.at(radius));
      if (radius > 1e-307) assert(Math.abs(back / radius - 1) < 1e-9);
    }
    const ticks = axis.ticks(6);
    assert(ticks.length >= 2 && ticks.length <= 8);
    for (const power of ticks) assert(!/NaN|undefined/.test(page.powerOfTenText(power)));
  }
  assert.deepEqual([-1, 0, 1, 3, 5, 7, -5].map(page.powerOfTenText), ["0.1", "1", "10", "1000", "100000", "1e7", "1e-5"]);
});

test("numbers have four digits, and the unit of the coordinates, squared of areas", () => {
  for (const [number, text] of [[0, "0"], [3819.51, "3,820"], [0.98514, "0.9851"], [12, "12"], [1.5, "1.5"], [123456.7, "123,500"],
    [9999499, "9,999,000"], [9999500, "1.000e7"], [2e7, "2e7"], [0.250006, "0.2500"], [0.25, "0.25"], [162, "162"], [1.23456e300, "1.235e300"], [0.0001, "0.0001"], [0.00009, "9e-5"], [5e-324, "5e-324"],
    [-42.424242, "-42.42"], [Infinity, "∞"]])
    assert.equal(page.fourDigits(number), text);
  for (const [area, unit, text] of [[3819.51, "metre", "3,820 m²"], [999949, "metre", "999,900 m²"], [999950, "metre", "1.000 km²"], [8.2e13, "metre", "8.2e7 km²"],
    [3819.51, "foot", "3,820 ft²"], [2e6, "US survey foot", "2,000,000 US ft²"], [549.836, "degree", "549.8 deg²"], [3819.51, null, "3,820 units²"],
    [0, null, "0 units²"]])
    assert.equal(page.areaText(area, unit), text);
  for (const [length, unit, text] of [[500, "metre", "500 m"], [1000, "metre", "1 km"], [2e5, "metre", "200 km"], [0.05, "metre", "0.05 m"], [2000, "foot", "2,000 ft"],
    [5000, "US survey foot", "5,000 US ft"], [0.5, "degree", "0.5°"], [1, null, "1 unit"], [20, null, "20 units"], [1e-5, null, "1e-5 units"]])
    assert.equal(page.lengthText(length, unit), text);
});

test("the bar is as long as one, two or five times a power of ten, and no such length is nearer to what there is room for", () => {
  for (const [most, length] of [[1, 1], [1.99, 1], [2, 2], [4.999, 2], [5, 5], [9.99, 5], [10, 10], [1000, 1000], [999.9, 500], [0.3, 0.2],
    [0.001, 0.001], [1e-5, 1e-5], [2e22, 2e22], [1.7e308, 1e308], [5e-324, 5e-324], [0, 0], [-1, 0], [NaN, 0], [Infinity, 0]])
    assert.equal(page.roundLength(most), length);
  for (let power = -307; power <= 307; ++power)
    for (const digit of [1, 2, 5]) assert.equal(page.roundLength(Number(`${digit}e${power}`)), Number(`${digit}e${power}`));
  for (const [name, complex] of Object.entries(complexes)) {
    const { points } = complex.data;
    const view = new page.View(points);
    view.resize(800, 600);
    const lengths = new Set();
    for (let i = 0; i < 30; ++i) {
      view.zoom(1.3, 100, 100);
      view.project();
      const bar = page.scaleBar(view, 140);
      if (name === "minute" && bar === null) continue;
      lengths.add(bar.length);
      assert(/^[125](\.0+)?e/.test(bar.length.toExponential()) || bar.length < 1e-300, `${name}: ${bar.length}`);
      assert(bar.pixels <= 140.0001 && (bar.pixels > 140 / 2.51 || bar.length < 1e-300), `${name}: ${bar.pixels}`);
      // The distance of two points, in pixels of the picture and in the coordinates, has the ratio of the bar.
      const [p, q] = [0, complex.pointCount - 1];
      const apart = points[2 * q] / 4 - points[2 * p] / 4;
      if (name !== "minute") assert(Math.abs((view.x[q] - view.x[p]) / 4 / apart / (bar.pixels / bar.length) - 1) < 1e-6, name);
    }
    if (name !== "minute") assert(lengths.size > 8, `${name}: the bar follows the zoom`);
  }
  assert.equal(page.scaleBar(new page.View(new Float64Array(0)), 140), null);
});

test("what was fitted fits again in another size; what was moved or zoomed keeps its middle", () => {
  const complex = complexes.quakes;
  const view = new page.View(complex.data.points);
  const state = () => [view.scale, view.left, view.top];
  const middle = () => [(view.width / 2 - view.left) / view.scale, (view.top - view.height / 2) / view.scale];
  const near = (a, b) => a.forEach((value, i) => assert(Math.abs(value - b[i]) < 1e-9 * (1 + Math.abs(b[i])), `${a}, ${b}`));
  const some = complex.cornersAt(complex.steps >> 1);
  for (const points of [[], some]) {
    view.resize(800, 600);
    view.fit(points);
    view.resize(390, 300);
    const found = state();
    view.fit(points);
    assert.deepEqual(found, state());
    view.resize(800, 600, 2);
    view.fit(points);
    for (const move of [() => view.pan(30, -10), () => view.zoom(1.5, 100, 200)]) {
      view.fit(points);
      move();
      const { scale } = view, before = middle();
      for (const [width, height] of [[390, 800], [1280, 900], [1, 1], [640, 480]]) {
        view.resize(width, height);
        assert.equal(view.scale, scale);
        near(middle(), before);
      }
      view.resize(1280, 960, 2); // as many pixels again in each direction
      assert.equal(view.scale, 2 * scale);
      near(middle(), before);
    }
  }
});

test("the longest pairs come first", () => {
  const complex = complexes.clusters;
  for (const dimension of [0, 1]) {
    const { radii, pairs } = complex.data;
    const ratio = (p) => (pairs.death[p] === radii.length ? Infinity : radii[pairs.death[p]] / radii[pairs.birth[p]]);
    const longest = page.longestPairs(complex, dimension, 8);
    assert.equal(longest.length, 8);
    const rest = [...pairs.dimension.keys()].filter((p) => pairs.dimension[p] === dimension && !longest.includes(p));
    for (const p of longest) for (const q of rest) assert(ratio(p) >= ratio(q) * (1 - 1e-12));
  }
});

test("data that are cut off are refused", () => {
  const html = run("report", sets.scattered, "-o", "-", "-q");
  const text = (name) => html.match(new RegExp(`id="data-${name}">([^<]*)</script>`))[1].replace(/\s/g, "");
  for (const broken of ["triangles", "counts", "free-edges", "pairs"])
    assert.throws(() => page.decode((name) => (name === broken ? text(name).slice(0, 400) : text(name))), RangeError);
});

console.log(`${cases} tests passed`);
