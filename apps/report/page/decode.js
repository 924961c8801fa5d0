// What: decodes the data of the page from base64 to typed arrays, and searches sorted radii.
//       docs/reference/file_formats.md has the format.
"use strict";

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Returns the little-endian doubles in `bytes`. */
function doublesOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return Float64Array.from({ length: bytes.byteLength / 8 }, (_, i) => view.getFloat64(8 * i, true));
}

/** Reads whole numbers with seven bits in each byte, the lowest bits first. */
class WholeNumbers {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  next() {
    let value = 0;
    for (let weight = 1; ; weight *= 128) {
      if (this.at === this.bytes.length) throw new RangeError("the data of this page are cut off (write it again with rbpa report)");
      const byte = this.bytes[this.at++];
      value += (byte & 127) * weight;
      if (byte < 128) return value;
    }
  }

  /** Reads a signed number: 0, 1, 2, 3, … become 0, −1, 1, −2, … */
  nextSigned() {
    const value = this.next();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }
}

function trianglesOf(bytes, count) {
  const numbers = new WholeNumbers(bytes);
  const triangles = new Uint32Array(3 * count);
  for (let t = 0; t < triangles.length; t += 3) {
    const first = numbers.next();
    triangles[t] = first;
    triangles[t + 1] = first + numbers.next();
    triangles[t + 2] = first + numbers.next();
  }
  return triangles;
}

function countsOf(bytes, steps) {
  const numbers = new WholeNumbers(bytes);
  const names = ["triangles", "solidComponents", "components", "holes", "covered"];
  const counts = {};
  for (const name of names) counts[name] = new Uint32Array(steps);
  for (let step = 0; step < steps; ++step)
    for (const name of names) counts[name][step] = (step > 0 ? counts[name][step - 1] : 0) + numbers.nextSigned();
  return counts;
}

/** Reads edges in the order of the steps at which they appear. An edge is a side, 3 · triangle + corner, which runs
 *  from the corner to the next corner of the triangle. */
function freeEdgesOf(bytes, count) {
  const numbers = new WholeNumbers(bytes);
  const edges = { step: new Uint32Array(count), side: new Uint32Array(count) };
  let step = 0;
  for (let e = 0; e < count; ++e) {
    step += numbers.next();
    edges.step[e] = step;
    edges.side[e] = numbers.next();
  }
  return edges;
}

/** Reads pairs. A pair is alive from the step of its birth until before the step of its death; the step of death is the
 *  number of steps if the pair never dies. */
function pairsOf(bytes, facts) {
  const numbers = new WholeNumbers(bytes);
  const count = facts.componentPairs + facts.holePairs;
  const pairs = {
    count,
    dimension: new Uint8Array(count),
    birth: new Uint32Array(count),
    death: new Uint32Array(count),
    triangle: new Uint32Array(count),
  };
  for (let p = 0; p < count; ++p) {
    pairs.dimension[p] = p < facts.componentPairs ? 0 : 1;
    pairs.birth[p] = numbers.next();
    const life = numbers.next();
    pairs.death[p] = life === 0 ? facts.steps : pairs.birth[p] + life;
    pairs.triangle[p] = numbers.next();
  }
  return pairs;
}

/** Returns the radius that JSON has as `value`: Infinity for "inf", null for null (no radius). */
function radiusOf(value) {
  return value === "inf" ? Infinity : value;
}

/** Returns the index of the last of ascending radii that is at most alpha; −1 if none is. */
function lastAtMost(radii, alpha) {
  let low = 0, high = radii.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (radii[middle] <= alpha) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Decodes the data of the page. text(name) returns the content of the element with the data called `name`. */
function decode(text) {
  const facts = JSON.parse(text("facts"));
  return {
    facts,
    min: radiusOf(facts.min),
    auto: radiusOf(facts.auto),
    plateaus: facts.plateaus.map(({ alpha, from, to }) => ({ alpha: radiusOf(alpha), from: radiusOf(from), to: radiusOf(to) ?? Infinity })),
    points: doublesOf(bytesOf(text("points"))),
    triangles: trianglesOf(bytesOf(text("triangles")), facts.triangles),
    radii: doublesOf(bytesOf(text("radii"))),
    areas: doublesOf(bytesOf(text("areas"))),
    counts: countsOf(bytesOf(text("counts")), facts.steps),
    freeEdges: freeEdgesOf(bytesOf(text("free-edges")), facts.freeEdges),
    pairs: pairsOf(bytesOf(text("pairs")), facts),
  };
}
