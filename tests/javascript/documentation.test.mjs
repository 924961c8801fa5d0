// Runs the blocks of JavaScript in the documentation, and compares their results with the texts behind "// ->".
// RBPA_DOCUMENTS has the paths, separated by ":".
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

let checked = 0;
for (const path of (process.env.RBPA_DOCUMENTS ?? "").split(":").filter(Boolean))
  for (const [, block] of readFileSync(path, "utf8").matchAll(/```js\n([\s\S]*?)```/g))
    test(`${path}: ${block.split("\n")[0]}`, async () => {
      const body = block
        .replace(/import \{ load \} from "(.*)";/g, 'const { load } = await import("$1");')
        .replace(/^(?!const )(.*);( *)\/\/ -> (.*)$/gm, (_, call, __, expected) => `check(${call}, ${expected});`);
      const check = (actual, expected) => {
        ++checked;
        assert.deepEqual(ArrayBuffer.isView(actual) ? Array.from(actual) : actual, expected);
      };
      await new (Object.getPrototypeOf(async () => {}).constructor)("check", body)(check);
    });
test("something is checked", { skip: !process.env.RBPA_DOCUMENTS }, () => assert.ok(checked >= 10));
