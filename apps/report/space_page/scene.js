// What: the picture that can be turned: triangles, points, and what is chosen. three.js draws it.
"use strict";

class SpaceScene {
  /** Throws where there is no WebGL. */
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(40, 1, 0.01, 100);
    this.takePlaces();
    const light = new THREE.DirectionalLight(0xffffff, 2.2);
    light.position.set(-0.5, 0.7, 1);
    this.camera.add(light);
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 1.1));
    this.boundary = this.addTriangles();
    this.dangling = this.addTriangles();
    this.chosenSurface = this.addTriangles();
    this.pointsGeometry = new THREE.BufferGeometry();
    this.pointsGeometry.setAttribute("position", this.places);
    this.dots = new THREE.Points(this.pointsGeometry, new THREE.PointsMaterial({ size: 2, sizeAttenuation: false }));
    this.dots.visible = false;
    this.lines = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ depthTest: false, transparent: true }));
    this.lines.geometry.setAttribute("position", this.places);
    this.lines.renderOrder = 2;
    this.lines.visible = false;
    for (const object of [this.dots, this.lines]) {
      object.frustumCulled = false;
      this.scene.add(object);
    }
    this.controls = new THREE.TrackballControls(this.camera, canvas);
    this.controls.rotateSpeed = 3;
    this.controls.staticMoving = true;
    this.controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("pointermove", () => this.controls.update());
    canvas.addEventListener("wheel", () => requestAnimationFrame(() => this.controls.update()), { passive: true });
    this.fit();
  }

  /** Places in a cube from −1 to 1, whatever the coordinates are. */
  takePlaces() {
    const { points } = this.data;
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
    const size = Math.max(...high.map((h, k) => h / 2 - low[k] / 2)) || 1;
    const places = new Float32Array(points.length);
    for (let i = 0; i < points.length; ++i) places[i] = (points[i] - (low[i % 3] / 2 + high[i % 3] / 2)) / size;
    this.places = new THREE.BufferAttribute(places, 3);
  }

  addTriangles() {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", this.places);
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ flatShading: true, side: THREE.DoubleSide }));
    mesh.frustumCulled = false;
    mesh.visible = false;
    this.scene.add(mesh);
    return mesh;
  }

  setColours({ paper, solid, dangling, text, tunnels, voids, components }) {
    this.renderer.setClearColor(new THREE.Color(paper));
    this.boundary.material.color.set(solid);
    this.dangling.material.color.set(dangling);
    this.chosenSurface.material.color.set(voids);
    this.dots.material.color.set(text);
    this.lineColours = [components, tunnels, voids];
    this.draw();
  }

  /** The triangles of a step. Returns how many there are of each kind. */
  show(step) {
    const { walls } = this.data;
    const size = walls.corners.length;
    this.corners = this.corners ?? [new Uint32Array(size), new Uint32Array(size)];
    const counts = fillCorners(walls, step, ...this.corners);
    [this.boundary, this.dangling].forEach((mesh, i) => {
      const { geometry } = mesh;
      if (geometry.index === null) {
        const index = new THREE.BufferAttribute(this.corners[i], 1);
        index.setUsage(35048); // DYNAMIC_DRAW
        geometry.setIndex(index);
      }
      geometry.index.clearUpdateRanges();
      geometry.index.addUpdateRange(0, counts[i]);
      geometry.index.needsUpdate = true;
      geometry.setDrawRange(0, counts[i]);
    });
    this.counts = counts.map((count) => count / 3);
    this.setVisible(this.visible);
    return this.counts;
  }

  setVisible(visible) {
    this.visible = visible;
    this.boundary.visible = visible.boundary && this.counts[0] > 0;
    this.dangling.visible = visible.dangling && this.counts[1] > 0;
    this.dots.visible = visible.points || this.hasChoice === true;
    for (const { material } of [this.boundary, this.dangling]) {
      const isThin = visible.seeThrough;
      if (material.transparent !== isThin) material.needsUpdate = true;
      material.transparent = isThin;
      material.opacity = isThin ? 0.25 : 1;
      material.depthWrite = !isThin;
    }
    this.draw();
  }

  /** The cycle, edge or surface of a representative, with the points around it; null: none. */
  choose(one) {
    this.hasChoice = one !== null;
    this.dots.visible = this.visible.points || this.hasChoice;
    const mesh = this.chosenSurface, { lines } = this;
    mesh.visible = one !== null && one.dimension === 2;
    lines.visible = one !== null && one.dimension < 2;
    if (one !== null) {
      const index = new THREE.BufferAttribute(new Uint32Array(one.cells), 1);
      (one.dimension === 2 ? mesh : lines).geometry.setIndex(index);
      lines.material.color.set(this.lineColours[one.dimension]);
    }
    this.draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    this.controls.handleResize();
    this.draw();
  }

  fit() {
    this.controls.reset();
    this.camera.position.set(1.5, -2.8, 2);
    this.camera.up.set(0, 0, 1);
    this.controls.target.set(0, 0, 0);
    this.camera.lookAt(this.controls.target);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  /** Around the axes of the picture, in radians. */
  turn(across, up) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const right = arm.clone().cross(this.camera.up).normalize().negate();
    arm.applyAxisAngle(this.camera.up, across).applyAxisAngle(right, up);
    this.camera.up.applyAxisAngle(right, up);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.draw();
  }

  draw() {
    if (this.pending) return;
    this.pending = true;
    this.canvas.dataset.state = "asked";
    requestAnimationFrame(() => {
      this.pending = false;
      this.renderer.render(this.scene, this.camera);
      this.canvas.dataset.state = "drawn";
    });
  }
}
