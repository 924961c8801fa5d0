// What: decodes the data of the page of points in space from base64 to typed arrays, and lists the triangles of a step.
//       docs/reference/file_formats.md has the format.
"use strict";

/** Decodes the data of the page. text(name) returns the content of the element with the data called `name`. */
function decodeSpace(text) {
  const facts = JSON.parse(text("facts"));
  const points = doublesOf(bytesOf(text("points")));
  const numbers = new WholeNumbers(bytesOf(text("triangles")));
  const walls = { corners: new Uint32Array(3 * facts.triangles), steps: new Uint16Array(3 * facts.triangles) };
  let corner = 0;
  for (let at = 0; at < walls.corners.length; at += 3) {
    for (let k = 0; k < 3; ++k) walls.corners[at + k] = corner += numbers.nextSigned();
    let step = 0;
    for (let k = 0; k < 3; ++k) walls.steps[at + k] = step += numbers.next();
  }
  const changes = new WholeNumbers(bytesOf(text("counts")));
  const counts = ["tetrahedra", "components", "tunnels", "voids"].map(() => new Float64Array(facts.steps));
  for (let step = 0; step < facts.steps; ++step)
    for (const count of counts) count[step] = (step > 0 ? count[step - 1] : 0) + changes.nextSigned();
  const [tetrahedra, components, tunnels, voids] = counts;
  const pairs = doublesOf(bytesOf(text("pairs")));
  return {
    facts,
    points,
    radii: doublesOf(bytesOf(text("radii"))),
    walls,
    counts: { tetrahedra, components, tunnels, voids },
    pairs: Array.from({ length: facts.dots }, (_, i) => ({ dimension: pairs[3 * i], birth: pairs[3 * i + 1], death: pairs[3 * i + 2] })),
    representatives: facts.representatives.map((one) => ({ ...one, death: one.death === null ? Infinity : radiusOf(one.death) })),
  };
}

/** Writes the corners of the triangles of a step: of triangles with a tetrahedron on one side into `boundary`, of
 *  triangles with none into `dangling`. Returns the number of corners in each. */
function fillCorners({ corners, steps }, step, boundary, dangling) {
  let bounds = 0, dangles = 0;
  for (let at = 0; at < corners.length; at += 3) {
    if (step < steps[at] || step >= steps[at + 2]) continue;
    if (step >= steps[at + 1]) {
      boundary[bounds++] = corners[at];
      boundary[bounds++] = corners[at + 1];
      boundary[bounds++] = corners[at + 2];
    } else {
      dangling[dangles++] = corners[at];
      dangling[dangles++] = corners[at + 1];
      dangling[dangles++] = corners[at + 2];
    }
  }
  return [bounds, dangles];
}
