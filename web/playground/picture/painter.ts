// Canvases one above the other: the map, the lines of the diagram, the circles, and what follows
// the pointer. Each is redrawn only when it must be. Lines can take long: they are drawn in slices
// of a frame's time into a canvas that is not shown, and shown when they are complete; while the
// view moves, what is there is moved and scaled as it is. A change of a few sites redraws a box.
import type { Model } from "../model/model.js";
import { signal } from "../model/signals.js";
import { CirclesLayer } from "./circles_layer.js";
import { contextOf } from "../../shared/canvas.js";
import { make } from "../../shared/dom.js";
import { drawLines } from "./lines_layer.js";
import { drawMap } from "./map_layer.js";
import { drawOverlay, type Overlay } from "./overlay_layer.js";
import type { Layers, Picture } from "./picture.js";
import { readTheme } from "../../shared/theme.js";
import type { Box, View } from "./view.js";

const kSlice = 9; // ms of a frame that lines may take,
const kLongSlice = 40; // and where nobody waits for an answer
// ms for map, lines and circles together: what takes longer is not drawn anew for every step of a
// movement. Filling the pixels comes on top and takes about as long.
const kPatience = 8;
const kRest = 160; // ms without movement until it is
const kRemember = 512; // measured frames

type Cost = "circles" | "lines" | "box" | "overlay" | "frame";

/** A canvas with what was drawn on it. */
class Plate {
  drawn: View | null = null;
  isStale = true;
  cost = 0; // ms of the last whole drawing

  readonly context: CanvasRenderingContext2D;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.context = contextOf(canvas);
  }

  resize(width: number, height: number, ratio: number) {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.isStale = true;
    this.drawn = null;
  }

  /** Empties it; CSS pixels are its unit from here on. */
  start(ratio: number) {
    const { context, canvas } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.globalAlpha = 1;
    context.setLineDash([]);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    return context;
  }

  /** Says that it shows this view now. */
  finish(view: View) {
    this.canvas.style.transform = "";
    this.drawn = view.copy();
    this.isStale = false;
  }

  /** Shows what there is where it is now. */
  follow(view: View) {
    if (!this.drawn) return;
    const f = view.scale / this.drawn.scale;
    const dx = view.originX - this.drawn.originX * f;
    const dy = view.originY - this.drawn.originY * f;
    this.canvas.style.transform = `matrix(${f}, 0, 0, ${f}, ${dx}, ${dy})`;
  }
}

/** Where it draws: one above the other. */
export type Canvases = Record<"map" | "lines" | "spare" | "circles" | "overlay", HTMLCanvasElement>;

export class Painter {
  readonly #layers = signal<Layers>({
    cells: true,
    distances: true,
    circles: true,
    hidden: true,
    map: true,
    coast: false,
    dual: false,
    centres: false,
    vertices: false,
    levels: false,
    hull: false,
  });
  overlay: Overlay = {
    hover: null,
    selected: [],
    draft: null,
    box: null,
    revived: null,
  };
  theme = readTheme();
  /** While something moves by itself, lines are drawn whole in every frame. */
  isLive = false;
  /** Times of drawing, in ms, latest last. */
  costs: Record<Cost, number[]> = { circles: [], lines: [], box: [], overlay: [], frame: [] };

  readonly #model: Model;
  readonly #view: View;
  #circles = new CirclesLayer();
  #plates;
  #spare; // the plate of lines that is not shown,
  #drawn; // and the one of both that is drawn on
  #pixelRatio = 1;
  #frame = 0;
  #box: Box | null = null;
  #job: Generator | null = null;
  #jobCost = 0;
  #moved = -Infinity; // when the view last changed

  constructor({ map, lines, spare, circles, overlay }: Canvases, model: Model, view: View) {
    this.#model = model;
    this.#view = view;
    this.#plates = {
      map: new Plate(map),
      lines: new Plate(lines),
      circles: new Plate(circles),
      overlay: new Plate(overlay),
    };
    this.#spare = new Plate(spare);
    this.#drawn = this.#spare;
    this.readTheme();
  }

  /** The layers that are shown. */
  get layers() {
    return this.#layers.value;
  }

  setLayer(name: keyof Layers, isShown: boolean) {
    this.#layers.value = { ...this.layers, [name]: isShown };
    this.redraw();
  }

  readTheme() {
    this.theme = readTheme();
    this.redraw();
  }

  /** Fits the canvases to the window. */
  resize(width: number, height: number, pixelRatio: number) {
    this.#pixelRatio = pixelRatio;
    for (const plate of [...Object.values(this.#plates), this.#spare])
      plate.resize(width, height, pixelRatio);
    this.#view.resize(width, height);
    this.redraw();
  }

  /** Everything is to be drawn anew. */
  redraw() {
    for (const plate of Object.values(this.#plates)) plate.isStale = true;
    this.#job = null;
    this.#request();
  }

  /** All circles have changed: what is shown of lines and circles is of no use. */
  forget() {
    for (const plate of [this.#plates.lines, this.#plates.circles]) {
      plate.start(this.#pixelRatio);
      plate.drawn = null;
      plate.cost = 0;
    }
    this.redraw();
  }

  /** The view has moved. */
  viewChanged() {
    this.#moved = performance.now();
    this.redraw();
  }

  /** The diagram has changed inside this box (pixels). */
  redrawBox(box: Box) {
    if (this.#plates.lines.isStale) this.#job = null; // it has begun with what was before
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
    this.#plates.overlay.isStale = true;
    this.#request();
  }

  /** Whether the canvases show what they were last asked to show. */
  get isDone() {
    return !this.#frame;
  }

  /** Draws at once what is to be drawn: for tests and pictures. */
  flush() {
    cancelAnimationFrame(this.#frame);
    this.#moved = -Infinity;
    this.#draw(Infinity);
  }

  /** The pictures one above the other, on the paper. */
  toCanvas() {
    this.flush();
    const { canvas } = this.#plates.circles;
    const all = make("canvas", { width: canvas.width, height: canvas.height });
    const context = contextOf(all);
    context.fillStyle = this.theme.paper;
    context.fillRect(0, 0, all.width, all.height);
    for (const name of ["map", "lines", "circles"] as const)
      context.drawImage(this.#plates[name].canvas, 0, 0);
    return all;
  }

  /** The canvas that shows this part. */
  canvas(name: "map" | "lines" | "circles" | "overlay") {
    return this.#plates[name].canvas;
  }

  /** How large the cells in the window are, in pixels. */
  get cellSize() {
    const area = this.#view.width * this.#view.height;
    return Math.sqrt(area / Math.max(this.#circles.counts.visible, 1));
  }

  #request() {
    if (!this.#frame) this.#frame = requestAnimationFrame(() => this.#draw(kSlice));
  }

  get #picture(): Picture {
    return {
      sites: this.#model.sites,
      view: this.#view,
      layers: this.layers,
      theme: this.theme,
      pixelRatio: this.#pixelRatio,
      isLive: this.isLive,
      ends: this.ends,
    };
  }

  /** The cells, if they end at the coast. */
  get ends() {
    const { sites } = this.#model;
    const { map } = sites.info;
    return map && this.layers.coast ? sites.cellsIn(map.land.rings) : null;
  }

  /** @param slice ms that lines may take */
  #draw(slice: number) {
    const start = performance.now();
    this.#frame = 0;
    const isMoving = start - this.#moved < kRest;
    this.#drawMap(isMoving);
    this.#drawCircles(isMoving);
    const isWaiting = isMoving || this.#plates.overlay.isStale;
    const most = this.isLive ? Infinity : Math.max(slice, isWaiting ? 0 : kLongSlice);
    if (this.#plates.lines.isStale) this.#drawLines(isMoving, most);
    else if (this.#box) this.#drawBox(this.#box);
    if (!this.#plates.lines.isStale) this.#box = null;
    if (this.#plates.overlay.isStale) this.#drawOverlay();
    if (Object.values(this.#plates).some((plate) => plate.isStale)) this.#request();
    this.#note("frame", start);
  }

  /** Whether a plate is to be drawn now; else it shows what it has, elsewhere. */
  #isDue(plate: Plate, isMoving: boolean) {
    if (!plate.isStale) return false;
    if (!isMoving || this.#cost <= kPatience || !plate.drawn) return true;
    plate.follow(this.#view);
    return false;
  }

  /** ms that drawing it all took last. */
  get #cost() {
    const { map, lines, circles } = this.#plates;
    return map.cost + lines.cost + circles.cost;
  }

  #drawMap(isMoving: boolean) {
    const plate = this.#plates.map;
    if (!this.#isDue(plate, isMoving)) return;
    const start = performance.now();
    const context = plate.start(this.#pixelRatio);
    const { map } = this.#model.sites.info;
    if (map && this.layers.map) drawMap(context, this.#view, this.theme, map);
    plate.finish(this.#view);
    plate.cost = performance.now() - start;
  }

  #drawCircles(isMoving: boolean) {
    const plate = this.#plates.circles;
    if (!this.#isDue(plate, isMoving)) {
      if (!plate.isStale && this.#box) this.#drawCirclesIn(this.#box);
      return;
    }
    const start = performance.now();
    this.#circles.draw(plate.start(this.#pixelRatio), this.#picture, this.#window, true);
    plate.finish(this.#view);
    plate.cost = performance.now() - start;
    this.#note("circles", start);
  }

  #drawCirclesIn(box: Box) {
    const start = performance.now();
    this.#inBox(this.#plates.circles, box, (context, inner) =>
      this.#circles.draw(context, this.#picture, inner, false),
    );
    this.#note("box", start);
  }

  #drawLines(isMoving: boolean, slice: number) {
    const { lines } = this.#plates;
    if (!this.#job && isMoving && lines.drawn && this.#cost > kPatience) {
      lines.follow(this.#view);
      return;
    }
    const start = performance.now();
    let job = this.#job;
    if (!job) {
      // A drawing in one go needs no canvas that is not shown.
      this.#drawn = slice === Infinity ? lines : this.#spare;
      const context = this.#drawn.start(this.#pixelRatio);
      const expected = this.#circles.counts.visible;
      job = drawLines(context, this.#picture, this.#window, this.cellSize, expected);
      this.#job = job;
      this.#jobCost = 0;
    }
    let isDone = false;
    for (let k = 0; !isDone; k++) {
      isDone = job.next().done === true;
      if (k % 4 === 3 && performance.now() - start > slice) break;
    }
    this.#jobCost += performance.now() - start;
    this.#note("lines", start);
    if (isDone) this.#showLines();
    else lines.follow(this.#view);
  }

  /** Shows the lines that are complete now, in place of those that are shown. */
  #showLines() {
    const lines = this.#drawn;
    this.#job = null;
    lines.cost = this.#jobCost;
    lines.finish(this.#view);
    if (lines !== this.#spare) return;
    this.#spare = this.#plates.lines;
    this.#plates.lines = lines;
    lines.canvas.hidden = false;
    this.#spare.canvas.hidden = true;
  }

  #drawBox(box: Box) {
    const start = performance.now();
    this.#inBox(this.#plates.lines, box, (context, inner) => {
      const area = (inner.right - inner.left) * (inner.bottom - inner.top);
      const expected =
        (this.#circles.counts.visible * area) / (this.#view.width * this.#view.height);
      for (const _ of drawLines(context, this.#picture, inner, this.cellSize, expected));
    });
    this.#note("box", start);
  }

  /** Draws a part of a plate anew. */
  #inBox(
    { canvas, context }: Plate,
    box: Box,
    draw: (context: CanvasRenderingContext2D, inner: Box) => void,
  ) {
    // Whole device pixels, so that nothing is blended twice at the border.
    const ratio = this.#pixelRatio;
    const left = Math.max(0, Math.floor(box.left * ratio));
    const top = Math.max(0, Math.floor(box.top * ratio));
    const right = Math.min(canvas.width, Math.ceil(box.right * ratio));
    const bottom = Math.min(canvas.height, Math.ceil(box.bottom * ratio));
    if (right <= left || bottom <= top) return;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.save();
    context.beginPath();
    context.rect(left, top, right - left, bottom - top);
    context.clip();
    context.clearRect(left, top, right - left, bottom - top);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    draw(context, {
      left: left / ratio,
      top: top / ratio,
      right: right / ratio,
      bottom: bottom / ratio,
    });
    context.restore();
  }

  #drawOverlay() {
    const start = performance.now();
    const plate = this.#plates.overlay;
    drawOverlay(plate.start(this.#pixelRatio), this.#picture, this.overlay);
    plate.isStale = false;
    this.#note("overlay", start);
  }

  get #window() {
    return { left: 0, top: 0, right: this.#view.width, bottom: this.#view.height };
  }

  #note(name: Cost, start: number) {
    const list = this.costs[name];
    list.push(performance.now() - start);
    if (list.length > kRemember) list.shift();
  }
}
