// run.mjs PACKAGE TEST…: packs the package, installs it into an empty folder, and runs the tests there.
import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { gzipSync } from "node:zlib";

const [source, ...tests] = process.argv.slice(2).map((path) => resolve(path));
const folder = mkdtempSync(join(tmpdir(), "rbpa-npm-"));
const npm = (...options) => execFileSync("npm", [...options, "--offline", "--no-audit", "--no-fund"], { cwd: folder, encoding: "utf8" });
const packed = npm("pack", source, "--silent").trim().split("\n").at(-1);
writeFileSync(join(folder, "package.json"), '{ "name": "user", "private": true, "type": "module" }\n');
npm("install", join(folder, packed), "--silent");
const zipped = (name) => gzipSync(readFileSync(join(source, name)), { level: 9 }).length;
console.log(`${packed}: ${statSync(join(folder, packed)).size} bytes; gzip: index.js ${zipped("index.js")}, space.js ${zipped("space.js")}`);
for (const test of tests) copyFileSync(test, join(folder, basename(test)));
const { status } = spawnSync(process.execPath, ["--test", ...tests.map((test) => basename(test))], { cwd: folder, stdio: "inherit" });
rmSync(folder, { recursive: true });
process.exit(status ?? 1);
