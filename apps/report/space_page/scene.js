// What: draws the picture that can be turned, with WebGL 2: triangles, points, and the chosen representative.
"use strict";

/** The shaders. Faces are lit by their normals in the picture; points and lines have their own color. */
const vertexShader = `#version 300 es
uniform mat4 view, projection;
uniform float size;
in vec3 position;
out vec3 place;
void main() {
  vec4 seen = view * vec4(position, 1.0);
  place = seen.xyz;
  gl_Position = projection * seen;
  gl_PointSize = size;
}`;
const fragmentShader = `#version 300 es
precision highp float;
uniform vec4 color;
uniform bool isLit;
in vec3 place;
out vec4 result;
void main() {
  float light = 1.0;
  if (isLit) {
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    light = 0.35 + 0.7 * max(0.0, dot(normal, normalize(vec3(-0.5, 0.7, 1.0))));
  }
  result = vec4(min(color.rgb * light, 1.0), color.a);
}`;

/** Returns the components of "#rrggbb", from 0 to 1. */
const colorNumbers = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);

class SpaceScene {
  /** Prepares drawing on `canvas`. Throws if there is no WebGL 2. */
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    this.gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (this.gl === null) throw new Error("no WebGL 2");
    const nothing = () => ({ corners: new Uint32Array(0), count: 0, visible: false, color: [0, 0, 0] });
    const size = data.walls.corners.length;
    this.boundary = { ...nothing(), corners: new Uint32Array(size) };
    this.dangling = { ...nothing(), corners: new Uint32Array(size) };
    this.chosenSurface = nothing();
    this.lines = nothing();
    this.dots = { visible: false, color: [0, 0, 0] };
    this.background = [1, 1, 1];
    this.camera = new OrbitCamera();
    this.prepare();
    steerByPointers(canvas, this.camera, () => this.draw());
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.prepare();
      this.draw();
    });
  }

  /** Makes the objects of the graphics card. Called again after the context was lost. */
  prepare() {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.bindAttribLocation(program, 0, "position");
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    this.uniforms = Object.fromEntries(["view", "projection", "size", "color", "isLit"].map((name) => [name, gl.getUniformLocation(program, name)]));
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, this.places(), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    for (const part of [this.boundary, this.dangling, this.chosenSurface, this.lines]) {
      part.buffer = gl.createBuffer();
      this.upload(part);
    }
  }

  /** Returns the positions of the points, scaled to a cube from −1 to 1 whatever the coordinates are. */
  places() {
    const { points } = this.data;
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
    const size = Math.max(...high.map((h, k) => h / 2 - low[k] / 2)) || 1;
    return Float32Array.from(points, (x, i) => (x - (low[i % 3] / 2 + high[i % 3] / 2)) / size);
  }

  upload({ buffer, corners, count }) {
    const { gl } = this;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, corners.subarray(0, count), gl.DYNAMIC_DRAW);
  }

  setColors({ paper, solid, dangling, text, tunnels, voids, components }) {
    this.background = colorNumbers(paper);
    this.boundary.color = colorNumbers(solid);
    this.dangling.color = colorNumbers(dangling);
    this.chosenSurface.color = colorNumbers(voids);
    this.dots.color = colorNumbers(text);
    this.lineColors = [components, tunnels, voids].map(colorNumbers);
    this.draw();
  }

  /** Shows the triangles of a step. Returns the numbers of boundary and of dangling triangles. */
  show(step) {
    const { boundary, dangling } = this;
    [boundary.count, dangling.count] = fillCorners(this.data.walls, step, boundary.corners, dangling.corners);
    this.upload(boundary);
    this.upload(dangling);
    this.counts = [boundary.count / 3, dangling.count / 3];
    this.setVisible(this.visible);
    return this.counts;
  }

  setVisible(visible) {
    this.visible = visible;
    this.boundary.visible = visible.boundary;
    this.dangling.visible = visible.dangling;
    this.dots.visible = visible.points || this.hasChoice === true;
    this.draw();
  }

  /** Shows the cycle, edge or surface of a representative, and all points; null shows none. */
  choose(one) {
    this.hasChoice = one !== null;
    this.chosenSurface.visible = one !== null && one.dimension === 2;
    this.lines.visible = one !== null && one.dimension < 2;
    if (one !== null) {
      const part = one.dimension === 2 ? this.chosenSurface : this.lines;
      part.corners = new Uint32Array(one.cells);
      part.count = part.corners.length;
      this.upload(part);
      this.lines.color = this.lineColors[one.dimension];
    }
    this.setVisible(this.visible);
  }

  resize() {
    const ratio = Math.min(2, devicePixelRatio || 1);
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    this.draw();
  }

  fit() {
    this.camera.fit();
    this.draw();
  }

  zoom(factor) {
    this.camera.zoom(factor);
    this.draw();
  }

  turn(across, up) {
    this.camera.turn(across, up);
    this.draw();
  }

  draw() {
    if (this.pending) return;
    this.pending = true;
    this.canvas.dataset.state = "asked";
    requestAnimationFrame(() => {
      this.pending = false;
      this.render();
      this.canvas.dataset.state = "drawn";
    });
  }

  render() {
    const { gl, canvas, uniforms, camera, visible } = this;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...this.background, 1);
    gl.depthMask(true);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(uniforms.view, false, camera.view());
    gl.uniformMatrix4fv(uniforms.projection, false, camera.projection(canvas.width / canvas.height));
    gl.uniform1f(uniforms.size, 2 * Math.min(2, devicePixelRatio || 1));
    const draw = ({ buffer, count, color }, mode, isLit, opacity) => {
      const isThin = opacity < 1;
      (isThin ? gl.enable : gl.disable).call(gl, gl.BLEND);
      gl.depthMask(!isThin);
      gl.uniform4f(uniforms.color, ...color, opacity);
      gl.uniform1i(uniforms.isLit, isLit ? 1 : 0);
      if (buffer === undefined) return gl.drawArrays(mode, 0, this.data.points.length / 3);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
      gl.drawElements(mode, count, gl.UNSIGNED_INT, 0);
    };
    if (this.dots.visible) draw(this.dots, gl.POINTS, false, 1);
    if (this.chosenSurface.visible) draw(this.chosenSurface, gl.TRIANGLES, true, 1);
    for (const part of [this.boundary, this.dangling])
      if (part.visible) draw(part, gl.TRIANGLES, true, visible.seeThrough ? 0.25 : 1);
    gl.disable(gl.DEPTH_TEST);
    if (this.lines.visible) draw(this.lines, gl.LINES, false, 1);
  }
}
