// The circles of one set and their diagram, with what drawing needs beside it: a mirror of the
// numbers, names, and which of them are hidden. Only commands (commands.js) change it.
import { Diagram, type Voronoi } from "apollonius-diagram";
import type { Bounds, Circle } from "./circle.js";
import type { Globe } from "./globe.js";
import type { WorldMap } from "./world_map.js";

export type Label = { name: string; detail?: string };
/** The origin of the circles: the preset's key is what the page's address says. */
export type SetInfo = {
  key: string;
  title: string;
  about?: string;
  areaUnit?: string;
  credit?: "cities";
  params?: Record<string, unknown>;
  map?: WorldMap | null;
  /** On the map of the Earth: the true distances. */
  globe?: Globe;
};

const kUnknown = 0;
const kVisible = 1;
const kHidden = 2;

export class Sites {
  diagram: Diagram;
  /** x, y, r by id; rows of ids that do not exist are stale. */
  xyr: Float64Array;
  /** The circles that the set came with, x, y, r by id: what edits are told from. */
  original: Float64Array;
  labels = new Map<number, Label>();
  info: SetInfo;
  /** Milliseconds that building the diagram took. */
  buildTime: number;
  #ids: Uint32Array | null = null;
  #flags; // by id: kUnknown until asked for
  #cells: { rings: number[][]; cells: Voronoi } | null = null;

  /**
   * @param xyr ids are 0, 1, 2, … in this order
   * @param more a diagram that has been built already; what can be had again without these numbers
   */
  constructor(
    xyr: Float64Array,
    info: SetInfo,
    {
      labels = [],
      diagram,
      buildTime,
      original = xyr,
    }: {
      labels?: readonly (Label | undefined)[];
      diagram?: Diagram;
      buildTime?: number;
      original?: Float64Array;
    } = {},
  ) {
    const start = performance.now();
    this.diagram = diagram ?? new Diagram(xyr);
    this.buildTime = buildTime ?? performance.now() - start;
    this.original = original;
    this.xyr = xyr.slice();
    this.#flags = new Uint8Array(xyr.length / 3);
    this.info = info;
    labels.forEach((label, id) => label && this.labels.set(id, label));
  }

  get size() {
    return this.diagram.size;
  }

  /** All ids, ascending. */
  get ids() {
    this.#ids ??= this.diagram.ids();
    return this.#ids;
  }

  site(id: number): Circle {
    return { x: this.xyr[3 * id], y: this.xyr[3 * id + 1], r: this.xyr[3 * id + 2] };
  }

  radius(id: number) {
    return this.xyr[3 * id + 2];
  }

  /** x, y, r of several. */
  triples(ids: ArrayLike<number>) {
    const xyr = new Float64Array(3 * ids.length);
    for (let k = 0; k < ids.length; k++)
      xyr.set(this.xyr.subarray(3 * ids[k], 3 * ids[k] + 3), 3 * k);
    return xyr;
  }

  label(id: number): Label {
    return this.labels.get(id) ?? { name: `Circle ${id}` };
  }

  isHidden(id: number) {
    if (this.#flags[id] === kUnknown)
      this.#flags[id] = this.diagram.isHidden(id) ? kHidden : kVisible;
    return this.#flags[id] === kHidden;
  }

  /** The cells in rings x, y, …. Those in the last ones are kept: they are prepared once. */
  cellsIn(rings: number[][]) {
    if (this.#cells?.rings !== rings) this.#cells = { rings, cells: this.diagram.voronoi(rings) };
    return this.#cells.cells;
  }

  /** Those of all circles, or null. */
  bounds(): Bounds | null {
    if (this.size === 0) return null;
    const { ids, xyr } = this;
    let [xmin, ymin, xmax, ymax] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < ids.length; k++) {
      const at = 3 * ids[k];
      const r = Math.max(xyr[at + 2], 0);
      xmin = Math.min(xmin, xyr[at] - r);
      ymin = Math.min(ymin, xyr[at + 1] - r);
      xmax = Math.max(xmax, xyr[at] + r);
      ymax = Math.max(ymax, xyr[at + 1] + r);
    }
    return [xmin, ymin, xmax, ymax];
  }

  // --- Changes -----------------------------------------------------------------------------------

  /** @returns their ids */
  insert(xyr: Float64Array): Uint32Array {
    const ids = this.diagram.insertMany(xyr);
    this.#mirror(ids, xyr);
    this.#changed(true);
    return ids;
  }

  remove(ids: ArrayLike<number>) {
    this.diagram.removeMany(ids);
    for (let k = 0; k < ids.length; k++) this.labels.delete(ids[k]);
    this.#changed(true);
  }

  update(ids: ArrayLike<number>, xyr: Float64Array) {
    if (ids.length === 1) this.diagram.update(ids[0], xyr[0], xyr[1], xyr[2]);
    else this.diagram.updateMany(ids, xyr);
    this.#mirror(ids, xyr);
    this.#changed(false);
  }

  /** Draws the cell that a circle would have, by a function of its id; nothing is changed. */
  tryOut<Drawn>({ x, y, r }: Circle, draw: (id: number) => Drawn): Drawn {
    const id = this.diagram.insert(x, y, r);
    try {
      return draw(id);
    } finally {
      this.diagram.remove(id);
    }
  }

  dispose() {
    this.diagram.dispose();
  }

  #mirror(ids: ArrayLike<number>, xyr: Float64Array) {
    let length = this.xyr.length;
    for (let k = 0; k < ids.length; k++) length = Math.max(length, 3 * ids[k] + 3);
    if (length > this.xyr.length) {
      const larger = new Float64Array(Math.max(48, length, 2 * this.xyr.length));
      larger.set(this.xyr);
      this.xyr = larger;
    }
    for (let k = 0, n = 0; k < ids.length; k++) {
      const at = 3 * ids[k];
      this.xyr[at] = xyr[n++];
      this.xyr[at + 1] = xyr[n++];
      this.xyr[at + 2] = xyr[n++];
    }
  }

  #changed(idsToo: boolean) {
    if (idsToo) this.#ids = null;
    const needed = this.xyr.length / 3;
    if (this.#flags.length < needed) this.#flags = new Uint8Array(needed);
    else this.#flags.fill(kUnknown);
  }
}

export const emptySites = () =>
  new Sites(new Float64Array(0), { key: "empty", title: "Nothing yet" });
