// What the page can do, whoever asks for it: pointer, keyboard, buttons or a test. Keeps model,
// picture and selection together.
import { Model } from "./model/model.js";
import { Selection } from "./model/selection.js";
import { emptySites } from "./model/sites.js";
import { Painter } from "./picture/painter.js";
import { regionOf } from "./picture/regions.js";
import { View } from "./picture/view.js";

/** @typedef {import("./model/sites.js").Sites} Sites */
/** @typedef {{ x: number, y: number }} Point in pixels */
/**
 * @typedef {{ neighbors: boolean, empty: boolean, under: boolean, nearest: number }} Questions what
 * is answered at the pointer: how many of the nearest
 */

const kFirstRadius = 16; // pixels: a new circle, until the user has resized one
const kMostBoxes = 12; // circles that change at once and are redrawn in a box
const kEdge = 24; // pixels from the border at which a circle moved by keys takes the view along
const kNoInsets = { left: 0, top: 0, right: 0, bottom: 0 };
const kNothing = new Uint32Array(0);

/** Events: "hover", "select", "change" (Change), "history", "layers", "tool", "view". */
export class App extends EventTarget {
  model = new Model();
  selection = new Selection(this.model);
  view = new View();
  /** @type {Painter} */ painter;
  /** The pointer in pixels, or null while it is elsewhere. @type {Point | null} */
  pointer = null;
  /** @type {Questions} */
  questions = { neighbors: true, empty: false, under: false, nearest: 0 };
  /** What the pages's bars cover, in pixels. */
  insets = () => kNoInsets;
  /** @type {"select" | "draw" | "pan" | "delete"} */ #tool = "select";
  #newPixels = kFirstRadius;

  constructor(canvases) {
    super();
    this.painter = new Painter(canvases, this.model, this.view);
    this.model.addEventListener("before", (/** @type {any} */ { detail }) =>
      this.#redrawAround(detail),
    );
    this.model.addEventListener("change", (/** @type {any} */ { detail }) => {
      if (detail.isSet) this.painter.forget();
      this.#redrawAround(detail);
      this.refreshHover();
      this.dispatchEvent(new CustomEvent("change", { detail }));
    });
    this.model.addEventListener("history", () => this.dispatchEvent(new Event("history")));
    this.selection.addEventListener("select", () => {
      this.painter.overlay.selected = this.selection.ids;
      this.painter.redrawOverlay();
      this.dispatchEvent(new Event("select"));
    });
  }

  get diagram() {
    return this.model.diagram;
  }

  get sites() {
    return this.model.sites;
  }

  get hover() {
    return this.painter.overlay.hover;
  }

  get tool() {
    return this.#tool;
  }

  set tool(tool) {
    this.#tool = tool;
    this.dispatchEvent(new Event("tool"));
  }

  /** @param {import("./model/model.js").Change} change about to happen, or just happened */
  #redrawAround({ ids }) {
    const { dual, hull, vertices, levels, centres } = this.painter.layers;
    const isAround = hull || vertices || levels || centres; // what is drawn changes elsewhere, too
    if (ids === null || ids.length > kMostBoxes || isAround) {
      this.painter.redraw();
      return;
    }
    for (let k = 0; k < ids.length; k++)
      if (this.diagram.has(ids[k]))
        this.painter.redrawBox(regionOf(this.sites, this.view, ids[k], dual));
  }

  // --- Edits -------------------------------------------------------------------------------------

  /** A number that says no more than a pixel shows. */
  rounded(value) {
    const digits = -Math.floor(Math.log10(0.2 / this.view.scale));
    if (digits >= 0) return Number(value.toFixed(Math.min(digits, 100)));
    const step = 10 ** -digits;
    return Math.round(value / step) * step;
  }

  /** Inserts a circle at a pixel and selects it. @param {number} [r] in the diagram's units */
  insertAt(x, y, r = this.#newPixels / this.view.scale) {
    return this.insertCircle({ x: this.view.toWorldX(x), y: this.view.toWorldY(y), r });
  }

  /** Inserts a circle and selects it. @param {import("./model/sites.js").Circle} circle */
  insertCircle({ x, y, r }) {
    const numbers = [this.rounded(x), this.rounded(y), this.rounded(r)];
    const [id] = this.model.insert(Float64Array.from(numbers));
    this.selection.set([id]);
    return id;
  }

  /** The circle that a click would insert. */
  draftAt(x, y) {
    return {
      x: this.view.toWorldX(x),
      y: this.view.toWorldY(y),
      r: this.#newPixels / this.view.scale,
    };
  }

  /** New circles are as large on the screen as this one. */
  remember(id) {
    this.#newPixels = Math.max(4, Math.min(60, this.sites.site(id).r * this.view.scale));
  }

  /** Also ends drawing: the next click would insert what has just been deleted. */
  removeSelected() {
    this.model.remove(this.selection.ids);
    if (this.tool === "draw") this.tool = "select";
  }

  /** Copies of the selected ones beside them, selected. */
  duplicate() {
    const { ids } = this.selection;
    if (ids.length === 0) return;
    const shift = this.rounded(24 / this.view.scale);
    const xyr = this.sites.triples(ids).map((v, k) => [v + shift, v - shift, v][k % 3]);
    const labels = ids.map((id) => this.sites.labels.get(id));
    this.selection.set(this.model.insert(xyr, labels));
  }

  /** Moves the selected ones by pixels and takes the view along. */
  nudge(dx, dy) {
    const { ids } = this.selection;
    const { scale } = this.view;
    const shift = [this.rounded(dx / scale), this.rounded(-dy / scale), 0];
    this.model.update(
      ids,
      this.sites.triples(ids).map((v, k) => (k % 3 === 2 ? v : this.rounded(v + shift[k % 3]))),
    );
    this.show(this.selection.last);
  }

  /** Makes the selected ones larger or smaller. */
  grow(factor) {
    const { ids } = this.selection;
    const least = 1 / this.view.scale;
    this.model.update(
      ids,
      this.sites
        .triples(ids)
        .map((v, k) => (k % 3 === 2 ? this.rounded(Math.max(v, least) * factor) : v)),
    );
    if (ids.length === 1) this.remember(ids[0]);
  }

  /** An empty set in place of this one: the way back costs nothing, however many there are. */
  clear() {
    this.model.replace(emptySites());
  }

  undo() {
    this.#selectOf(this.model.undo());
  }

  redo() {
    this.#selectOf(this.model.redo());
  }

  #selectOf(command) {
    if (!command?.ids || command.ids.length > kMostBoxes) return;
    this.selection.set(Array.from(command.ids).filter((id) => this.diagram.has(id)));
  }

  // --- Pointer -----------------------------------------------------------------------------------

  /**
   * The circles at a pixel, those that contain it and those that it misses by `reach` pixels: the
   * nearest one first, which is what hovering highlights. Hidden ones only if they are shown.
   * @returns {number[]}
   */
  at(x, y, reach) {
    const { view, painter } = this;
    const [wx, wy] = [view.toWorldX(x), view.toWorldY(y)];
    const found = Array.from(this.diagram.within(wx, wy, reach / view.scale));
    return painter.layers.hidden ? found : found.filter((id) => !this.sites.isHidden(id));
  }

  /** Highlights the site nearest to a pixel; null: the pointer has left. */
  hoverAt(pointer) {
    this.pointer = pointer;
    this.refreshHover();
  }

  refreshHover() {
    this.painter.overlay.hover = this.pointer ? this.#answers(this.pointer) : null;
    this.painter.redrawOverlay();
    this.dispatchEvent(new Event("hover"));
  }

  /** @param {Point} pointer */
  #answers({ x, y }) {
    const { diagram, questions } = this;
    const [wx, wy] = [this.view.toWorldX(x), this.view.toWorldY(y)];
    const nearest = diagram.nearest(wx, wy);
    if (!nearest) return null;
    const { id, distance } = nearest;
    return {
      x,
      y,
      id,
      distance,
      neighbors: questions.neighbors ? diagram.neighbors(id) : kNothing,
      nearest: questions.nearest > 0 ? diagram.kNearest(wx, wy, questions.nearest) : kNothing,
      under: questions.under ? diagram.within(wx, wy, 0) : kNothing,
      empty: questions.empty ? this.#emptyNear(id, wx, wy) : null,
    };
  }

  /** The empty circle about the corner of this cell that is nearest to a point. */
  #emptyNear(id, wx, wy) {
    const { view, sites } = this;
    const [left, right] = [view.toWorldX(-view.width), view.toWorldX(2 * view.width)];
    const [bottom, top] = [view.toWorldY(2 * view.height), view.toWorldY(-view.height)];
    const cell = this.diagram.voronoi([left, bottom, right, top]).cellCurves(id);
    if (!cell) return null;
    const site = sites.site(id);
    let best = null;
    let least = Infinity;
    for (let k = 0; k < cell.neighbors.length; k++) {
      const before = k === 0 ? cell.neighbors.length - 1 : k - 1;
      if (cell.neighbors[k] < 0 || cell.neighbors[before] < 0) continue;
      const [x, y] = cell.curves.subarray(7 * k, 7 * k + 2);
      const distance = Math.hypot(x - wx, y - wy);
      if (distance >= least) continue;
      least = distance;
      best = { x, y, r: Math.hypot(x - site.x, y - site.y) - sites.radius(id) };
    }
    return best;
  }

  /** What else is drawn over the picture. @param {Partial<Painter["overlay"]>} overlay */
  mark(overlay) {
    Object.assign(this.painter.overlay, overlay);
    this.painter.redrawOverlay();
  }

  // --- View --------------------------------------------------------------------------------------

  setLayer(name, isShown) {
    this.painter.layers[name] = isShown;
    this.painter.redraw();
    this.dispatchEvent(new Event("layers"));
  }

  ask(questions) {
    Object.assign(this.questions, questions);
    this.refreshHover();
    this.dispatchEvent(new Event("layers"));
  }

  pan(dx, dy) {
    this.view.pan(dx, dy);
    this.viewChanged();
  }

  zoom(factor, x = this.#middle.x, y = this.#middle.y) {
    this.view.zoom(factor, x, y);
    this.viewChanged();
  }

  /** Shows all circles beside the bars. */
  fit(bounds = this.sites.bounds(), margin = undefined) {
    this.view.fit(bounds ?? [0, 0, 1000, 600], this.insets(), margin);
    this.viewChanged();
  }

  /** Moves the view as little as it must to show a circle's centre. */
  show(id) {
    const { x, y } = this.sites.site(id);
    const [px, py] = [this.view.toScreenX(x), this.view.toScreenY(y)];
    const { left, top, right, bottom } = this.insets();
    const into = (p, low, high) => Math.max(low - p, 0) + Math.min(high - p, 0);
    const dx = into(px, left + kEdge, this.view.width - right - kEdge);
    const dy = into(py, top + kEdge, this.view.height - bottom - kEdge);
    if (dx !== 0 || dy !== 0) this.pan(dx, dy);
  }

  /** The middle of what the bars leave free. */
  get #middle() {
    const { left, top, right, bottom } = this.insets();
    return {
      x: (left + this.view.width - right) / 2,
      y: (top + this.view.height - bottom) / 2,
    };
  }

  /** Where keys act: under the pointer, else in the middle. */
  get place() {
    return this.pointer ?? this.#middle;
  }

  viewChanged() {
    this.painter.viewChanged();
    this.refreshHover();
    this.dispatchEvent(new Event("view"));
  }
}
