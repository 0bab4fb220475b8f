// All changes of circles that a tool, a key or a button makes; each can be undone.
import { roundedTo } from "../shared/rounding.js";
import type { Camera } from "./camera.js";
import type { Circle } from "./model/circle.js";
import type { Command } from "./model/commands.js";
import type { Model } from "./model/model.js";
import type { Selection } from "./model/selection.js";
import { emptySites } from "./model/sites.js";

const kFirstRadius = 16; // pixels: a new circle, until the user has resized one
const kMostSelected = 12; // circles that undo and redo select, as what they changed

/** The parts of the page that edits use; `tool` is the id of the chosen tool. */
type Page = { model: Model; selection: Selection; camera: Camera; tool: string };

export class Edits {
  readonly #page: Page;
  #newPixels = kFirstRadius;

  constructor(page: Page) {
    this.#page = page;
  }

  get #model() {
    return this.#page.model;
  }

  get #selection() {
    return this.#page.selection;
  }

  get #view() {
    return this.#page.camera.view;
  }

  /** A number that says no more than a pixel shows. */
  rounded(value: number) {
    return roundedTo(value, this.#view.digits(0.2));
  }

  /** The circle that a click at a pixel would insert. */
  draftAt(x: number, y: number): Circle {
    const view = this.#view;
    return { x: view.toWorldX(x), y: view.toWorldY(y), r: this.#newPixels / view.scale };
  }

  /** Inserts it and selects it. */
  insertAt(x: number, y: number) {
    return this.insertCircle(this.draftAt(x, y));
  }

  /** Inserts a circle and selects it. */
  insertCircle({ x, y, r }: Circle) {
    const numbers = [this.rounded(x), this.rounded(y), this.rounded(r)];
    const [id] = this.#model.insert(Float64Array.from(numbers));
    this.#selection.set([id]);
    return id;
  }

  /** New circles are as large on the screen as this one. */
  remember(id: number) {
    const { r } = this.#model.sites.site(id);
    this.#newPixels = Math.max(4, Math.min(60, r * this.#view.scale));
  }

  /** Also ends drawing: the next click would insert what has just been deleted. */
  removeSelected() {
    this.#model.remove(this.#selection.ids);
    if (this.#page.tool === "draw") this.#page.tool = "select";
  }

  /** Copies of the selected ones beside them, selected. */
  duplicate() {
    const { sites } = this.#model;
    const { ids } = this.#selection;
    if (ids.length === 0) return;
    const shift = this.rounded(24 / this.#view.scale);
    const xyr = sites.triples(ids).map((v, k) => [v + shift, v - shift, v][k % 3]);
    const labels = ids.map((id) => sites.labels.get(id));
    this.#selection.set(this.#model.insert(xyr, labels));
  }

  /** Moves the selected ones by pixels and takes the view along. */
  nudge(dx: number, dy: number) {
    const { ids } = this.#selection;
    const shift = [this.rounded(dx / this.#view.scale), this.rounded(-dy / this.#view.scale), 0];
    this.#model.update(
      ids,
      this.#model.sites
        .triples(ids)
        .map((v, k) => (k % 3 === 2 ? v : this.rounded(v + shift[k % 3]))),
    );
    this.#page.camera.show(this.#selection.last);
  }

  /** Makes the selected ones larger or smaller. */
  grow(factor: number) {
    const { ids } = this.#selection;
    if (ids.length === 0) return;
    const least = 1 / this.#view.scale;
    this.#model.update(
      ids,
      this.#model.sites
        .triples(ids)
        .map((v, k) => (k % 3 === 2 ? this.rounded(Math.max(v, least) * factor) : v)),
    );
    if (ids.length === 1) this.remember(ids[0]);
  }

  /** An empty set in place of this one: the way back costs nothing, however many there are. */
  clear() {
    this.#model.replace(emptySites());
  }

  undo() {
    this.#selectOf(this.#model.undo());
  }

  redo() {
    this.#selectOf(this.#model.redo());
  }

  #selectOf(command: Command | null) {
    if (!command?.ids || command.ids.length > kMostSelected) return;
    const { diagram } = this.#model;
    this.#selection.set(Array.from(command.ids).filter((id) => diagram.has(id)));
  }
}
