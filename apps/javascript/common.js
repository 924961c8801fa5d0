/** The common part of both modules. bundle.mjs appends this file to the source of each module, and inserts the
* compressed WebAssembly module. */

const wasm = "BASE64";

let compiled;  // a promise of the compiled module, which all instances share

/** Returns a new instance of the WebAssembly module. */
async function instance() {
  compiled ??= unpacked(wasm).then(WebAssembly.compile);
  const module = await compiled;
  let exports;
  const imports = { rbpa: { text } };
  function text(value, at, room) {
    const bytes = new TextEncoder().encode(String(value));
    if (bytes.length > room) return -1;
    new Uint8Array(exports.memory.buffer, at >>> 0).set(bytes);
    return bytes.length;
  }
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    if (from !== "rbpa")
      (imports[from] ??= {})[name] = () => {
        if (name === "proc_exit") throw new Error("rbpa: the module ended, which is a bug (report it with the input)");
        return 0;
      };
  exports = (await WebAssembly.instantiate(module, imports)).exports;
  exports._initialize?.();
  return exports;
}

async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Response(stream).arrayBuffer();
}

export class InvalidInput extends Error {
  name = "InvalidInput";
}

/** Returns the coordinates of points as a flat array of numbers; returns an array that is already flat unchanged. */
function flat(points, dimension, name) {
  if (points == null || typeof points.length !== "number")
    throw new InvalidInput(`${name}: found ${points}, expected an array of points or of numbers`);
  if (ArrayBuffer.isView(points) || typeof points[0] === "number" || points.length === 0) {
    if (points.length % dimension !== 0)
      throw new InvalidInput(`${name}: found ${points.length} numbers, expected ${dimension} for each point`);
    return points;
  }
  const numbers = new Float64Array(dimension * points.length);
  for (let i = 0; i < points.length; ++i) {
    const point = points[i];
    if (point == null || typeof point[0] !== "number")
      throw new InvalidInput(`${name}: found ${JSON.stringify(point)} at ${i}, expected ${dimension} numbers`);
    for (let k = 0; k < dimension; ++k) numbers[dimension * i + k] = point[k];
  }
  return numbers;
}

/** Throws InvalidInput unless value is a number for which fits(value) is true. */
function check(value, name, fits, expected) {
  if (typeof value !== "number" || !fits(value)) throw new InvalidInput(`${name}: found ${JSON.stringify(value) ?? value}, expected ${expected}`);
}

/** Calls the functions of one instance. */
class Module {
  #wasm;
  constructor(exports) {
    this.#wasm = exports;
  }

  get memoryBytes() {
    return this.#wasm.memory.buffer.byteLength;
  }

  /** Calls a function of the module with arrays of numbers or texts, then the number of points, then other numbers.
  * Returns read(this), which copies the results. Frees all memory of the call. */
  call(name, arrays, count, numbers, read) {
    const places = [];
    try {
      for (const array of arrays) places.push(array === null ? 0 : this.#copyIn(array));
      if (!this.#wasm[name](...places, count, ...numbers)) throw this.#error();
      return read(this);
    } finally {
      for (const at of places) this.#wasm.rbpa_release(at);
      this.#wasm.rbpa_clear();
    }
  }

  /** Return result i of the last call as a copy. */
  doubles = (i) => this.#copyOut(Float64Array, i);
  indices = (i) => this.#copyOut(Uint32Array, i);
  integers = (i) => this.#copyOut(Int32Array, i);

  #copyIn(given) {
    const isText = typeof given === "string";
    const array = isText ? new TextEncoder().encode(`${given}\0`) : given;
    const Type = isText ? Uint8Array : Float64Array;
    const at = this.#wasm.rbpa_allocate(Type.BYTES_PER_ELEMENT * array.length) >>> 0;
    if (at === 0 && array.length > 0) throw new RangeError("rbpa: out of memory: WebAssembly has at most 4 GiB");
    new Type(this.#wasm.memory.buffer, at, array.length).set(array);
    return at;
  }
  // Makes a new view for each copy, as the memory may have grown.
  #copyOut(Type, i) {
    const length = (this.#wasm.rbpa_bytes(i) >>> 0) / Type.BYTES_PER_ELEMENT;
    return new Type(this.#wasm.memory.buffer, this.#wasm.rbpa_result(i) >>> 0, length).slice();
  }
  #error() {
    const bytes = new Uint8Array(this.#wasm.memory.buffer, this.#wasm.rbpa_message() >>> 0);
    const message = new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    return message.startsWith("out of memory") ? new RangeError(`rbpa: ${message}`) : new InvalidInput(message);
  }
}
