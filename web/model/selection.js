// The selected circles; the one that was selected last comes last.

/** Events: "select". */
export class Selection extends EventTarget {
  /** @type {number[]} */ #ids = [];

  /** @param {import("./model.js").Model} model */
  constructor(model) {
    super();
    model.addEventListener("change", (/** @type {any} */ { detail }) => {
      const left = detail.isSet ? [] : this.#ids.filter((id) => model.diagram.has(id));
      if (left.length !== this.#ids.length) this.set(left);
    });
  }

  /** @returns {readonly number[]} */
  get ids() {
    return this.#ids;
  }

  get size() {
    return this.#ids.length;
  }

  /** The only selected circle, or -1. */
  get single() {
    return this.#ids.length === 1 ? this.#ids[0] : -1;
  }

  /** The one that was selected last, or -1. */
  get last() {
    return this.#ids.at(-1) ?? -1;
  }

  has(id) {
    return this.#ids.includes(id);
  }

  /** @param {Iterable<number>} ids */
  set(ids) {
    const wanted = [...new Set(ids)];
    if (wanted.length === this.#ids.length && wanted.every((id, k) => id === this.#ids[k])) return;
    this.#ids = wanted;
    this.dispatchEvent(new Event("select"));
  }

  clear() {
    this.set([]);
  }

  /** @param {number} id */
  toggle(id) {
    this.set(this.has(id) ? this.#ids.filter((other) => other !== id) : [...this.#ids, id]);
  }

  add(ids) {
    this.set([...this.#ids, ...ids]);
  }
}
