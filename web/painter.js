// Three canvases, one above the other: the map, the diagram, and what follows the pointer. Each is
// redrawn only when it must be, at most once a frame; a change of one site redraws a box of the
// diagram only; while the view moves, a picture that takes long to draw is moved and scaled as it
// is, and drawn anew when the movement rests.
import { drawBase } from "./base_layer.js";
import { drawMap } from "./map_layer.js";
import { drawOverlay } from "./overlay_layer.js";
import { readTheme } from "./theme.js";

/** @typedef {import("./view.js").Box} Box */

// ms: a picture that took longer to draw is not drawn anew for every step of a movement
const kPatience = 12;
const kRest = 90; // ms without movement until it is
const kRemember = 512; // measured frames

export class Painter {
  /** @type {import("./base_layer.js").Layers} */
  layers = { cells: true, circles: true, dual: false, hidden: true, map: true };
  /** @type {import("./map_layer.js").WorldMap | null} */
  map = null;
  /** @type {import("./overlay_layer.js").Hover | null} */
  hover = null;
  selected = -1;
  draft = null;
  /** @type {Record<string, string>} */
  theme = {};
  /** What drawing cost, in ms, latest last: whole pictures, boxes, overlays. */
  costs = { full: [], box: [], overlay: [] };

  #contexts;
  #pixelRatio = 1;
  #frame = 0;
  #drawn = null; // the view of the diagram's picture
  #stale = true; // the whole diagram is to be drawn
  /** @type {Box | null} */ #box = null; // or only this box
  #mapStale = true;
  #overlayStale = true;
  #moved = 0; // when the view last changed

  /**
   * @param {{ map: HTMLCanvasElement, base: HTMLCanvasElement, overlay: HTMLCanvasElement }}
   * canvases
   * @param {import("./scene.js").Scene} scene
   * @param {import("./view.js").View} view
   */
  constructor(canvases, scene, view) {
    this.canvases = canvases;
    this.scene = scene;
    this.view = view;
    this.#contexts = Object.fromEntries(
      Object.entries(canvases).map(([name, canvas]) => [name, canvas.getContext("2d")]),
    );
    this.readTheme();
  }

  readTheme() {
    this.theme = readTheme();
    this.redraw();
  }

  /** Fits the canvases to the window. */
  resize(width, height, pixelRatio) {
    this.#pixelRatio = pixelRatio;
    for (const canvas of Object.values(this.canvases)) {
      canvas.width = Math.round(width * pixelRatio);
      canvas.height = Math.round(height * pixelRatio);
    }
    this.view.resize(width, height);
    this.redraw();
  }

  /** Everything is to be drawn anew. */
  redraw() {
    this.#stale = this.#mapStale = this.#overlayStale = true;
    this.#request();
  }

  /** The view has moved. */
  viewChanged() {
    this.#moved = performance.now();
    this.redraw();
  }

  /** The diagram has changed inside this box (pixels). @param {Box} box */
  redrawBox(box) {
    const old = this.#box;
    this.#box = old
      ? {
          left: Math.min(old.left, box.left),
          top: Math.min(old.top, box.top),
          right: Math.max(old.right, box.right),
          bottom: Math.max(old.bottom, box.bottom),
        }
      : box;
    this.redrawOverlay();
  }

  redrawOverlay() {
    this.#overlayStale = true;
    this.#request();
  }

  /** Draws at once what is to be drawn: for tests and screenshots. */
  flush() {
    cancelAnimationFrame(this.#frame);
    this.#moved = 0;
    this.#draw();
  }

  #request() {
    if (!this.#frame) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#frame = 0;
    if (this.#stale && this.#mayWait()) {
      this.#moveAsItIs();
      this.#request();
    } else if (this.#stale) {
      this.#drawFull();
    } else if (this.#box) {
      this.#drawBox(this.#box);
    }
    if (this.#overlayStale) this.#drawOverlay();
  }

  #mayWait() {
    const cost = this.costs.full.at(-1) ?? 0;
    const moving = performance.now() - this.#moved < kRest;
    return moving && cost > kPatience && this.#drawn !== null && !this.#drawn.sameAs(this.view);
  }

  #moveAsItIs() {
    const f = this.view.scale / this.#drawn.scale;
    const dx = this.view.originX - this.#drawn.originX * f;
    const dy = this.view.originY - this.#drawn.originY * f;
    for (const name of ["map", "base"])
      this.canvases[name].style.transform = `matrix(${f}, 0, 0, ${f}, ${dx}, ${dy})`;
  }

  #drawFull() {
    const start = performance.now();
    if (this.#mapStale) {
      const context = this.#start("map");
      if (this.map && this.layers.map) drawMap(context, this.view, this.theme, this.map);
      this.#mapStale = false;
    }
    const context = this.#start("base");
    const box = { left: 0, top: 0, right: this.view.width, bottom: this.view.height };
    drawBase(context, this.scene, this.view, this.layers, this.theme, box);
    for (const name of ["map", "base"]) this.canvases[name].style.transform = "";
    this.#drawn = this.view.copy();
    this.#stale = false;
    this.#box = null;
    this.#note("full", start);
  }

  /** @param {Box} box */
  #drawBox(box) {
    const start = performance.now();
    this.#box = null;
    // Whole device pixels, so that nothing is blended twice at the border.
    const ratio = this.#pixelRatio;
    const left = Math.max(0, Math.floor(box.left * ratio));
    const top = Math.max(0, Math.floor(box.top * ratio));
    const right = Math.min(this.canvases.base.width, Math.ceil(box.right * ratio));
    const bottom = Math.min(this.canvases.base.height, Math.ceil(box.bottom * ratio));
    if (right <= left || bottom <= top) return;
    const context = this.#contexts.base;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.save();
    context.beginPath();
    context.rect(left, top, right - left, bottom - top);
    context.clip();
    context.clearRect(left, top, right - left, bottom - top);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const inner = {
      left: left / ratio,
      top: top / ratio,
      right: right / ratio,
      bottom: bottom / ratio,
    };
    drawBase(context, this.scene, this.view, this.layers, this.theme, inner);
    context.restore();
    this.#note("box", start);
  }

  #drawOverlay() {
    const start = performance.now();
    const context = this.#start("overlay");
    drawOverlay(context, this.scene, this.view, this.theme, this.hover, this.selected, this.draft);
    this.#overlayStale = false;
    this.#note("overlay", start);
  }

  /** An empty canvas with CSS pixels as its unit. */
  #start(name) {
    const context = this.#contexts[name];
    const { width, height } = this.canvases[name];
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    context.setTransform(this.#pixelRatio, 0, 0, this.#pixelRatio, 0, 0);
    return context;
  }

  #note(name, start) {
    const list = this.costs[name];
    list.push(performance.now() - start);
    if (list.length > kRemember) list.shift();
  }
}
