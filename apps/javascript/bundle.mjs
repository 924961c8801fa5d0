// bundle.mjs COMMON SOURCE MODULE OUTPUT: writes both sources to one file that contains the compressed WebAssembly
// module.
import { readFileSync, writeFileSync } from "node:fs";
import { constants, deflateRawSync } from "node:zlib";

const [common, source, module, output] = process.argv.slice(2);
const text = readFileSync(source, "utf8") + "\n" + readFileSync(common, "utf8");
if (text.split('"BASE64"').length !== 2) throw new Error(`${common}: expected "BASE64" once`);
const packed = deflateRawSync(readFileSync(module), { level: constants.Z_BEST_COMPRESSION, memLevel: 9 });
writeFileSync(output, text.replace('"BASE64"', JSON.stringify(packed.toString("base64"))));
