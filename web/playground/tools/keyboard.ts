// Keys. While the canvas has the focus, arrows and others act on the selected circles, without any
// on the view. Undo, redo, zoom, size and the tools work everywhere but in text fields.
import { arrowOf, type Direction } from "../../shared/input.js";
import type { App } from "../app.js";
import { isIn, isTextField } from "./targets.js";
import { toolOfKey } from "./registry.js";

const kStep = 4; // pixels an arrow key moves a circle; with Shift ten times as far
const kPan = 60;
const kZoom = 1.25;
const kGrow = 1.05;
const kGrowths = new Map([
  ["[", 1 / kGrow],
  ["]", kGrow],
]);
const kAside = 2; // how much worse a circle aside is than one straight ahead

export function listenToKeyboard(element: HTMLElement, app: App, gestures: { cancel(): boolean }) {
  const walk = new Walk(app);

  const onCanvas = (event: KeyboardEvent) => {
    const direction = arrowOf(event.key);
    const { key } = event;
    const command = event.ctrlKey || event.metaKey;
    const { selection } = app;
    if (command && direction) select(app, direction);
    else if (command && key === "a") selection.set(app.sites.ids);
    else if (command || event.altKey) return false;
    else if (direction) arrow(app, direction, event.shiftKey ? 10 : 1);
    else if (key === "Delete" || key === "Backspace") app.edits.removeSelected();
    else if (key === "Enter") selectNearest(app);
    else if (key === "Insert" || key === "i")
      app.edits.insertAt(app.camera.place.x, app.camera.place.y);
    else if (key === "n") walk.go(1);
    else if (key === "p") walk.go(-1);
    else return false;
    return true;
  };

  const anywhere = (event: KeyboardEvent) => {
    const key = event.key.toLowerCase();
    const command = event.ctrlKey || event.metaKey;
    const tool = toolOfKey(key);
    // On some keyboards brackets need AltGr, which counts as Ctrl and Alt.
    if (event.getModifierState("AltGraph") || !(command || event.altKey)) {
      const growth = kGrowths.get(key);
      if (growth !== undefined) {
        app.edits.grow(growth);
        return true;
      }
    }
    if (command && key === "z") event.shiftKey ? app.edits.redo() : app.edits.undo();
    else if (command && key === "y") app.edits.redo();
    else if (command && key === "d") app.edits.duplicate();
    else if (command || event.altKey) return false;
    else if (key === "escape") giveUp();
    else if (tool) app.tool = tool;
    else if (key === "+" || key === "=") app.camera.zoom(kZoom);
    else if (key === "-" || key === "_") app.camera.zoom(1 / kZoom);
    else if (key === "0" || key === "home") app.camera.fit();
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
    if (isTextField(event.target) || isIn(event.target, "dialog")) return;
    if (event.key === "Escape" && document.querySelector(":popover-open")) return; // closes that
    if (anywhere(event)) event.preventDefault();
  });
}

function arrow(app: App, [dx, dy]: Direction, times: number) {
  if (app.selection.size === 0) app.camera.pan(-dx * kPan, -dy * kPan);
  else app.edits.nudge(dx * kStep * times, dy * kStep * times);
}

function selectNearest(app: App) {
  const { x, y } = app.camera.place;
  const id = app.diagram.find(app.view.toWorldX(x), app.view.toWorldY(y));
  if (id >= 0) app.selection.set([id]);
}

/**
 * Selects the next circle in a direction: of the selected one's neighbours, or of those around it
 * if none is there.
 */
function select(app: App, [dx, dy]: Direction) {
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
  app.camera.show(best);
}

/** From neighbour to neighbour through all visible circles, and back. */
class Walk {
  #path: number[] = [];
  #step = 0;
  #queue = new Set<number>();

  constructor(readonly app: App) {}

  go(direction: 1 | -1) {
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
    app.camera.show(this.#path[step]);
  }

  /** By the neighbour that waits for the longest time. */
  #lengthen() {
    const { diagram } = this.app;
    for (const id of diagram.neighbors(this.#path[this.#path.length - 1])) this.#queue.add(id);
    for (const id of this.#queue) {
      if (!diagram.has(id) || this.#path.includes(id)) continue;
      this.#path.push(id);
      return;
    }
  }
}
