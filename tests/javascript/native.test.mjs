// Compares the package with the native program rbpa on files of points. RBPA_PROGRAM is the program, RBPA_POINTS the
// folders, separated by ":".
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "rbpa";
import { load as loadSpace } from "rbpa/space";

const program = process.env.RBPA_PROGRAM;
const folders = (process.env.RBPA_POINTS ?? "").split(":").filter(Boolean);
const most = Number(process.env.RBPA_MOST_POINTS ?? 20000);

function readPoints(path, columns) {
  const coords = [];
  for (const line of readFileSync(path, "utf8").split("\n")) {
    const row = line.replace(/#.*/, "").trim();
    if (row) coords.push(...row.split(/[\s,]+/).slice(0, columns).map(Number));
  }
  return coords;
}

/** Reads an .npy array of 32-bit numbers. */
function readNpy(path) {
  const bytes = readFileSync(path);
  return new Uint32Array(bytes.buffer.slice(bytes.byteOffset + 10 + bytes.readUInt16LE(8), bytes.byteOffset + bytes.length));
}

const files = (ending) =>
  folders.flatMap((folder) => readdirSync(folder).filter((name) => name.endsWith(ending)).map((name) => join(folder, name)));

test("sets of the plane have the triangles of the program", { skip: !program && "no program for this machine" }, async () => {
  const rbpa = await load();
  const folder = mkdtempSync(join(tmpdir(), "rbpa-"));
  let compared = 0;
  for (const path of files(".xy")) {
    const coords = readPoints(path, 2);
    if (coords.length / 2 > most || coords.some(Number.isNaN)) continue;
    for (const alpha of ["inf", "auto", "min"]) {
      const out = join(folder, "t.npy");
      execFileSync(program, ["mesh", path, "--alpha", alpha, "-o", out, "-q"]);
      const made = alpha === "inf" ? rbpa.alphaComplex(coords) : rbpa.alphaShape(coords, alpha);
      assert.deepEqual(made.triangles, readNpy(out), `${path}, alpha ${alpha}`);
      ++compared;
    }
  }
  rmSync(folder, { recursive: true });
  assert.ok(compared >= 60, `only ${compared} sets were compared`);
});

test("points in space have the surface of the program", { skip: !program && "no program for this machine" }, async () => {
  const rbpa = await loadSpace();
  const folder = mkdtempSync(join(tmpdir(), "rbpa-"));
  const path = files("c3_pcl_tum_rabbit.xyz")[0];
  const points = readPoints(path, 3);
  for (const radius of ["3", "8"]) {
    const out = join(folder, "t.npy");
    execFileSync(program, ["surface", path, "--radius", radius, "--normals", "estimate", "-o", out, "-q"]);
    const { triangles } = rbpa.surface(points, Number(radius));
    assert.deepEqual(triangles, readNpy(out));
    assert.ok(triangles.length > 10000);
  }
  rmSync(folder, { recursive: true });
});
