// Measures the page in Chromium: opening it, a step of the slider, a new view. Prints milliseconds.
// usage: node measure.mjs RBPA CHROMIUM [POINTS]        200,000 points by default; nothing else should be at work
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync, writeFileSync } from "node:fs";
import { cpus, tmpdir } from "node:os";
import { join } from "node:path";
import { Chromium } from "./chromium.mjs";

const [rbpa, program, count = "200000"] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "rbpa-measure-"));

/** Scattered in a square with three empty discs, on integers so that no digit depends on a library. */
function points(count) {
  let state = 5;
  const next = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const lakes = [[0.3, 0.4, 0.1], [0.7, 0.7, 0.15], [0.6, 0.2, 0.05]];
  const lines = [];
  while (lines.length < count) {
    const [x, y] = [next(), next()];
    if (lakes.some(([a, b, r]) => (x - a) ** 2 + (y - b) ** 2 < r * r)) continue;
    lines.push(`${Math.floor(1e9 * x)} ${Math.floor(1e9 * y)}`);
  }
  return lines.join("\n") + "\n";
}

const middle = (times) => times.sort((a, b) => a - b)[times.length >> 1];
const tell = (name, times) =>
  console.log(`${name.padEnd(44)} ${middle(times).toFixed(1).padStart(8)}   (95 of 100 below ${times[Math.floor(0.95 * times.length)].toFixed(1)})`);

writeFileSync(join(folder, "p.xy"), points(Number(count)));
const html = join(folder, "p.html");
const began = performance.now();
execFileSync(rbpa, ["report", join(folder, "p.xy"), "-o", html, "-q"]);
console.log(`${count} points, ${cpus().length} × ${cpus()[0].model}; rbpa report ${((performance.now() - began) / 1000).toFixed(1)} s, ${(statSync(html).size / 1e6).toFixed(1)} MB`);

const browser = new Chromium(program);
const opened = performance.now();
const tab = await browser.open(`file://${html}`);
await tab.until(`document.getElementById("shape").dataset.state === "drawn"`);
console.log(`open, until all is drawn                     ${(performance.now() - opened).toFixed(0).padStart(8)}`);
console.log(`picture                                      ${await tab.value("`${page.raster.width} × ${page.raster.height}`")}`);

// A step of the slider: from the event to the end of the task behind the frame that shows it.
const steps = await tab.value(`(async () => {
  const slider = document.getElementById("slider");
  const shown = () => new Promise((done) => requestAnimationFrame(() => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = done;
    port2.postMessage(0);
  }));
  const frames = [], script = [];
  for (let i = 0; i < 200; ++i) {
    await shown();
    const begin = performance.now();
    slider.value = 150 + 3 * i;
    slider.dispatchEvent(new Event("input"));
    const heard = performance.now();
    await shown();
    frames.push(performance.now() - begin);
    const again = performance.now();
    page.pending.step = true;
    page.draw();
    script.push(heard - begin + performance.now() - again);
  }
  return { frames, script };
})()`);
tell("step of the slider: script", steps.script);
tell("step of the slider: until its frame is over", steps.frames);
for (const [name, body] of Object.entries({
  "new view: numbers under all pixels": "page.lay()",
  "polygons as GeoJSON": "shapeAsGeojson(page)",
})) {
  const times = await tab.value(`(() => {
    const times = [];
    for (let i = 0; i < 10; ++i) {
      const begin = performance.now();
      ${body};
      times.push(performance.now() - begin);
    }
    return times;
  })()`);
  tell(name, times);
}
await browser.close();
rmSync(folder, { recursive: true });
