// Tests the page of points in space in Chromium: loads, turns, reads and clicks it, at the width of a desk and of a
// telephone, light and dark.
// usage: node space_browser.mjs RBPA REPOSITORY CHROMIUM FOLDER      leaves screenshots in FOLDER
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Chromium } from "./chromium.mjs";

const [rbpa, repository, program, folder] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const run = (...options) => execFileSync(rbpa, options, { encoding: "utf8", maxBuffer: 1 << 28 });
const points = join(repository, "tests/data/m3_torus.off");
const html = join(folder, "report.html");
run("report", points, "--dimension", "3", "-o", html, "-q");
const { auto, min, pairs, plateaus } = JSON.parse(run("alpha", points, "--dimension", "3", "--json", "--persistence", "-q"));

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
const drawn = (tab) => tab.until(`document.getElementById("shape").dataset.state === "drawn"`);
async function opened(options, file = html) {
  const tab = await browser.open(`file://${file}`, options);
  await drawn(tab);
  return tab;
}
const text = (tab, id) => tab.value(`document.getElementById("${id}").textContent`);
const number = async (tab, id) => Number((await text(tab, id)).replaceAll(",", ""));
const alive = (dimension, alpha) =>
  pairs.filter((p) => p.dimension === dimension && p.birth <= alpha && (p.death === null || alpha < p.death)).length;

async function assertNumbers(tab, alpha) {
  for (const [dimension, id] of [[0, "components"], [1, "tunnels"], [2, "voids"]]) assert.equal(await number(tab, id), alive(dimension, alpha), `${id} at ${alpha}`);
  const solid = JSON.parse(run("solid", points, "--alpha", String(alpha), "--json", "-q"));
  assert.equal(await number(tab, "tetrahedra"), solid.tetrahedra);
  assert.equal(await tab.value("page.scene.counts[0]"), solid.boundary_triangles);
}
/** What goes wrong; that software draws here, and how, is not. */
const complaintsOf = (tab) => tab.events.filter((e) => e.method === "Runtime.exceptionThrown" || (e.method === "Log.entryAdded" && e.params.entry.source !== "rendering"));
/** How many pixels of the picture are of about that color. */
const pixelsLike = (tab, name) => tab.value(`(() => {
  const { canvas } = page.scene, copy = document.createElement("canvas");
  copy.width = canvas.width; copy.height = canvas.height;
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  const wanted = [1, 3, 5].map((at) => parseInt(page.colors["${name}"].slice(at, at + 2), 16));
  let count = 0;
  for (let i = 0; i < data.length; i += 4) count += wanted.every((value, k) => Math.abs(value - data[i + k]) < 40);
  return count;
})()`);

const wide = await opened({ width: 1280, height: 900 });
writeFileSync(join(folder, "wide.png"), await wide.screenshot());

await test("the page loads without a word, and asks for nothing but itself", async () => {
  const requests = wide.events.filter((e) => e.method === "Network.requestWillBeSent").map((e) => e.params.request.url);
  assert.deepEqual(requests, [`file://${html}`]);
  assert.deepEqual(complaintsOf(wide), []);
});

await test("it begins at the best plateau, and numbers are those of rbpa alpha and rbpa solid", async () => {
  const choices = [plateaus[0].alpha, min, auto];
  assert.equal(await wide.value("page.alpha"), choices[0]);
  await assertNumbers(wide, choices[0]);
  for (const i of [2, 1, 0]) {
    await wide.value(`document.querySelectorAll("#choices button")[${i}].click()`);
    await assertNumbers(wide, choices[i]);
  }
});

await test("the slider and the radius go to steps, each exact", async () => {
  for (const share of [0.1, 0.35, 0.6, 0.95]) {
    await wide.value(`(() => {
      const slider = document.getElementById("slider");
      slider.value = Math.round(${share} * slider.max);
      slider.dispatchEvent(new Event("input"));
    })()`);
    await assertNumbers(wide, await wide.value("page.alpha"));
  }
  const type = (value) => wide.value(`(() => {
    const input = document.getElementById("radius");
    input.value = "${value}";
    input.dispatchEvent(new Event("change"));
  })()`);
  await type("0.1");
  const alpha = await wide.value("page.alpha");
  assert(alpha <= 0.1 && alpha > 0.09);
  await assertNumbers(wide, alpha);
  await type("abc");
  assert.match(await text(wide, "radius-error"), /number > 0/);
});

await test("the picture has the solid, and turning it changes what is seen", async () => {
  await wide.value(`page.goToAlpha(${auto})`);
  await drawn(wide);
  assert((await wide.value("page.scene.counts[0]")) > 1000);
  assert((await pixelsLike(wide, "paper")) < 0.9 * (await wide.value("page.scene.canvas.width * page.scene.canvas.height")));
  const before = await wide.value("page.scene.canvas.toDataURL()");
  await wide.value(`document.getElementById("shape").focus()`);
  for (let i = 0; i < 4; ++i) await wide.press("ArrowLeft");
  await drawn(wide);
  assert.notEqual(await wide.value("page.scene.canvas.toDataURL()"), before);
  await wide.press("0");
  await drawn(wide);
  assert.equal(await wide.value("page.scene.canvas.toDataURL()"), before);
});

await test("a drag turns the picture, a wheel zooms, and both can be undone by key 0", async () => {
  const before = await wide.value("page.scene.canvas.toDataURL()");
  for (const events of [
    `["pointerdown", "pointermove", "pointerup"].map((name, i) => new PointerEvent(name, { pointerId: 1, clientX: 300 + 60 * i, clientY: 300, buttons: 1 }))`,
    `["pointerdown", "pointermove", "pointerup"].map((name, i) => new PointerEvent(name, { pointerId: 1, clientX: 300 + 60 * i, clientY: 300, buttons: 2 }))`,
    `[new WheelEvent("wheel", { deltaY: -200 })]`,
  ]) {
    await wide.value(`(() => {
      const { canvas } = page.scene;
      canvas.setPointerCapture = () => {};
      for (const event of ${events}) canvas.dispatchEvent(event);
    })()`);
    await drawn(wide);
    assert.notEqual(await wide.value("page.scene.canvas.toDataURL()"), before, events);
    await wide.press("0");
    await drawn(wide);
    assert.equal(await wide.value("page.scene.canvas.toDataURL()"), before);
  }
});

await test("a lost context comes back with the same picture", async () => {
  const before = await wide.value("page.scene.canvas.toDataURL()");
  await wide.value(`(async () => {
    const { gl, canvas } = page.scene, lose = gl.getExtension("WEBGL_lose_context");
    const event = (name) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
    const lost = event("webglcontextlost");
    lose.loseContext();
    await lost;
    const restored = event("webglcontextrestored");
    setTimeout(() => lose.restoreContext(), 0);
    await restored;
  })()`);
  await drawn(wide);
  assert.equal(await wide.value("page.scene.canvas.toDataURL()"), before);
});

await test("a pair of the lists shows its cycle, or the surface around its void, at its birth; again, and it is gone", async () => {
  for (const [list, dimension, color] of [["pairs-1", 1, "tunnels"], ["pairs-2", 2, "voids"]]) {
    const button = `document.querySelector("#${list} button")`;
    await wide.value(`${button}.click()`);
    await drawn(wide);
    writeFileSync(join(folder, `${color}.png`), await wide.screenshot());
    assert.equal(await wide.value("page.chosen.dimension"), dimension);
    assert.equal(await wide.value("page.alpha"), await wide.value("page.chosen.birth"));
    assert.equal(await wide.value(`${button}.getAttribute("aria-pressed")`), "true");
    assert(await wide.value(`page.scene.${dimension === 1 ? "lines" : "chosenSurface"}.visible`));
    if (dimension === 1) assert((await pixelsLike(wide, color)) > 50);
    await wide.value(`${button}.click()`);
    assert.equal(await wide.value("page.chosen"), null);
    assert(!(await wide.value("page.scene.lines.visible || page.scene.chosenSurface.visible")));
  }
});

await test("a click on a ring of the diagram chooses its pair", async () => {
  const at = await wide.value(`(() => {
    const longest = page.data.representatives.filter((one) => one.dimension === 1).sort((a, b) => b.death - b.birth - a.death + a.birth)[0];
    const box = document.getElementById("diagram").getBoundingClientRect(), { x, y } = page.diagram.place(longest);
    return { clientX: box.left + x, clientY: box.top + y, bubbles: true };
  })()`);
  await wide.value(`document.getElementById("diagram").dispatchEvent(new MouseEvent("click", ${JSON.stringify(at)}))`);
  assert.equal(await wide.value("page.chosen.death"), Math.max(...pairs.filter((p) => p.dimension === 1).map((p) => p.death)));
  await wide.value(`document.getElementById("shape").focus()`);
  await wide.press("Escape");
  assert.equal(await wide.value("page.chosen"), null);
});

await test("a telephone has picture and numbers, and nothing is wider than it", async () => {
  const phone = await opened({ width: 390, height: 800, dark: true, ratio: 2 });
  writeFileSync(join(folder, "phone.png"), await phone.screenshot());
  assert.equal(await phone.value("document.documentElement.scrollWidth"), 390);
  assert.deepEqual(complaintsOf(phone), []);
  await assertNumbers(phone, plateaus[0].alpha);
});

await test("one point, and a few with repetitions", async () => {
  for (const [name, lines] of [["one", "1 2 3\n"], ["few", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 1\n"]]) {
    const file = join(folder, `${name}.xyz`), page = join(folder, `${name}.html`);
    writeFileSync(file, lines);
    run("report", file, "--dimension", "3", "-o", page, "-q");
    const tab = await opened({}, page);
    assert.deepEqual(complaintsOf(tab), []);
    assert.equal(await text(tab, "source"), `${name}.xyz`);
  }
});

await test("100,000 points: a step of the slider takes less than 50 milliseconds", async () => {
  const file = join(folder, "large.xyz"), page = join(folder, "large.html");
  let state = 1n;
  const random = () => Number((state = (state * 6364136223846793005n + 1442695040888963407n) & ((1n << 64n) - 1n)) >> 11n) / 2 ** 53;
  writeFileSync(file, Array.from({ length: 100000 }, () => `${random()} ${random()} ${random()}\n`).join(""));
  run("report", file, "--dimension", "3", "-o", page, "-q");
  const tab = await opened({}, page);
  const times = await tab.value(`[0.3, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7].map((share) => {
    page.goTo(Math.round(share * page.data.facts.steps));
    return page.milliseconds;
  })`);
  times.sort((a, b) => a - b);
  console.log(`        ${times.map((t) => t.toFixed(1)).join(", ")} ms`);
  assert(times[3] < 50);
});

await browser.close();
process.exit(failed === 0 ? 0 : 1);
