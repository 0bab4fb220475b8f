// What the page can do, whoever asks for it: pointer, keyboard, buttons or a test. Keeps model,
// picture and selection together.
import { roundedTo } from "../shared/rounding.js";
import type { Command } from "./model/commands.js";
import { type Change, Model } from "./model/model.js";
import { neighborsOf } from "./model/neighbors.js";
import { Selection } from "./model/selection.js";
import { effect, signal } from "./model/signals.js";
import type { Bounds, Circle } from "./model/circle.js";
import { emptySites } from "./model/sites.js";
import type { Hover, Overlay } from "./picture/overlay_layer.js";
import { type Canvases, Painter } from "./picture/painter.js";
import type { Layers } from "./picture/picture.js";
import { regionOf } from "./picture/regions.js";
import { View } from "./picture/view.js";

/** A place in pixels. */
export type Point = { x: number; y: number };
/** What is answered at the pointer: how many of the nearest. */
export type Questions = { neighbors: boolean; empty: boolean; under: boolean; nearest: number };

const kFirstRadius = 16; // pixels: a new circle, until the user has resized one
const kMostBoxes = 12; // circles that change at once and are redrawn in a box
const kEdge = 24; // pixels from the border at which a circle moved by keys takes the view along
const kNoInsets = { left: 0, top: 0, right: 0, bottom: 0 };
const kNothing = new Uint32Array(0);

/** One point has no extent: as much around it as it is away from zero, but 1 at least. */
function withExtent([xmin, ymin, xmax, ymax]: Bounds): Bounds {
  if (xmin < xmax || ymin < ymax) return [xmin, ymin, xmax, ymax];
  const reach = Math.max(1, Math.abs(xmin), Math.abs(ymin));
  return [xmin - reach, ymin - reach, xmin + reach, ymin + reach];
}

export class App {
  model = new Model();
  selection = new Selection(this.model);
  view = new View();
  painter: Painter;
  /** The pointer in pixels, or null while it is elsewhere. */
  pointer: Point | null = null;
  /** What the page's bars cover, in pixels. */
  insets = () => kNoInsets;
  readonly #questions = signal<Questions>({
    neighbors: true,
    empty: false,
    under: false,
    nearest: 0,
  });
  readonly #hover = signal<Hover | null>(null);
  readonly #tool = signal({ id: "select" });
  readonly #looks = signal(0);
  #newPixels = kFirstRadius;

  constructor(canvases: Canvases) {
    this.painter = new Painter(canvases, this.model, this.view);
    this.model.on("before", (change) => this.#redrawAround(change));
    this.model.on("change", (change) => {
      if (change.isSet) this.painter.forget();
      this.#redrawAround(change);
      this.refreshHover();
    });
    effect(() => {
      this.painter.overlay.selected = this.selection.ids;
      this.painter.redrawOverlay();
    });
  }

  get diagram() {
    return this.model.diagram;
  }

  get sites() {
    return this.model.sites;
  }

  /** What is answered at the pointer. */
  get hover() {
    return this.#hover.value;
  }

  get questions() {
    return this.#questions.value;
  }

  /** The id of the chosen tool (tools/registry.ts). */
  get tool() {
    return this.#tool.value.id;
  }

  /** Choosing the same one again counts, too: it ends what is under way. */
  set tool(id: string) {
    this.#tool.value = { id };
  }

  /** How often the view has changed. */
  get looks() {
    return this.#looks.value;
  }

  /** @param change about to happen, or just happened */
  #redrawAround({ ids }: Change) {
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
  rounded(value: number) {
    return roundedTo(value, this.view.digits(0.2));
  }

  /** Inserts a circle at a pixel and selects it. @param r in the diagram's units */
  insertAt(x: number, y: number, r: number = this.#newPixels / this.view.scale) {
    return this.insertCircle({ x: this.view.toWorldX(x), y: this.view.toWorldY(y), r });
  }

  /** Inserts a circle and selects it. */
  insertCircle({ x, y, r }: Circle) {
    const numbers = [this.rounded(x), this.rounded(y), this.rounded(r)];
    const [id] = this.model.insert(Float64Array.from(numbers));
    this.selection.set([id]);
    return id;
  }

  /** The circle that a click would insert. */
  draftAt(x: number, y: number) {
    return {
      x: this.view.toWorldX(x),
      y: this.view.toWorldY(y),
      r: this.#newPixels / this.view.scale,
    };
  }

  /** New circles are as large on the screen as this one. */
  remember(id: number) {
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
  nudge(dx: number, dy: number) {
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
  grow(factor: number) {
    const { ids } = this.selection;
    if (ids.length === 0) return;
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

  #selectOf(command: Command | null) {
    if (!command?.ids || command.ids.length > kMostBoxes) return;
    this.selection.set(Array.from(command.ids).filter((id) => this.diagram.has(id)));
  }

  // --- Pointer -----------------------------------------------------------------------------------

  /**
   * The circles at a pixel, those that contain it and those that it misses by `reach` pixels: the
   * nearest one first, which is what hovering highlights. Hidden ones only if they are shown.
   */
  at(x: number, y: number, reach: number): number[] {
    const { view, painter } = this;
    const [wx, wy] = [view.toWorldX(x), view.toWorldY(y)];
    const found = Array.from(this.diagram.within(wx, wy, reach / view.scale));
    return painter.layers.hidden ? found : found.filter((id) => !this.sites.isHidden(id));
  }

  /** Highlights the site nearest to a pixel; null: the pointer has left. */
  hoverAt(pointer: Point | null) {
    this.pointer = pointer;
    this.refreshHover();
  }

  refreshHover() {
    const hover = this.pointer ? this.#answers(this.pointer) : null;
    this.painter.overlay.hover = hover;
    this.painter.redrawOverlay();
    this.#hover.value = hover;
  }

  #answers({ x, y }: Point): Hover | null {
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
      neighbors: questions.neighbors ? neighborsOf(this.sites, id) : kNothing,
      nearest: questions.nearest > 0 ? diagram.kNearest(wx, wy, questions.nearest) : kNothing,
      under: questions.under ? diagram.within(wx, wy, 0) : kNothing,
      empty: questions.empty ? this.#emptyNear(id, wx, wy) : null,
    };
  }

  /** The empty circle about the corner of this cell that is nearest to a point. */
  #emptyNear(id: number, wx: number, wy: number): Circle | null {
    const { view, sites } = this;
    const [left, right] = [view.toWorldX(-view.width), view.toWorldX(2 * view.width)];
    const [bottom, top] = [view.toWorldY(2 * view.height), view.toWorldY(-view.height)];
    const cell = this.diagram.voronoi([left, bottom, right, top]).cellCurves(id);
    if (!cell) return null;
    const site = sites.site(id);
    let best: Circle | null = null;
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

  /** What else is drawn over the picture. */
  mark(overlay: Partial<Overlay>) {
    Object.assign(this.painter.overlay, overlay);
    this.painter.redrawOverlay();
  }

  // --- View --------------------------------------------------------------------------------------

  setLayer(name: keyof Layers, isShown: boolean) {
    this.painter.setLayer(name, isShown);
  }

  ask(questions: Partial<Questions>) {
    this.#questions.value = { ...this.questions, ...questions };
    this.refreshHover();
  }

  pan(dx: number, dy: number) {
    this.view.pan(dx, dy);
    this.viewChanged();
  }

  zoom(factor: number, x = this.#middle.x, y = this.#middle.y) {
    this.view.zoom(factor, x, y);
    this.viewChanged();
  }

  /** Shows all circles beside the bars. */
  fit(bounds = this.sites.bounds(), margin?: number) {
    this.view.fit(bounds ? withExtent(bounds) : [0, 0, 1000, 600], this.insets(), margin);
    this.viewChanged();
  }

  /** Moves the view as little as it must to show a circle's centre. */
  show(id: number) {
    const { x, y } = this.sites.site(id);
    const [px, py] = [this.view.toScreenX(x), this.view.toScreenY(y)];
    const { left, top, right, bottom } = this.insets();
    const into = (p: number, low: number, high: number) =>
      Math.max(low - p, 0) + Math.min(high - p, 0);
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
    this.#looks.value = this.#looks.peek() + 1;
  }
}
