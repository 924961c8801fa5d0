// Tests the page in Chromium: loads, moves, reads, clicks and saves it, at several widths, light and dark.
// usage: node browser.mjs RBPA REPOSITORY CHROMIUM FOLDER      leaves screenshots in FOLDER
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Chromium } from "./chromium.mjs";

const [rbpa, repository, program, folder] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(join(folder, "saved"), { recursive: true });
const run = (...options) => execFileSync(rbpa, options, { encoding: "utf8", maxBuffer: 1 << 28 });
const points = join(repository, "tests/data/shape_hdbscan_clusterable.xy");
const html = join(folder, "report.html");
run("report", points, "-o", html, "-q");
const { critical, auto, pairs, plateaus, recommended } = JSON.parse(run("alpha", points, "--json", "--persistence", "-q"));

const browser = new Chromium(program);
let failed = 0;
async function test(name, body) {
  try {
    await body();
    console.log(`passed  ${name}`);
  } catch (error) {
    console.log(`FAILED  ${name}\n`, error);
    ++failed;
  }
}

async function opened(options, file = html) {
  const tab = await browser.open(`file://${file}`, options);
  await drawn(tab);
  return tab;
}
/** All that was asked for is in the picture. */
const drawn = (tab) => tab.until(`document.getElementById("shape").dataset.state === "drawn"`);
const text = (tab, id) => tab.value(`document.getElementById("${id}").textContent`);
const number = async (tab, id) => Number((await text(tab, id)).replaceAll(",", ""));
const place = (tab, id) => tab.value(`(({ x, y, width, height }) => ({ x, y, width, height }))(document.getElementById("${id}").getBoundingClientRect())`);
const focus = (tab, id) => tab.value(`document.getElementById("${id}").focus()`);

async function assertNumbers(tab, step, alpha = step?.alpha ?? 0) {
  const names = { triangles: "triangles", solidComponents: "solid_components", components: "components", holes: "holes", covered: "covered" };
  for (const [id, name] of Object.entries(names)) assert.equal(await number(tab, id), step?.[name] ?? 0, id);
  assert.equal(await number(tab, "isolated"), critical.at(-1).covered - (step?.covered ?? 0));
  assert.equal(await tab.value(`document.getElementById("radius").value`), String(alpha));
  assert.equal(await tab.value(`document.getElementById("area").title`), String(step?.area ?? 0));
  const area = step?.area ?? 0, shown = await text(tab, "area");
  assert.match(shown, /^[\d.,]+(e-?\d+)? units²$/);
  assert(Math.abs(parseFloat(shown.replaceAll(",", "")) - area) <= 0.0005001 * area, `${shown}, ${area}`);
}

const wide = await opened();
writeFileSync(join(folder, "wide.png"), await wide.screenshot());

await test("the page loads without a word, and asks for nothing but itself", async () => {
  const requests = wide.events.filter((e) => e.method === "Network.requestWillBeSent").map((e) => e.params.request.url);
  assert.deepEqual(requests, [`file://${html}`]);
  const complaints = wide.events.filter((e) => ["Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"].includes(e.method));
  assert.deepEqual(complaints, []);
});

const stepAt = (alpha) => critical.findLast((step) => step.alpha <= alpha);

await test("the first view has the whole shape, as large as it can be", async () => {
  const box = await wide.value(`(() => {
    const { view } = page, { left, right, bottom, top } = view.boxOf(page.complex.cornersAt(page.step));
    return { width: (right - left) * view.scale / view.width, height: (top - bottom) * view.scale / view.height };
  })()`);
  assert(Math.abs(Math.max(box.width, box.height) - 0.94) < 0.02, JSON.stringify(box));
});

await test("it begins at the alpha that is recommended, and says why; the others are a click away", async () => {
  await assertNumbers(wide, stepAt(recommended.alpha), recommended.alpha);
  assert((await text(wide, "why")).includes(recommended.why));
  const buttons = await wide.value(`[...document.querySelectorAll("#choices button")].map((b) => b.textContent.split(" ")[0])`);
  assert.deepEqual(buttons, ["plateau", "plateau:2", "plateau:3", "plateau:4"].slice(0, plateaus.length).concat("min", "auto"));
  for (const [i, alpha] of [[0, plateaus[0].alpha], [buttons.length - 1, auto]]) {
    await wide.value(`document.querySelectorAll("#choices button")[${i}].click()`);
    await assertNumbers(wide, stepAt(alpha), alpha);
    assert.equal(await wide.value(`document.querySelectorAll("#choices button")[${i}].getAttribute("aria-pressed")`), "true");
  }
});

await test("the slider snaps to a plateau", async () => {
  const set = (by) => wide.value(`(() => {
    const slider = document.getElementById("slider");
    slider.value = page.axis.at(${plateaus.at(-1).alpha}) + ${by};
    slider.dispatchEvent(new Event("input"));
    return document.getElementById("radius").value;
  })()`);
  for (const by of [-5, 0, 5]) assert.equal(await set(by), String(plateaus.at(-1).alpha));
  for (const by of [-12, 12]) assert.notEqual(await set(by), String(plateaus.at(-1).alpha));
});

await test("the keys of the slider go from one critical radius to the next, and the numbers are those of rbpa alpha", async () => {
  await focus(wide, "slider");
  await wide.press("Home");
  await assertNumbers(wide, critical[0]);
  for (let i = 1; i < 25; ++i) {
    await wide.press("ArrowRight");
    await assertNumbers(wide, critical[i]);
  }
  await wide.press("ArrowLeft");
  await assertNumbers(wide, critical[23]);
  await wide.press("PageUp");
  await assertNumbers(wide, critical[23 + Math.round(critical.length / 50)]);
  await wide.press("End");
  await assertNumbers(wide, critical.at(-1));
  await wide.press("ArrowRight");
  await assertNumbers(wide, critical.at(-1));
  await wide.press("Home");
  await wide.press("ArrowLeft");
  await assertNumbers(wide, null);
});

await test("a radius that is typed is the step at or below it, and what is no radius is said", async () => {
  const type = async (value) => {
    await focus(wide, "radius");
    await wide.value(`document.getElementById("radius").select()`);
    await wide.call("Input.insertText", { text: value });
    await wide.press("Tab");
  };
  for (const value of ["0.005", "0.02", String(critical[100].alpha), "1e9", "inf"]) {
    await type(value);
    const alpha = value === "inf" ? Infinity : Number(value);
    await assertNumbers(wide, stepAt(alpha), alpha);
    assert.equal(await text(wide, "radius-error"), "");
  }
  const before = await number(wide, "triangles");
  for (const value of ["-1", "0", "abc", "NaN"]) {
    await type(value);
    assert.match(await text(wide, "radius-error"), /number > 0/);
    assert.equal(await number(wide, "triangles"), before);
    assert.equal(await wide.value(`document.getElementById("radius").getAttribute("aria-invalid")`), "true");
  }
  await type("0.02");
});

await test("the slider, dragged, goes from nothing to the whole triangulation", async () => {
  const { x, y, width, height } = await place(wide, "slider");
  const counts = [];
  await wide.mouse("mousePressed", x + 9, y + height / 2, { buttons: 1 });
  for (let i = 0; i <= 20; ++i) {
    await wide.mouse("mouseMoved", x + 9 + ((width - 18) * i) / 20, y + height / 2, { buttons: 1 });
    counts.push(await number(wide, "triangles"));
  }
  await wide.mouse("mouseMoved", x + width + 20, y + height / 2, { buttons: 1 });
  await wide.mouse("mouseReleased", x + width + 20, y + height / 2);
  assert.deepEqual(counts, counts.toSorted((a, b) => a - b));
  assert(new Set(counts).size > 15);
  assert.equal(counts[0], 0);
  assert.equal(await number(wide, "triangles"), critical.at(-1).triangles);
});

await test("the pixels of the shape are its area", async () => {
  await wide.value(`document.getElementById("fit").click()`);
  for (const share of [0.3, 0.6, 0.9]) {
    const step = Math.floor(share * critical.length);
    await wide.value(`page.goTo(${step})`);
    await drawn(wide);
    const pixels = await wide.value(`(() => {
      page.paint(false, false);
      const { data } = page.context.getImageData(0, 0, page.canvas.width, page.canvas.height);
      const fill = page.pixelColors.fill;
      return new Uint32Array(data.buffer).reduce((count, pixel) => count + (pixel === fill), 0);
    })()`);
    const scale = await wide.value("page.view.scale / (page.complex.data.points.reduce((m, v, i) => i % 2 ? m : Math.max(m, v), -Infinity) - page.complex.data.points.reduce((m, v, i) => i % 2 ? m : Math.min(m, v), Infinity)) * 2 * page.view.halfWidth");
    const expected = critical[step].area * scale ** 2;
    assert(Math.abs(pixels / expected - 1) < 0.02, `${pixels} pixels, expected about ${expected}`);
  }
});

await test("a pair of the lists is lit up, and a click into its hole finds it again", async () => {
  await wide.value(`document.querySelector("#hole-pairs button").click()`);
  await drawn(wide);
  assert.match(await text(wide, "selection"), /^Hole, .*lit in the picture/);
  assert.equal(await wide.value(`document.querySelector("#hole-pairs button").getAttribute("aria-pressed")`), "true");
  writeFileSync(join(folder, "hole.png"), await wide.screenshot());
  const chosen = await wide.value("page.pair");
  const longest = pairs.filter((p) => p.dimension === 1).sort((a, b) => b.death / b.birth - a.death / a.birth)[0];
  assert.equal(await wide.value(`page.complex.data.radii[page.complex.data.pairs.death[${chosen}]]`), longest.death);
  const at = await wide.value(`(() => {
    const { width } = page.raster;
    const lit = (i) => page.marked[page.raster.triangle[i]] === 1;
    const i = page.raster.triangle.findIndex((_, i) => [-3 * width, -3, 0, 3, 3 * width].every((by) => lit(i + by)));
    const box = page.canvas.getBoundingClientRect();
    return i < 0 ? null : { x: box.left + (i % width) / page.ratio, y: box.top + Math.floor(i / width) / page.ratio,
      lit: page.context.getImageData(i % width, Math.floor(i / width), 1, 1).data.join() };
  })()`);
  assert(at !== null);
  const paper = await wide.value(`new Uint8Array(new Uint32Array([page.pixelColors.litGap]).buffer).join()`);
  assert.equal(at.lit, paper);
  await focus(wide, "shape");
  await wide.press("Escape");
  assert.equal(await wide.value("page.pair"), -1);
  assert.equal(await text(wide, "selection"), "");
  await wide.click(at.x, at.y);
  await drawn(wide);
  assert.equal(await wide.value("page.pair"), chosen);
});

await test("a click into the diagram takes the pair there", async () => {
  const dot = await wide.value(`[...page.diagram.dots.values()].at(-1)`);
  await wide.value(`document.getElementById("diagram").scrollIntoView()`);
  const now = await place(wide, "diagram");
  await wide.click(now.x + dot.x, now.y + dot.y);
  await drawn(wide);
  assert.equal(await wide.value("page.pair"), dot.pair);
});

await test("drag, wheel, keys and buttons move the view, and All shows all again", async () => {
  await focus(wide, "shape");
  await wide.press("0");
  await drawn(wide);
  const view = () => wide.value("({ scale: page.view.scale, left: page.view.left, top: page.view.top })");
  const first = await view();
  await wide.mouse("mousePressed", 300, 300, { buttons: 1 });
  for (let i = 1; i <= 10; ++i) await wide.mouse("mouseMoved", 300 + 5 * i, 300 + 3 * i, { buttons: 1 });
  await wide.mouse("mouseReleased", 350, 330);
  const moved = await view();
  assert(Math.abs(moved.left - first.left - 50) < 6 && Math.abs(moved.top - first.top - 30) < 6);
  await wide.mouse("mouseWheel", 400, 300, { deltaX: 0, deltaY: -200, button: "none" });
  await wide.until(`page.view.scale > 1.4 * ${moved.scale}`, 5);
  const { scale } = await view();
  await focus(wide, "shape");
  await wide.press("+");
  assert((await view()).scale > 1.4 * scale);
  await wide.press("ArrowRight");
  await wide.value(`document.getElementById("zoom-out").click()`);
  await drawn(wide);
  writeFileSync(join(folder, "near.png"), await wide.screenshot());
  await wide.value(`document.getElementById("fit").click()`);
  await drawn(wide);
  assert.deepEqual(await view(), first);
  await focus(wide, "shape");
  await wide.press("1");
  await drawn(wide);
  assert((await view()).scale >= first.scale);
});

await test("what is saved is what rbpa shape writes, with every coordinate as in the input", async () => {
  await browser.call("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: join(folder, "saved") });
  const step = Math.floor(0.7 * critical.length);
  await wide.value(`page.choosePair(-1), page.goTo(${step})`);
  await drawn(wide);
  const saved = async (ending) => {
    for (let i = 0; i < 100; ++i) {
      const name = readdirSync(join(folder, "saved")).find((name) => name.endsWith(ending));
      if (name) return readFileSync(join(folder, "saved", name), "utf8");
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`no ${ending} was saved`);
  };
  await wide.value(`document.getElementById("save-geojson").click()`);
  const mine = JSON.parse(await saved(".geojson"));
  const shape = JSON.parse(run("shape", points, "--alpha", String(critical[step].alpha), "-o", "-", "--output-format", "geojson", "-q"));
  assert.deepEqual(mine.features.map((f) => f.geometry), shape.features.map((f) => f.geometry));
  await wide.value(`document.getElementById("save-svg").click()`);
  const svg = await saved(".svg");
  assert.equal((svg.match(/fill-rule="evenodd"/g) ?? []).length, critical[step].solid_components);
  assert.equal((svg.match(/<circle /g) ?? []).length, critical.at(-1).covered - critical[step].covered);
  // A browser reads it.
  const picture = await browser.open(`file://${join(folder, "saved", readdirSync(join(folder, "saved")).find((n) => n.endsWith(".svg")))}`, { width: 900, height: 760 });
  assert.equal(await picture.value("document.documentElement.nodeName"), "svg");
  assert.equal(await picture.value("document.querySelector('parsererror') === null"), true);
  writeFileSync(join(folder, "svg.png"), await picture.screenshot());
});

await test("all that can be used has a name and is reached by Tab", async () => {
  const { nodes } = await wide.call("Accessibility.getFullAXTree");
  const used = nodes.filter((n) => !n.ignored && ["button", "slider", "textbox", "checkbox", "application"].includes(n.role?.value));
  assert(used.length > 20);
  for (const node of used) assert(node.name?.value, JSON.stringify(node.role));
  const slider = used.find((n) => n.role.value === "slider");
  assert.match(slider.value?.value?.toString() ?? "", /./);
  assert.match(await wide.value(`document.getElementById("slider").getAttribute("aria-valuetext")`), /^alpha .* triangles?, .* holes?, .* isolated points?$/);
  await wide.value("document.activeElement.blur(); document.getElementById('shape').focus()");
  const reached = new Set();
  for (let i = 0; i < 40; ++i) {
    reached.add(await wide.value("document.activeElement.id || document.activeElement.textContent"));
    await wide.call("Input.dispatchKeyEvent", { type: "keyDown", key: "Tab", code: "Tab", windowsVirtualKeyCode: 9 });
    await wide.call("Input.dispatchKeyEvent", { type: "keyUp", key: "Tab", code: "Tab", windowsVirtualKeyCode: 9 });
  }
  for (const id of ["shape", "zoom-in", "fit-shape", "fit", "radius", "slider", "next", "show-edges", "save-geojson", "save-svg"]) assert(reached.has(id), id);
});

await test("text stands out from what is behind it, light and dark", async () => {
  const luminance = (hex) => {
    const [r, g, b] = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (a, b) => {
    const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  for (const dark of [false, true]) {
    const tab = await opened({ dark });
    writeFileSync(join(folder, dark ? "dark.png" : "light.png"), await tab.screenshot());
    const colors = await tab.value("page.colors");
    for (const name of ["text", "faint"]) assert(contrast(colors[name], colors.panel) >= 4.5, name);
    for (const name of ["line", "isolated", "holes", "edge"]) assert(contrast(colors[name], colors.panel) >= 3, name);
    for (const name of ["line", "isolated"]) assert(contrast(colors[name], colors.paper) >= 3, name);
    assert.equal(luminance(colors.paper) < 0.1, dark);
  }
});

await test("on a phone all is within its width, and large enough for a finger", async () => {
  const phone = await opened({ width: 390, height: 844, ratio: 2 });
  writeFileSync(join(folder, "phone.png"), await phone.screenshot());
  assert(await phone.value("document.documentElement.scrollWidth <= innerWidth"));
  const low = await phone.value(`[...document.querySelectorAll("button")].filter((b) => b.getBoundingClientRect().height < 40).map((b) => b.id)`);
  assert.deepEqual(low, []);
  // Two fingers apart: nearer.
  const { scale } = await phone.value("({ scale: page.view.scale })");
  const touch = (type, ...at) => phone.call("Input.dispatchTouchEvent", { type, touchPoints: at.map(([x, y], id) => ({ x, y, id })) });
  await touch("touchStart", [150, 300], [250, 300]);
  for (let i = 1; i <= 10; ++i) await touch("touchMove", [150 - 6 * i, 300], [250 + 6 * i, 300]);
  await touch("touchEnd");
  assert(Math.abs((await phone.value("page.view.scale")) / scale - 2.2) < 0.25);
});

for (const [width, height] of [[1280, 900], [390, 800], [800, 390]])
  await test(`at ${width} × ${height} nothing lies on the drawing, which has most of its width, and the picture fits again when the window changes`, async () => {
    const tab = await opened({ width, height });
    writeFileSync(join(folder, `${width}x${height}.png`), await tab.screenshot());
    const drawing = await place(tab, "shape");
    const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
    for (const id of ["zoom-in", "zoom-out", "fit-shape", "fit", "scale-bar", "scale-length", "radius", "source"]) {
      const box = await place(tab, id);
      assert(box.width > 0 && box.height > 0, id);
      assert(!overlap(box, drawing), `${id} ${JSON.stringify(box)} lies on ${JSON.stringify(drawing)}`);
    }
    for (const id of ["zoom-in", "zoom-out", "fit-shape", "fit", "scale-bar"]) {
      const { x, width: wide } = await place(tab, id);
      assert(x >= 0 && x + wide <= width, `${id} is within the window`);
    }
    assert(drawing.width * drawing.height > 0.3 * width * height, JSON.stringify(drawing));
    // Every pixel of the drawing is the canvas's own: what is there for a pointer is the canvas.
    const others = await tab.value(`(({ left, top, width, height }) => {
      let others = 0;
      for (let i = 0; i < 20; ++i) for (let j = 0; j < 20; ++j)
        others += document.elementFromPoint(left + ((i + 0.5) * width) / 20, top + ((j + 0.5) * height) / 20)?.id !== "shape";
      return others;
    })(document.getElementById("shape").getBoundingClientRect())`);
    assert.equal(others, 0);

    const resize = async (width, height, ratio = 1) => {
      const before = await tab.value("page.canvas.width * 1e6 + page.canvas.height");
      await tab.call("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: ratio, mobile: width < 600 });
      await tab.until(`page.canvas.width * 1e6 + page.canvas.height !== ${before}`);
      await drawn(tab);
    };
    const share = () => tab.value(`(() => {
      const { view } = page, { left, right, bottom, top } = view.boxOf(page.complex.cornersAt(page.step));
      const at = (u) => view.left + view.scale * u, down = (v) => view.top - view.scale * v;
      return { size: Math.max((right - left) * view.scale / page.canvas.width, (top - bottom) * view.scale / page.canvas.height),
        seen: at(left) >= 0 && at(right) <= page.canvas.width && down(top) >= 0 && down(bottom) <= page.canvas.height };
    })()`);
    for (const size of [[700, 500], [1000, 900], [360, 640], [1280, 720], [1270, 720, 2]]) {
      await resize(...size);
      const { size: found, seen } = await share();
      assert(seen && Math.abs(found - 0.94) < 0.01, `${size}: ${found}`);
    }
    await resize(900, 700);
    await focus(tab, "shape");
    await tab.press("+");
    await tab.press("ArrowRight");
    await drawn(tab);
    const middle = () => tab.value(`[(page.canvas.width / 2 - page.view.left) / page.view.scale, (page.view.top - page.canvas.height / 2) / page.view.scale, page.view.scale / page.ratio]`);
    const before = await middle();
    for (const size of [[1200, 800], [500, 700], [900, 700, 2], [1280, 720]]) {
      await resize(...size);
      (await middle()).forEach((value, i) => assert(Math.abs(value - before[i]) < 1e-6 * (1 + Math.abs(before[i])), `${size}: ${value}, ${before[i]}`));
    }
  });

await test("the bar of the scale is as long as it says, and follows the zoom; with a system the units are its own", async () => {
  const file = join(folder, "metres.html");
  run("report", points, "--crs", "EPSG:28992", "-o", file, "-q");
  for (const [html_, unit] of [[html, "units?"], [file, "m"]]) {
    const tab = await opened({ width: 390, height: 800, ratio: 2 }, html_);
    const seen = new Set();
    for (let i = 0; i < 9; ++i) {
      const length = Number((await text(tab, "scale-length")).match(new RegExp(`^([\\d.,]+) ${unit}$`))[1]);
      assert.match(String(length), /^0?\.?0*[125]0*$/);
      const { width } = await place(tab, "scale-bar");
      // By the points: the leftmost and the rightmost.
      const perPixel = await tab.value(`(() => {
        const { points } = page.complex.data, last = points.length - 2;
        return (points[last] - points[0]) / ((page.view.u[last / 2] - page.view.u[0]) * page.view.scale / page.ratio);
      })()`);
      assert(Math.abs((width * perPixel) / length - 1) < 0.03, `${width} pixels are ${width * perPixel}, and the bar says ${length}`);
      assert(width > 40 && width <= 140);
      seen.add(length);
      await tab.value(`document.getElementById("zoom-in").click()`);
      await drawn(tab);
    }
    assert(seen.size >= 4);
  }
  const tab = await opened({}, file);
  assert.match(await text(tab, "area"), /^[\d.,]+ m²$/);
  assert.equal(await tab.value(`document.querySelector("label[for=radius]").textContent`), "alpha, a radius in meters");
});

await test("points without a triangle have a page too", async () => {
  for (const points of ["0 0\n1 1\n3 3\n", "7 7\n", "0 0\n1 0\n0 1\n", "-1e308 0\n0 -5e-324\n1e308 0\n0 -1e308\n"]) {
    writeFileSync(join(folder, "p.xy"), points);
    run("report", join(folder, "p.xy"), "-o", join(folder, "p.html"), "-q");
    const tab = await opened({}, join(folder, "p.html"));
    assert.deepEqual(tab.events.filter((e) => e.method === "Runtime.exceptionThrown"), []);
    assert.equal(await number(tab, "isolated"), await tab.value("page.complex.pointCount - page.complex.numbersAt(page.step).covered"));
    await tab.value(`document.getElementById("save-svg").click(), document.getElementById("save-geojson").click()`);
  }
});

await browser.close();
process.exitCode = failed > 0 ? 1 : 0;
