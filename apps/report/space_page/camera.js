// What: provides a perspective camera around a center, which drags and keys turn, move and zoom. Matrices are for
//       WebGL, column by column.
"use strict";

const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const unit = (v) => v.map((x) => x / Math.hypot(...v));

class OrbitCamera {
  constructor() {
    this.fit();
  }

  /** Returns to the first view: from the side and above, with z up and the cube from −1 to 1 in sight. */
  fit() {
    const from = [1.5, -2.8, 2];
    this.back = unit(from);
    this.right = unit(cross([0, 0, 1], this.back));
    this.distance = Math.hypot(...from);
    this.shift = [0, 0];
  }

  zoom(factor) {
    this.distance = Math.min(50, Math.max(0.02, this.distance / factor));
  }

  /** Turns the scene around the axes of the picture, to the left and up, by angles in radians. */
  turn(across, up) {
    const turned = (v, w, angle) => unit(v.map((x, k) => x * Math.cos(angle) + w[k] * Math.sin(angle)));
    const back = turned(this.back, this.right, across);
    this.right = turned(this.right, this.back, -across);
    this.back = turned(back, cross(this.right, back), up);
    this.right = unit(cross(cross(this.back, this.right), this.back));
  }

  /** Moves the scene to the right and up, in shares of the height of the picture. */
  move(across, up) {
    const height = 2 * this.distance * Math.tan(OrbitCamera.halfAngle);
    this.shift = [this.shift[0] + across * height, this.shift[1] + up * height];
  }

  view() {
    const { right, back } = this, up = cross(back, right);
    const column = (k) => [right[k], up[k], back[k], 0];
    return Float32Array.of(...column(0), ...column(1), ...column(2), ...this.shift, -this.distance, 1);
  }

  projection(aspect) {
    const near = Math.max(0.005, this.distance - 2), far = this.distance + 2;
    const scale = 1 / Math.tan(OrbitCamera.halfAngle);
    return Float32Array.of(
      scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0);
  }
}
OrbitCamera.halfAngle = (20 * Math.PI) / 180;

/** Lets drags turn the camera, or move it with another button or shift. Wheels zoom; two fingers zoom and move. Calls
 *  `changed` after each change. */
function steerByPointers(canvas, camera, changed) {
  const pointers = new Map();
  const spread = () => {
    const [[ax, ay], [bx, by]] = [...pointers.values()];
    return { size: Math.hypot(ax - bx, ay - by), x: (ax + bx) / 2, y: (ay + by) / 2 };
  };
  canvas.style.touchAction = "none";
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (last === undefined) return;
    const height = canvas.clientHeight || 1;
    const before = pointers.size === 2 ? spread() : null;
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (before !== null) {
      const after = spread();
      if (before.size > 0 && after.size > 0) camera.zoom(after.size / before.size);
      camera.move((after.x - before.x) / height, (before.y - after.y) / height);
    } else if (pointers.size === 1) {
      const across = (event.clientX - last[0]) / height, up = (last[1] - event.clientY) / height;
      if (event.buttons > 1 || event.shiftKey) camera.move(across, up);
      else camera.turn(-4 * across, 4 * up);
    }
    changed();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, canvas.clientHeight][event.deltaMode];
    camera.zoom(Math.exp(Math.max(-1, Math.min(1, -pixels / 500))));
    changed();
  }, { passive: false });
}
