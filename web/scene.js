// The diagram that the page shows, with what drawing needs beside it: a mirror of the circles,
// names, which of them are visible, and how long the last operation took.
import { Diagram } from "apollonius-diagram";

/** @typedef {{ name: string, detail?: string }} Label */
/** @typedef {{ operation: string, micros: number, count: number }} Timing */

/** @typedef {[number, number, number, number]} Bounds xmin, ymin, xmax, ymax */

export class Scene extends EventTarget {
  diagram = new Diagram();
  /** x, y, r by id; rows of ids that do not exist are stale. */
  xyr = new Float64Array(0);
  /** All ids, ascending. @type {Uint32Array} */
  ids = new Uint32Array(0);
  /** @type {Map<number, Label>} */
  labels = new Map();
  /** @type {Timing} */
  timing = { operation: "", micros: 0, count: 1 };
  /** @type {Uint8Array | null} */ #visible = null;

  /** Replaces everything by these circles (x, y, r triples) and their labels. */
  replaceAll(xyr, labels = []) {
    this.diagram.clear();
    this.labels.clear();
    const ids = this.#timed("insert", xyr.length / 3, () => this.diagram.insertMany(xyr));
    this.xyr = new Float64Array(xyr.length);
    ids.forEach((id, k) => {
      this.xyr.set(xyr.subarray(3 * k, 3 * k + 3), 3 * id);
      if (labels[k]) this.labels.set(id, labels[k]);
    });
    this.#changed({ all: true });
  }

  clear() {
    this.replaceAll(new Float64Array(0));
  }

  /** @returns {number} the new site's id */
  insert(x, y, r, label) {
    const id = this.#timed("insert", 1, () => this.diagram.insert(x, y, r));
    this.#mirror(id, x, y, r);
    this.labels.delete(id);
    if (label) this.labels.set(id, label);
    this.#changed({ id, inserted: true });
    return id;
  }

  /** Moves or resizes a site. */
  update(id, x, y, r) {
    this.dispatchEvent(new CustomEvent("before", { detail: { id } }));
    this.#timed("update", 1, () => this.diagram.update(id, x, y, r));
    this.#mirror(id, x, y, r);
    this.#changed({ id });
  }

  remove(id) {
    this.dispatchEvent(new CustomEvent("before", { detail: { id } }));
    this.#timed("remove", 1, () => this.diagram.remove(id));
    this.labels.delete(id);
    this.#changed({ id, removed: true });
  }

  site(id) {
    return { x: this.xyr[3 * id], y: this.xyr[3 * id + 1], r: this.xyr[3 * id + 2] };
  }

  /** @returns {Label} */
  label(id) {
    return this.labels.get(id) ?? { name: `Site ${id}` };
  }

  isVisible(id) {
    return this.visible()[id] === 1;
  }

  /** By id: 1 if the site has a cell. Read from the diagram once after every change. */
  visible() {
    if (!this.#visible) {
      this.#visible = new Uint8Array(this.xyr.length / 3);
      for (const id of this.ids) this.#visible[id] = this.diagram.isHidden(id) ? 0 : 1;
    }
    return this.#visible;
  }

  /**
   * The circle under a point: the smallest that holds it, so that a hidden circle can be reached
   * inside its cover. Circles smaller than `reach` count as that large. -1 if there is none.
   */
  pick(x, y, reach, { visible = true, hidden = true } = {}) {
    const flags = this.visible();
    let best = -1;
    let bestRadius = Infinity;
    let bestDistance = Infinity;
    for (const id of this.ids) {
      const dx = x - this.xyr[3 * id];
      const dy = y - this.xyr[3 * id + 1];
      const r = Math.max(this.xyr[3 * id + 2], reach);
      const square = dx * dx + dy * dy;
      if (square > r * r || r > bestRadius || !(flags[id] ? visible : hidden)) continue;
      if (r < bestRadius || square < bestDistance) {
        best = id;
        bestRadius = r;
        bestDistance = square;
      }
    }
    return best;
  }

  /** Those of all circles, or null. */
  bounds() {
    if (this.ids.length === 0) return null;
    /** @type {Bounds} */
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (const id of this.ids) {
      const { x, y, r } = this.site(id);
      const reach = Math.max(r, 0);
      box[0] = Math.min(box[0], x - reach);
      box[1] = Math.min(box[1], y - reach);
      box[2] = Math.max(box[2], x + reach);
      box[3] = Math.max(box[3], y + reach);
    }
    return box;
  }

  #mirror(id, x, y, r) {
    if (3 * id >= this.xyr.length) {
      const larger = new Float64Array(3 * Math.max(16, 2 * id));
      larger.set(this.xyr);
      this.xyr = larger;
    }
    this.xyr[3 * id] = x;
    this.xyr[3 * id + 1] = y;
    this.xyr[3 * id + 2] = r;
  }

  #timed(operation, count, run) {
    const start = performance.now();
    const result = run();
    this.timing = { operation, count, micros: (performance.now() - start) * 1000 };
    return result;
  }

  #changed(detail) {
    this.#visible = null;
    if (detail.all || detail.inserted || detail.removed) this.ids = this.diagram.ids();
    this.dispatchEvent(new CustomEvent("change", { detail }));
  }
}
