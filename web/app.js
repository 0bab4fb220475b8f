// What the page can do, whoever asks for it: pointer, keyboard, buttons or a test. Keeps diagram,
// picture and selection together.
import { Painter } from "./painter.js";
import { regionOf } from "./regions.js";
import { Scene } from "./scene.js";
import { View } from "./view.js";

const kFirstRadius = 14; // pixels: a new circle, until the user has resized one

const kQueries = 32; // pointer movements over which the time of a query is averaged

/** Events: "hover", "select", "change" (of the diagram), "layers". */
export class App extends EventTarget {
  scene = new Scene();
  view = new View();
  /** @type {Painter} */ painter;
  /**
   * The pointer in pixels, or null while it is elsewhere. @type {{ x: number, y: number } | null}
   */
  pointer = null;
  /**
   * Time of a nearest-site query: the mean over the latest few dozen movements of the pointer
   * (single ones are too short).
   */
  query = { count: 0, micros: 0 };
  #insertPixels = kFirstRadius;

  constructor(canvases) {
    super();
    this.painter = new Painter(canvases, this.scene, this.view);
    let before = null;
    this.scene.addEventListener("before", (/** @type {any} */ { detail }) => {
      before = this.#region(detail.id);
    });
    this.scene.addEventListener("change", (/** @type {any} */ { detail }) => {
      if (detail.all) this.painter.redraw();
      if (before) this.painter.redrawBox(before);
      if (detail.id !== undefined && !detail.removed)
        this.painter.redrawBox(this.#region(detail.id));
      before = null;
      this.refreshHover();
      this.dispatchEvent(new Event("change"));
    });
  }

  get diagram() {
    return this.scene.diagram;
  }

  get selected() {
    return this.painter.selected;
  }

  get hover() {
    return this.painter.hover;
  }

  #region(id) {
    return regionOf(this.scene, this.view, id, this.painter.layers.dual);
  }

  // --- Sites -------------------------------------------------------------------------------------

  /** Inserts a circle at a pixel and selects it. @param {number} [r] in the diagram's units */
  insertAt(x, y, r = this.#insertPixels / this.view.scale) {
    const id = this.scene.insert(this.view.toWorldX(x), this.view.toWorldY(y), r);
    this.select(id);
    return id;
  }

  move(id, x, y) {
    this.scene.update(id, x, y, this.scene.site(id).r);
  }

  resize(id, r) {
    const site = this.scene.site(id);
    const radius = Math.max(0, r);
    this.scene.update(id, site.x, site.y, radius);
    this.#insertPixels = Math.max(2, Math.min(60, radius * this.view.scale));
  }

  remove(id) {
    if (id === this.selected) this.select(-1);
    this.scene.remove(id);
  }

  /** Replaces all sites. */
  replaceAll(xyr, labels) {
    this.select(-1);
    this.query = { count: 0, micros: 0 };
    this.#insertPixels = kFirstRadius;
    this.scene.replaceAll(xyr, labels);
  }

  /** @param {number} id -1 selects nothing */
  select(id) {
    if (id === this.painter.selected) return;
    this.painter.selected = id;
    this.painter.redrawOverlay();
    this.dispatchEvent(new Event("select"));
  }

  /** The circle under a pixel, or -1. */
  pick(x, y, reach) {
    const { circles, hidden } = this.painter.layers;
    const { view } = this;
    return this.scene.pick(view.toWorldX(x), view.toWorldY(y), reach / view.scale, {
      visible: circles,
      hidden,
    });
  }

  // --- Pointer -----------------------------------------------------------------------------------

  /** Highlights the site nearest to a pixel; null: the pointer has left. */
  hoverAt(pointer) {
    this.pointer = pointer;
    this.refreshHover();
  }

  refreshHover() {
    this.painter.hover = this.pointer ? this.#nearest(this.pointer) : null;
    this.painter.redrawOverlay();
    this.dispatchEvent(new Event("hover"));
  }

  #nearest({ x, y }) {
    const wx = this.view.toWorldX(x);
    const wy = this.view.toWorldY(y);
    const start = performance.now();
    const nearest = this.diagram.nearest(wx, wy);
    const micros = (performance.now() - start) * 1000;
    const weight = 1 / Math.min(++this.query.count, kQueries);
    this.query.micros += (micros - this.query.micros) * weight;
    if (!nearest) return null;
    return {
      x,
      y,
      id: nearest.id,
      distance: nearest.distance,
      neighbors: this.diagram.neighbors(nearest.id),
    };
  }

  // --- View --------------------------------------------------------------------------------------

  setLayer(name, shown) {
    this.painter.layers[name] = shown;
    this.painter.redraw();
    this.dispatchEvent(new Event("layers"));
  }

  pan(dx, dy) {
    this.view.pan(dx, dy);
    this.viewChanged();
  }

  zoom(factor, x = this.view.width / 2, y = this.view.height / 2) {
    this.view.zoom(factor, x, y);
    this.viewChanged();
  }

  fit(bounds = this.scene.bounds(), insets = undefined, margin = undefined) {
    if (!bounds) return;
    this.view.fit(bounds, insets, margin);
    this.viewChanged();
  }

  viewChanged() {
    this.painter.viewChanged();
    this.refreshHover();
  }
}
