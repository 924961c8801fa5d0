// The site that docs/site/build.sh has made, in build/site: every link leads somewhere, and the page that computes does so, at a desk and on a telephone.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { dirname, extname, join, relative, resolve } from "node:path";
import { test } from "node:test";
import { Chromium } from "../apps/report/chromium.mjs";

const site = resolve(import.meta.dirname ?? dirname(new URL(import.meta.url).pathname), "../../build/site");
const files = new Set(readdirSync(site, { recursive: true }));
const ids = new Map();
function anchors(path) {
  if (!ids.has(path)) {
    const text = readFileSync(join(site, path), "utf8");
    ids.set(path, new Set([...text.matchAll(/\b(?:id|name)="([^"]*)"/g)].map(([, id]) => id)));
  }
  return ids.get(path);
}

test("every link of a page leads to a page and a place that there is", () => {
  const pages = [...files].filter((path) => path.endsWith(".html") && !path.startsWith("cpp/") && path !== "try.html");
  let checked = 0;
  const broken = [];
  for (const page of pages)
    for (const [, link] of readFileSync(join(site, page), "utf8").matchAll(/\b(?:href|src)="([^"]*)"/g)) {
      if (/^(https?:|mailto:|data:|\/\/)/.test(link) || link === "" || link === "#") continue;
      const [path, anchor] = decodeURI(link.replace(/&amp;/g, "&")).split("#");
      const target = path === "" ? page : relative(site, resolve(site, dirname(page), path.split("?")[0]));
      ++checked;
      if (!files.has(target) || (anchor && target.endsWith(".html") && !anchors(target).has(anchor))) broken.push(`${page}: ${link}`);
    }
  assert.deepEqual(broken, []);
  assert.ok(pages.length > 32 && checked > 1000, `only ${checked} links of ${pages.length} pages`);
});

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".png": "image/png" };
const server = createServer(async ({ url }, response) => {
  const path = decodeURIComponent(url.split("?")[0]);
  response.setHeader("content-type", types[extname(path)] ?? "text/plain");
  response.end(await readFile(join(site, path)).catch(() => ""));
});

test("pages look right at a desk and on a telephone, and one computes", async () => {
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const at = `http://127.0.0.1:${server.address().port}`;
  const browser = new Chromium(process.env.RBPA_CHROMIUM ?? "chromium");
  try {
    for (const screen of [{}, { width: 390, height: 844, ratio: 2, dark: true }]) {
      for (const page of ["index", "docs/explanation/space", "python_reference", "try"]) {
        const tab = await browser.open(`${at}/${page}.html`, screen);
        if (page === "try") await tab.until("'ready' in document.documentElement.dataset");
        assert.ok(await tab.value("document.documentElement.scrollWidth <= innerWidth"), `${page} is wider than the screen`);
        assert.ok(await tab.value("[...document.images].every((image) => image.naturalWidth > 0)"), `a picture of ${page} is missing`);
        assert.deepEqual(tab.events.filter((event) => event.method === "Runtime.exceptionThrown"), []);
        if (page !== "try") continue;
        const facts = () => tab.value("document.getElementById('facts').textContent");
        assert.match(await facts(), /^6315 points, alpha [\d.]+: \d+ triangles, /);
        await tab.value("document.querySelector('[data-rule=auto]').click()");
        assert.match(await facts(), /, 1 polygon, /);
        const drop = (text) => tab.value(`(async () => {
          const data = new DataTransfer();
          data.items.add(new File([${JSON.stringify(text)}], "square.csv"));
          document.getElementById("picture").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
          await new Promise((done) => setTimeout(done, 200));
        })()`);
        await drop("x,y\n0,0\n2,0\n2,2\n0,2\n");
        assert.match(await facts(), /^4 points, alpha .*: 2 triangles, 1 polygon, 0 holes, area 4;/);
        await drop("nothing\n");
        assert.match(await facts(), /^square.csv: found 0 points, expected at least three lines of two numbers/);
      }
    }
  } finally {
    await browser.close();
    server.close();
  }
});
