// The selected circles; the one that was selected last comes last.
import type { Model } from "./model.js";
import { signal } from "./signals.js";

export class Selection {
  readonly #ids = signal<readonly number[]>([]);

  constructor(model: Model) {
    model.on("change", ({ isSet }) => {
      const left = isSet ? [] : this.ids.filter((id) => model.diagram.has(id));
      if (left.length !== this.ids.length) this.set(left);
    });
  }

  get ids(): readonly number[] {
    return this.#ids.value;
  }

  get size() {
    return this.ids.length;
  }

  /** The only selected circle, or -1. */
  get single() {
    return this.ids.length === 1 ? this.ids[0] : -1;
  }

  /** The one that was selected last, or -1. */
  get last() {
    return this.ids.at(-1) ?? -1;
  }

  has(id: number) {
    return this.ids.includes(id);
  }

  set(ids: Iterable<number>) {
    const wanted = [...new Set(ids)];
    if (wanted.length === this.ids.length && wanted.every((id, k) => id === this.ids[k])) return;
    this.#ids.value = wanted;
  }

  clear() {
    this.set([]);
  }

  toggle(id: number) {
    this.set(this.has(id) ? this.ids.filter((other) => other !== id) : [...this.ids, id]);
  }

  add(ids: Iterable<number>) {
    this.set([...this.ids, ...ids]);
  }
}
