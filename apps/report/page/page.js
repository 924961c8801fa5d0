// What: runs the page: its choices, its drawing, and its events.
"use strict";

const element = (id) => document.getElementById(id);

/** Returns a color of the style sheet, as text. */
const colorText = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** Returns "#rrggbb" as an opaque pixel. */
function pixelOf(text) {
  const bytes = new Uint8Array([1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16)).concat(255));
  return new Uint32Array(bytes.buffer)[0];
}

const maxPlateaus = 4; // the most plateaus among the choices
const snapDistance = 8; // in thousandths of the slider

class Page {
  constructor() {
    this.complex = new Complex(decode((name) => element(`data-${name}`).textContent));
    this.view = new View(this.complex.data.points);
    this.unit = this.complex.data.facts.unit;
    this.canvas = element("shape");
    this.context = this.canvas.getContext("2d", { alpha: false });
    this.snapshot = document.createElement("canvas");
    this.countsPlot = new CountsPlot(element("counts-plot"));
    this.diagram = new PersistenceDiagram(element("diagram"));
    this.shown = { edges: true, isolated: true, freeEdges: false };
    this.step = -1;
    this.alpha = 0;
    this.pair = -1;
    this.marked = new Uint8Array(this.complex.size);
    this.region = [];
    this.pending = { view: false, step: false };
    this.axis = LogAxis.of(this.complex.data.radii, this.complex.reach(), 0, 1000);
    this.takeColors();
    this.describe();
    this.listChoices();
    this.listPairs("hole-pairs", 1);
    this.listPairs("component-pairs", 0);
    listen(this);
    this.resize();
    const { plateaus, facts } = this.complex.data;
    // Begin at the best plateau, which does not depend on single points far from the others.
    if (plateaus.length > 0) this.goToAlpha(plateaus[0].alpha);
    else if (facts.recommended !== null) this.goToAlpha(radiusOf(facts.recommended.alpha));
    else this.goTo(this.complex.steps - 1);
    this.fitShape();
  }

  // ---- fixed

  takeColors() {
    const names = ["paper", "panel", "text", "faint", "grid", "fill", "edge", "line", "isolated", "holes", "free", "lit"];
    this.colors = Object.fromEntries(names.map((name) => [name, colorText(name)]));
    this.colors.litGap = colorText("lit-gap");
    this.pixelColors = Object.fromEntries(
      ["paper", "fill", "line", "isolated", "lit", "litGap"].map((name) => [name, pixelOf(this.colors[name])]),
    );
  }

  describe() {
    const { facts, radii } = this.complex.data;
    const repeated = facts.points - facts.distinct;
    element("source").textContent = facts.source;
    element("radius-unit").textContent = facts.unit === null ? "" : ` in ${{ metre: "meters", foot: "feet", "US survey foot": "US survey feet", degree: "degrees" }[facts.unit]}`;
    const radiiText = radii.length === 0 ? "no triangle at any radius" : `${radii.length.toLocaleString("en")} critical radii, from ${short(radii[0])} to ${short(radii[radii.length - 1])}`;
    element("size").textContent =
      `${facts.points.toLocaleString("en")} points${repeated > 0 ? ` (${repeated.toLocaleString("en")} repeated)` : ""}, ${radiiText}`;
    for (const id of ["slider", "radius", "previous", "next"]) element(id).disabled = radii.length === 0;
  }

  listChoices() {
    const { min, auto, plateaus, facts } = this.complex.data;
    const most = facts.mostComponents;
    const share = facts.cover === 1 ? "every point" : `a share of ${facts.cover} of the points`;
    const choices = plateaus.slice(0, maxPlateaus).map(({ alpha, from, to }, i) => [
      i === 0 ? "plateau" : `plateau:${i + 1}`,
      alpha,
      `parts and holes hardly change from ${short(from)} to ${short(to)}`,
    ]);
    choices.push(["min", min, `the least alpha that covers ${share}`]);
    choices.push(["auto", auto, `the least alpha that covers ${share} in at most ${most} solid component${most === 1 ? "" : "s"}`]);
    this.choiceButtons = [];
    for (const [name, alpha, meaning] of choices) {
      if (alpha === null) continue;
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = `${name} ${short(alpha)}`;
      button.title = meaning;
      button.setAttribute("aria-label", `${name}: ${meaning}, ${short(alpha)}`);
      button.addEventListener("click", () => this.goToAlpha(alpha));
      element("choices").append(button);
      this.choiceButtons.push({ button, alpha });
    }
    const { recommended } = facts;
    if (recommended !== null)
      element("why").textContent = `Recommended: ${recommended.choice}, ${short(radiusOf(recommended.alpha))}: ${recommended.why}.`;
  }

  lifeOf(pair) {
    const { radii, pairs } = this.complex.data;
    const birth = radii[pairs.birth[pair]];
    if (pairs.death[pair] === radii.length) return `from ${short(birth)}, never ends`;
    const death = radii[pairs.death[pair]];
    return `${short(birth)} – ${short(death)} (×\u00a0${short(death / birth)})`;
  }

  listPairs(id, dimension) {
    this.pairButtons = this.pairButtons ?? new Map();
    for (const pair of longestPairs(this.complex, dimension, 8)) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = this.lifeOf(pair);
      button.setAttribute("aria-pressed", "false");
      button.addEventListener("click", () => this.choosePair(this.pair === pair ? -1 : pair, true));
      const item = document.createElement("li");
      item.append(button);
      element(id).append(item);
      this.pairButtons.set(pair, button);
    }
    if (element(id).childElementCount === 0) element(id).textContent = "none";
  }

  // ---- choices

  goTo(step) {
    const last = this.complex.steps - 1;
    this.show(Math.max(-1, Math.min(last, step)));
  }

  /** Moves to any alpha, and shows the step that contains it. */
  goToAlpha(alpha) {
    this.show(this.complex.stepAt(alpha), alpha);
  }

  /** Moves to a position of the slider, or to the alpha of a plateau if a plateau is near. */
  goToPosition(position) {
    const alphas = this.complex.data.plateaus.slice(0, maxPlateaus).map(({ alpha }) => alpha);
    const near = alphas.find((alpha) => Math.abs(this.axis.at(alpha) - position) < snapDistance);
    if (near !== undefined) this.goToAlpha(near);
    else this.goTo(this.complex.stepAt(this.axis.radiusAt(position)));
  }

  show(step, alpha = step < 0 ? 0 : this.complex.data.radii[step]) {
    this.step = step;
    this.alpha = alpha;
    this.tellNumbers();
    this.ask("step");
  }

  /** Chooses a pair, −1 for none. With `bring`, moves to a radius at which the pair is alive, and shows the pair. */
  choosePair(pair, bring) {
    this.pair = pair;
    for (const [other, button] of this.pairButtons) button.setAttribute("aria-pressed", String(other === pair));
    if (pair >= 0 && bring) {
      const { pairs } = this.complex.data;
      // A component is largest just before its death, a hole at its birth.
      const best = pairs.dimension[pair] === 0 ? pairs.death[pair] - 1 : pairs.birth[pair];
      if (!this.complex.isAlive(pair, this.step)) this.goTo(best);
      const region = this.complex.regionOf(pair, this.step);
      const corners = region.flatMap((t) => [...this.complex.triangles.subarray(3 * t, 3 * t + 3)]);
      if (this.view.bringToView(corners)) this.ask("view");
    }
    this.tellPair();
    this.ask("step");
  }

  tellNumbers() {
    const numbers = this.complex.numbersAt(this.step);
    const { pointCount } = this.complex;
    const share = pointCount === 0 ? 0 : (100 * numbers.covered) / pointCount;
    for (const name of ["triangles", "solidComponents", "components", "holes", "covered", "isolated"])
      element(name).textContent = numbers[name].toLocaleString("en");
    element("share").textContent = `${share.toFixed(share > 99 && share < 100 ? 2 : 1)} %`;
    element("area").textContent = areaText(numbers.area, this.unit);
    element("area").title = String(numbers.area);
    element("radius").value = String(this.alpha);
    for (const { button, alpha } of this.choiceButtons) button.setAttribute("aria-pressed", String(alpha === this.alpha));
    this.tellRadiusError("");
    const slider = element("slider");
    if (this.complex.stepAt(this.axis.radiusAt(Number(slider.value))) !== this.step)
      slider.value = this.step < 0 ? 0 : this.axis.at(this.alpha);
    slider.setAttribute("aria-valuetext", this.sentence(numbers));
    element("counts-cursor").style.left = `${this.step < 0 ? plotMargin.left : this.countsPlot.axis?.at(this.alpha)}px`;
    this.placeAlive();
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => (element("status").textContent = this.sentence(numbers)), 600);
  }

  sentence(numbers) {
    const counted = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;
    return (
      `alpha ${short(this.alpha)}: ${counted(numbers.triangles, "triangle")}, ` +
      `${counted(numbers.solidComponents, "solid component")}, ${counted(numbers.holes, "hole")}, ` +
      `${counted(numbers.isolated, "isolated point")}`
    );
  }

  tellRadiusError(text) {
    element("radius-error").textContent = text;
    element("radius").setAttribute("aria-invalid", String(text !== ""));
  }

  placeAlive() {
    if (!this.diagram.births) return;
    const { alpha } = this;
    const style = element("alive").style;
    style.width = `${this.step < 0 ? 0 : this.diagram.births.at(alpha) - plotMargin.left}px`;
    style.height = `${this.step < 0 ? 0 : this.diagram.deaths.at(alpha)}px`;
    const chosen = element("chosen");
    chosen.hidden = this.pair < 0;
    if (this.pair < 0) return;
    const { x, y } = this.diagram.placeOf(this.complex, this.pair);
    chosen.style.left = `${x}px`;
    chosen.style.top = `${y}px`;
  }

  tellPair() {
    this.placeAlive();
    if (this.pair < 0) {
      element("selection").textContent = "";
      return;
    }
    const kind = this.complex.data.pairs.dimension[this.pair] === 0 ? "Component" : "Hole";
    const here = this.complex.isAlive(this.pair, this.step) ? "lit in the picture" : "not there at this radius";
    element("selection").textContent = `${kind}, ${this.lifeOf(this.pair)}: ${here}.`;
  }

  // ---- drawing

  /** Requests a drawing before the next frame: "view" if the triangles under the pixels change, otherwise "step". */
  ask(what) {
    this.fine = null;
    this.canvas.dataset.state = "drawing";
    clearTimeout(this.finely);
    this.pending[what] = true;
    this.frame ??= requestAnimationFrame(() => {
      this.frame = null;
      this.draw();
    });
  }

  draw() {
    this.showScale();
    if (this.pending.view) {
      // Move the last picture until the view stands still if a view takes longer than a frame, as for large sets.
      if (this.held && this.layTime > 30) {
        this.moveSnapshot();
        clearTimeout(this.settling);
        this.settling = setTimeout(() => {
          this.held = false;
          this.ask("view");
        }, 120);
        return;
      }
      this.lay();
      this.held = false;
    }
    this.pending = { view: false, step: false };
    this.light(20000);
    this.paint(true, this.shown.isolated);
    this.finely = setTimeout(() => this.beginFine(), 150);
  }

  /** Returns the scale bar, at most 140 CSS pixels and at most a third of the picture long. */
  scaleBar() {
    return scaleBar(this.view, Math.min(140 * this.ratio, this.canvas.width / 3));
  }

  showScale() {
    const bar = this.scaleBar();
    element("scale-length").textContent = bar === null ? "" : lengthText(bar.length, this.unit);
    element("scale-bar").style.width = `${bar === null ? 0 : bar.pixels / this.ratio}px`;
    element("scale-bar").hidden = bar === null;
  }

  lay() {
    const begin = performance.now();
    const { view } = this;
    view.project();
    this.raster.lay(this.complex, view.x, view.y, view.spacing() > 8 ? 1 : 0);
    this.layTime = performance.now() - begin;
    this.laid = { scale: view.scale, left: view.left, top: view.top };
  }

  /** Marks the triangles of the chosen pair; marks none if there are more than `limit`. */
  light(limit) {
    for (const t of this.region) this.marked[t] = 0;
    this.region = (this.pair >= 0 && this.complex.regionOf(this.pair, this.step, limit)) || [];
    for (const t of this.region) this.marked[t] = 1;
  }

  paint(outline, dots) {
    const marked = this.region.length > 0 ? this.marked : null;
    this.raster.paint(this.pixels, this.complex.countAt(this.step), marked, this.pixelColors, { outline, dots });
    this.context.putImageData(this.image, 0, 0);
  }

  /** Draws lines on a separate canvas, and shows that canvas when all lines are drawn. */
  beginFine() {
    this.light(Infinity);
    this.tellPair();
    const canvas = this.snapshot;
    canvas.width = this.canvas.width;
    canvas.height = this.canvas.height;
    const context = canvas.getContext("2d", { alpha: false });
    const fill = (outline, dots) => {
      const marked = this.region.length > 0 ? this.marked : null;
      this.raster.paint(this.pixels, this.complex.countAt(this.step), marked, this.pixelColors, { outline, dots });
      context.putImageData(this.image, 0, 0);
    };
    const drawing = fineDrawing(context, this.complex, this.view, this.step, this.shown, this.colors, this.ratio, fill);
    this.fine = drawing;
    const go = () => {
      if (this.fine !== drawing) return;
      const end = performance.now() + 12;
      while (performance.now() < end) {
        if (!drawing.next().done) continue;
        this.context.drawImage(canvas, 0, 0);
        this.fine = null;
        this.canvas.dataset.state = "drawn";
        return;
      }
      setTimeout(go, 0);
    };
    go();
  }

  moveSnapshot() {
    if (!this.moving) {
      this.moving = document.createElement("canvas");
      this.moving.width = this.canvas.width;
      this.moving.height = this.canvas.height;
      this.moving.getContext("2d").drawImage(this.canvas, 0, 0);
      this.movingFrom = this.laid;
    }
    const by = this.view.scale / this.movingFrom.scale;
    this.context.fillStyle = this.colors.paper;
    this.context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.context.drawImage(this.moving, this.view.left - this.movingFrom.left * by, this.view.top - this.movingFrom.top * by, this.canvas.width * by, this.canvas.height * by);
  }

  resize() {
    const box = this.canvas.getBoundingClientRect();
    const ratioBefore = this.ratio ?? 1;
    this.ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(1, Math.round(box.width * this.ratio)), height = Math.max(1, Math.round(box.height * this.ratio));
    if (this.raster?.width !== width || this.raster.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.raster = new Raster(width, height);
      this.image = this.context.createImageData(width, height);
      this.pixels = new Uint32Array(this.image.data.buffer);
      this.view.resize(width, height, this.ratio / ratioBefore);
      this.ask("view");
    }
    this.drawPlots();
  }

  drawPlots() {
    this.countsPlot.draw(this.complex, this.colors);
    this.diagram.draw(this.complex, this.colors);
    this.tellNumbers();
  }

  // ---- events

  move(change) {
    if (!this.held) this.moving = null;
    this.held = true;
    change(this.view);
    this.ask("view");
  }

  /** Fits the view to the points in triangles at this radius. Other points may be far away. */
  fitShape() {
    this.move((view) => view.fit(this.complex.cornersAt(this.step)));
  }

  chooseAt({ x, y }) {
    const triangle = this.raster.at(Math.floor(x), Math.floor(y));
    this.choosePair(triangle < 0 ? -1 : this.complex.pairAt(triangle, this.step), false);
  }
}

const page = new Page();
