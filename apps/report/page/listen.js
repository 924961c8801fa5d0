// What: connects slider, keys, mouse and touch to the page.
"use strict";

function listen(page) {
  addEventListener("resize", () => page.resize());
  listenToRatio(page);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    page.takeColors();
    page.drawPlots();
    page.ask("step");
  });
  listenToRadius(page);
  listenToPlots(page);
  listenToPicture(page);
  for (const [id, name] of [["show-edges", "edges"], ["show-isolated", "isolated"], ["show-free-edges", "freeEdges"]])
    element(id).addEventListener("change", (event) => {
      page.shown[name] = event.target.checked;
      page.ask("step");
    });
  element("save-geojson").addEventListener("click", () => saveFile(page, "geojson", "application/geo+json", shapeAsGeojson(page)));
  element("save-svg").addEventListener("click", () => saveFile(page, "svg", "image/svg+xml", viewAsSvg(page)));
}

/** Resizes the canvases when the window moves to a screen with another number of device pixels for each CSS pixel. */
function listenToRatio(page) {
  const same = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  const changed = () => {
    page.resize();
    listenToRatio(page);
  };
  same.addEventListener("change", changed, { once: true });
}

function listenToRadius(page) {
  const slider = element("slider");
  slider.addEventListener("input", () => page.goToPosition(Number(slider.value)));
  const far = () => Math.max(1, Math.round(page.complex.steps / 50));
  const moves = {
    ArrowLeft: () => page.step - 1, ArrowDown: () => page.step - 1,
    ArrowRight: () => page.step + 1, ArrowUp: () => page.step + 1,
    PageDown: () => page.step - far(), PageUp: () => page.step + far(),
    Home: () => 0, End: () => page.complex.steps - 1,
  };
  slider.addEventListener("keydown", (event) => {
    if (!(event.key in moves) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    page.goTo(moves[event.key]());
  });
  element("previous").addEventListener("click", () => page.goTo(page.step - 1));
  element("next").addEventListener("click", () => page.goTo(page.step + 1));
  element("radius").addEventListener("change", (event) => {
    const text = event.target.value.trim();
    const alpha = /^inf(inity)?$/i.test(text) ? Infinity : Number(text);
    if (text === "" || !(alpha > 0)) {
      page.tellRadiusError("Expected a radius: a number > 0, or inf.");
      return;
    }
    page.goToAlpha(alpha);
  });
}

function listenToPlots(page) {
  const canvas = element("counts-plot");
  const follow = (event) => {
    const x = event.clientX - canvas.getBoundingClientRect().left;
    page.goTo(page.complex.stepAt(page.countsPlot.axis.radiusAt(x)));
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    follow(event);
  });
  canvas.addEventListener("pointermove", (event) => event.buttons > 0 && follow(event));
  element("diagram").addEventListener("click", (event) => {
    const box = event.target.getBoundingClientRect();
    page.choosePair(page.diagram.pairNear(event.clientX - box.left, event.clientY - box.top), true);
  });
}

function listenToPicture(page) {
  const { canvas } = page;
  const fingers = new Map();
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: (event.clientX - box.left) * page.ratio, y: (event.clientY - box.top) * page.ratio };
  };
  let moved = 0;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add("held");
    if (fingers.size === 0) moved = 0;
    fingers.set(event.pointerId, place(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    fingers.set(event.pointerId, now);
    moved += Math.hypot(now.x - before.x, now.y - before.y);
    if (moved < 4 * page.ratio) return;
    page.move((view) => {
      if (others.length === 0) return view.pan(now.x - before.x, now.y - before.y);
      const [other] = others;
      const apart = (at) => Math.max(1, Math.hypot(at.x - other.x, at.y - other.y));
      view.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
      view.zoom(apart(now) / apart(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
    });
  });
  const end = (event) => {
    if (!fingers.delete(event.pointerId)) return;
    if (fingers.size === 0) canvas.classList.remove("held");
    if (event.type === "pointerup" && moved < 4 * page.ratio) page.chooseAt(place(event));
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const { x, y } = place(event);
      const pixels = event.deltaMode === 1 ? 30 * event.deltaY : event.deltaY;
      page.move((view) => view.zoom(Math.exp(-0.002 * Math.max(-300, Math.min(300, pixels))), x, y));
    },
    { passive: false },
  );
  const middle = (factor) => page.move((view) => view.zoom(factor, view.width / 2, view.height / 2));
  const step = () => 60 * page.ratio;
  const keys = {
    "+": () => middle(1.5), "=": () => middle(1.5), "-": () => middle(1 / 1.5),
    0: () => page.move((view) => view.fit()),
    1: () => page.fitShape(),
    ArrowLeft: () => page.move((view) => view.pan(step(), 0)),
    ArrowRight: () => page.move((view) => view.pan(-step(), 0)),
    ArrowUp: () => page.move((view) => view.pan(0, step())),
    ArrowDown: () => page.move((view) => view.pan(0, -step())),
    Escape: () => page.choosePair(-1, false),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in keys) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  element("zoom-in").addEventListener("click", keys["+"]);
  element("zoom-out").addEventListener("click", keys["-"]);
  element("fit").addEventListener("click", keys[0]);
  element("fit-shape").addEventListener("click", keys[1]);
}
