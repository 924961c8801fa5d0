// Tests the package in Chromium. RBPA_CHROMIUM is the program, RBPA_CHROMIUM_DRIVER the module that drives it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";

const program = process.env.RBPA_CHROMIUM;

test("modules load and compute in a browser", { skip: !program && "no Chromium" }, async () => {
  const { Chromium } = await import(process.env.RBPA_CHROMIUM_DRIVER);
  const server = createServer(async ({ url }, response) => {
    if (url === "/") return response.setHeader("content-type", "text/html").end("<!doctype html><title>rbpa</title>");
    response.setHeader("content-type", "text/javascript");
    response.end(await readFile(join("node_modules", "rbpa", url)).catch(() => ""));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const browser = new Chromium(program);
  try {
    const tab = await browser.open(`http://127.0.0.1:${server.address().port}/`);
    const shape = await tab.value(`import("/index.js").then(async ({ load }) => {
      const rbpa = await load();
      const { area, alpha, polygons } = rbpa.alphaShape([[0, 0], [4, 0], [4, 4], [2, 3], [0, 4]]);
      const coords = Float64Array.from({ length: 200000 }, (_, i) => Math.sin(i * i));
      return [area, alpha, polygons.length, new rbpa.Delaunator(coords).triangles.length > 500000];
    })`);
    assert.deepEqual(shape, [14, 2.475532017624376, 1, true]);
    const triangles = await tab.value(`import("/space.js").then(async ({ load }) => {
      const rbpa = await load();
      const points = Array.from({ length: 500 }, (_, i) => {
        const z = (2 * i + 1) / 500 - 1, r = Math.sqrt(1 - z * z);
        return [r * Math.cos(2.4 * i), r * Math.sin(2.4 * i), z];
      });
      return rbpa.surface(points, 0.4).triangles.length / 3;
    })`);
    assert.equal(triangles, 996);
  } finally {
    await browser.close();
    server.close();
  }
});
