// bench.mjs PACKAGE PEERS: compares Delaunator of the package in folder PACKAGE with delaunator and concaveman in the
// node_modules of folder PEERS, alternating in one process. Prints milliseconds, the least of several runs with new
// points.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, peers] = process.argv.slice(2).map((path) => resolve(path));
const find = createRequire(join(peers, "package.json"));
const load = async (name) => (await import(pathToFileURL(find.resolve(name)))).default;
const rbpa = await (await import(pathToFileURL(join(folder, "index.js")))).load();
const Delaunator = await load("delaunator");
const concaveman = await load("concaveman");

const sets = {
  uniform: (n) => Float64Array.from({ length: 2 * n }, Math.random),
  gauss: (n) => Float64Array.from({ length: 2 * n }, () => Array.from({ length: 6 }, Math.random).reduce((a, b) => a + b)),
  grid: (n) => {
    const side = Math.round(Math.sqrt(n));
    return Float64Array.from({ length: 2 * side * side }, (_, i) => (i % 2 ? Math.floor(i / 2 / side) : (i >> 1) % side));
  },
};

function least(runs, make, ...calls) {
  const best = calls.map(() => Infinity);
  for (let run = 0; run < runs; ++run) {
    const input = make();
    calls.forEach((call, i) => {
      const start = performance.now();
      call(input);
      best[i] = Math.min(best[i], performance.now() - start);
    });
  }
  return best;
}

console.log("| points | count | rbpa ms | delaunator ms | delaunator / rbpa |\n|---|--:|--:|--:|--:|");
for (const [name, make] of Object.entries(sets))
  for (const n of [1000, 10000, 100000, 1000000]) {
    const [ours, theirs] = least(n < 100000 ? 30 : 8, () => make(n), (c) => new rbpa.Delaunator(c), (c) => new Delaunator(c));
    console.log(`| ${name} | ${n} | ${ours.toFixed(1)} | ${theirs.toFixed(1)} | ${(theirs / ours).toFixed(2)} |`);
  }
console.log("\n| points | count | rbpa concaveHull ms | concaveman ms | concaveman / rbpa |\n|---|--:|--:|--:|--:|");
for (const n of [1000, 10000, 100000]) {
  const pairs = () => Array.from({ length: n }, () => [Math.random(), Math.random()]);
  const [ours, theirs] = least(5, pairs, (p) => rbpa.concaveHull(p), (p) => concaveman(p));
  console.log(`| uniform | ${n} | ${ours.toFixed(1)} | ${theirs.toFixed(1)} | ${(theirs / ours).toFixed(2)} |`);
}
