// What: runs the page of points in space: its choices and its events.
"use strict";

const element = (id) => document.getElementById(id);
const colorText = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

class SpacePage {
  constructor() {
    this.data = decodeSpace((name) => element(`data-${name}`).textContent);
    this.step = -1;
    this.alpha = 0;
    this.chosen = null;
    try {
      this.scene = new SpaceScene(element("shape"), this.data);
      this.scene.visible = this.visible();
    } catch {
      element("no-picture").hidden = false;
      element("shape").dataset.state = "drawn";
    }
    this.diagram = new SpaceDiagram(element("diagram"), this.data);
    this.describe();
    this.listChoices();
    for (const dimension of [1, 2]) this.listPairs(dimension);
    this.listen();
    this.takeColors();
    const { auto, min, plateau } = this.data.facts;
    this.goToAlpha([plateau, min, auto].map(radiusOf).find((alpha) => alpha !== null && alpha < Infinity) ?? Infinity);
    this.resize();
  }

  // ---- fixed

  takeColors() {
    const names = ["paper", "panel", "text", "faint", "grid", "fill", "solid", "dangling", "components", "tunnels", "voids"];
    this.colors = Object.fromEntries(names.map((name) => [name, colorText(name)]));
    this.scene?.setColors(this.colors);
  }

  describe() {
    const { facts } = this.data;
    const repeated = facts.points - facts.distinct;
    element("source").textContent = facts.source;
    element("size").textContent =
      `${facts.points.toLocaleString("en")} points${repeated > 0 ? ` (${repeated.toLocaleString("en")} repeated)` : ""}, ` +
      `${facts.tetrahedra.toLocaleString("en")} tetrahedra, ${facts.pairs.toLocaleString("en")} pairs of the persistence`;
    element("slider").max = Math.max(0, facts.steps - 1);
    for (const id of ["slider", "radius", "previous", "next"]) element(id).disabled = facts.steps === 0;
  }

  listChoices() {
    const { cover } = this.data.facts;
    const share = cover === 1 ? "every point" : `a share of ${cover} of the points`;
    const choices = [
      ["plateau", this.data.facts.plateau, "parts and voids hardly change around it"],
      ["min", this.data.facts.min, `the least alpha that covers ${share}`],
      ["auto", this.data.facts.auto, `the least alpha that has ${share} in one piece`],
    ];
    this.choiceButtons = [];
    for (const [name, value, meaning] of choices) {
      const alpha = radiusOf(value);
      if (!Number.isFinite(alpha)) continue;
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = `${name} ${short(alpha)}`;
      button.title = meaning;
      button.addEventListener("click", () => this.goToAlpha(alpha));
      element("choices").append(button);
      this.choiceButtons.push({ button, alpha });
    }
  }

  textOf(one) {
    const life = `${short(one.birth)} – ${Number.isFinite(one.death) ? short(one.death) : "for ever"}`;
    return one.dimension === 2 ? `${life}, volume ${short(one.volume)}` : `${life}, length ${short(one.length)}`;
  }

  listPairs(dimension) {
    this.pairButtons = this.pairButtons ?? new Map();
    const all = this.data.representatives
      .filter((one) => one.dimension === dimension)
      .sort((a, b) => b.death - b.birth - (a.death - a.birth))
      .slice(0, 8);
    for (const one of all) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = this.textOf(one);
      button.setAttribute("aria-pressed", "false");
      button.addEventListener("click", () => this.choose(this.chosen === one ? null : one));
      const item = document.createElement("li");
      item.append(button);
      element(`pairs-${dimension}`).append(item);
      this.pairButtons.set(one, button);
    }
    if (all.length === 0) element(`pairs-${dimension}`).textContent = "none";
  }

  // ---- choices

  goTo(step) {
    const { radii } = this.data;
    const at = Math.max(-1, Math.min(radii.length - 1, step));
    this.show(at, at < 0 ? 0 : radii[at]);
  }

  /** Moves to the last step whose radius is at most `alpha`. */
  goToAlpha(alpha) {
    this.goTo(lastAtMost(this.data.radii, alpha));
  }

  show(step, alpha) {
    const start = performance.now();
    this.step = step;
    this.alpha = alpha;
    const inSight = this.scene ? this.scene.show(step) : [0, 0];
    const { counts } = this.data;
    for (const name of ["tetrahedra", "components", "tunnels", "voids"])
      element(name).textContent = (step < 0 ? 0 : counts[name][step]).toLocaleString("en");
    element("triangles").textContent = (inSight[0] + inSight[1]).toLocaleString("en");
    element("radius").value = String(alpha);
    element("radius").setAttribute("aria-invalid", "false");
    element("radius-error").textContent = "";
    element("slider").value = step;
    element("slider").setAttribute("aria-valuetext", short(alpha));
    for (const { button, alpha: its } of this.choiceButtons) button.setAttribute("aria-pressed", String(its === alpha));
    element("status").textContent = `alpha ${short(alpha)}: ${element("components").textContent} components, ${element("tunnels").textContent} tunnels, ${element("voids").textContent} voids`;
    this.diagram.draw(this.colors, alpha, this.chosen);
    this.milliseconds = performance.now() - start;
  }

  /** Chooses a representative (null for none). Moves to the birth of a tunnel or a void. */
  choose(one) {
    this.chosen = one;
    for (const [its, button] of this.pairButtons) button.setAttribute("aria-pressed", String(its === one));
    element("selection").textContent = one === null ? "" : `A ${dimensionNames[one.dimension]}: ${this.textOf(one)}.`;
    if (one !== null && one.dimension > 0) {
      if (!element("see-through").checked) {
        element("see-through").checked = true;
        this.scene?.setVisible(this.visible());
      }
      this.goToAlpha(one.birth);
    } else {
      this.diagram.draw(this.colors, this.alpha, one);
    }
    this.scene?.choose(one);
  }

  visible() {
    const is = (id) => element(id).checked;
    return { boundary: is("show-boundary"), dangling: is("show-dangling"), points: is("show-points"), seeThrough: is("see-through") };
  }

  // ---- events

  listen() {
    addEventListener("resize", () => this.resize());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.takeColors();
      this.diagram.draw(this.colors, this.alpha, this.chosen);
    });
    element("slider").addEventListener("input", (event) => this.goTo(Number(event.target.value)));
    element("previous").addEventListener("click", () => this.goTo(this.step - 1));
    element("next").addEventListener("click", () => this.goTo(this.step + 1));
    element("radius").addEventListener("change", (event) => this.take(event.target.value.trim()));
    element("diagram").addEventListener("click", (event) => {
      const box = event.target.getBoundingClientRect();
      this.choose(this.diagram.representativeNear(event.clientX - box.left, event.clientY - box.top));
    });
    for (const id of ["show-boundary", "show-dangling", "show-points", "see-through"])
      element(id).addEventListener("change", () => this.scene?.setVisible(this.visible()));
    element("save-png").addEventListener("click", () => this.savePicture());
    const angle = 0.15;
    const keys = {
      "+": () => this.scene.zoom(1.25), "=": () => this.scene.zoom(1.25), "-": () => this.scene.zoom(0.8), 0: () => this.scene.fit(),
      ArrowLeft: () => this.scene.turn(angle, 0), ArrowRight: () => this.scene.turn(-angle, 0),
      ArrowUp: () => this.scene.turn(0, angle), ArrowDown: () => this.scene.turn(0, -angle),
      Escape: () => this.choose(null),
    };
    element("shape").addEventListener("keydown", (event) => {
      if (!(event.key in keys) || event.ctrlKey || event.altKey || event.metaKey || !this.scene) return;
      event.preventDefault();
      keys[event.key]();
    });
    element("zoom-in").addEventListener("click", () => this.scene?.zoom(1.25));
    element("zoom-out").addEventListener("click", () => this.scene?.zoom(0.8));
    element("fit").addEventListener("click", () => this.scene?.fit());
  }

  /** Moves to the radius that `text` gives, or shows an error. */
  take(text) {
    const alpha = /^inf(inity)?$/i.test(text) ? Infinity : Number(text);
    if (text === "" || !(alpha > 0)) {
      element("radius").setAttribute("aria-invalid", "true");
      element("radius-error").textContent = "Expected a radius: a number > 0, or inf.";
      return;
    }
    this.goToAlpha(alpha);
  }

  savePicture() {
    element("shape").toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = `${this.data.facts.source.replace(/\.[^.]*$/, "")}.png`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 60000);  // the browser reads it later
    });
  }

  resize() {
    this.scene?.resize();
    this.diagram.draw(this.colors, this.alpha, this.chosen);
  }
}

const page = new SpacePage();
