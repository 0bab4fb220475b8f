// Keys, while the canvas has the focus. With selected circles they act on them, without on the
// view. Undo, redo and the tools work everywhere but in fields.

const kStep = 4; // pixels an arrow key moves a circle; with Shift ten times as far
const kPan = 60;
const kGrow = 1.05;
const kAside = 2; // how much worse a circle aside is than one straight ahead

const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** @type {Record<string, "select" | "draw" | "pan" | "delete">} */
const kTools = { v: "select", d: "draw", h: "pan", x: "delete" };

/**
 * @param {HTMLElement} element
 * @param {import("../app.js").App} app
 * @param {{ cancel(): boolean }} gestures
 */
export function listenToKeyboard(element, app, gestures) {
  const walk = new Walk(app);

  const onCanvas = (event) => {
    const { key } = event;
    const command = event.ctrlKey || event.metaKey;
    const { selection } = app;
    if (command && key in kArrows) select(app, kArrows[key]);
    else if (command && key === "a") selection.set(app.sites.ids);
    else if (command || event.altKey) return false;
    else if (key in kArrows) arrow(app, kArrows[key], event.shiftKey ? 10 : 1);
    else if (key === "+" || key === "=") grow(app, kGrow);
    else if (key === "-" || key === "_") grow(app, 1 / kGrow);
    else if (key === "Delete" || key === "Backspace") app.removeSelected();
    else if (key === "Enter") selectNearest(app);
    else if (key === "Insert" || key === "i") app.insertAt(app.place.x, app.place.y);
    else if (key === "n") walk.go(1);
    else if (key === "p") walk.go(-1);
    else return false;
    return true;
  };

  const anywhere = (event) => {
    const key = event.key.toLowerCase();
    const command = event.ctrlKey || event.metaKey;
    if (command && key === "z") event.shiftKey ? app.redo() : app.undo();
    else if (command && key === "y") app.redo();
    else if (command && key === "d") app.duplicate();
    else if (command || event.altKey) return false;
    else if (key === "escape") giveUp();
    else if (key in kTools) app.tool = kTools[key];
    else if (key === "0" || key === "home") app.fit();
    else return false;
    return true;
  };

  /** One thing after another. */
  function giveUp() {
    if (gestures.cancel()) return;
    if (app.tool !== "select") app.tool = "select";
    else app.selection.clear();
  }

  element.addEventListener("keydown", (event) => {
    if (onCanvas(event)) event.preventDefault();
  });
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented) return;
    const at = /** @type {HTMLElement} */ (event.target);
    if (at.closest?.("input, select, textarea, dialog")) return;
    if (event.key === "Escape" && document.querySelector(":popover-open")) return; // closes that
    if (anywhere(event)) event.preventDefault();
  });
}

/** @param {import("../app.js").App} app */
function arrow(app, [dx, dy], times) {
  if (app.selection.size === 0) app.pan(-dx * kPan, -dy * kPan);
  else app.nudge(dx * kStep * times, dy * kStep * times);
}

/** @param {import("../app.js").App} app */
function grow(app, factor) {
  if (app.selection.size === 0) app.zoom(factor > 1 ? 1.25 : 0.8);
  else app.grow(factor);
}

/** @param {import("../app.js").App} app */
function selectNearest(app) {
  const { x, y } = app.place;
  const id = app.diagram.find(app.view.toWorldX(x), app.view.toWorldY(y));
  if (id >= 0) app.selection.set([id]);
}

/**
 * Selects the next circle in a direction: of the selected one's neighbours, or of those around it
 * if none is there.
 * @param {import("../app.js").App} app
 */
function select(app, [dx, dy]) {
  const from = app.selection.last;
  if (from < 0) {
    selectNearest(app);
    return;
  }
  const { diagram, sites } = app;
  const { x, y } = sites.site(from);
  let best = -1;
  let least = Infinity;
  for (const id of new Set([...diagram.neighbors(from), ...diagram.kNearest(x, y, 24)])) {
    const site = sites.site(id);
    const ahead = (site.x - x) * dx - (site.y - y) * dy;
    const aside = Math.abs((site.x - x) * dy + (site.y - y) * dx);
    if (id === from || ahead <= 0 || aside > 2 * ahead) continue;
    const cost = ahead + kAside * aside;
    if (cost >= least) continue;
    least = cost;
    best = id;
  }
  if (best < 0) return;
  app.selection.set([best]);
  app.show(best);
}

/** From neighbour to neighbour through all visible circles, and back. */
class Walk {
  /** @type {number[]} */ #path = [];
  #step = 0;
  #queue = new Set();

  /** @param {import("../app.js").App} app */
  constructor(app) {
    this.app = app;
  }

  /** @param {1 | -1} direction */
  go(direction) {
    const { app } = this;
    if (app.selection.last !== this.#path[this.#step] || app.selection.size !== 1) {
      if (app.selection.size === 0) selectNearest(app);
      if (app.selection.size === 0) return;
      this.#path = [app.selection.last];
      this.#queue = new Set(this.#path);
      this.#step = 0;
    }
    if (direction > 0 && this.#step === this.#path.length - 1) this.#lengthen();
    const step = this.#step + direction;
    if (step < 0 || step >= this.#path.length || !app.diagram.has(this.#path[step])) return;
    this.#step = step;
    app.selection.set([this.#path[step]]);
    app.show(this.#path[step]);
  }

  /** By the neighbour that waits for the longest time. */
  #lengthen() {
    const { diagram } = this.app;
    for (const id of diagram.neighbors(this.#path.at(-1))) this.#queue.add(id);
    for (const id of this.#queue) {
      if (!diagram.has(id) || this.#path.includes(id)) continue;
      this.#path.push(id);
      return;
    }
  }
}
