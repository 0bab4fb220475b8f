// What the page shows and how it came about. Every edit goes through here, so that everything can
// be undone.
import { insertion, movement, removal, replacement } from "./commands.js";
import { History } from "./history.js";
import { emptySites } from "./sites.js";

/** @typedef {import("./sites.js").Sites} Sites */

/** @typedef {import("./commands.js").Command} Command */
/**
 * @typedef {{ ids: ArrayLike<number> | null, isSet: boolean }} Change the circles that are about to
 * change or have changed (null: all); whether it is another set
 */

/**
 * A move or change of size that is still going on: steps of a drag are one edit. Whatever else
 * changes the circles ends it, as it stands; whoever drags asks `isOpen` before each step.
 */
class OpenChange {
  /** @param {Model} model @param {ArrayLike<number>} ids */
  constructor(model, ids) {
    this.model = model;
    this.ids = ids;
    /** @type {Float64Array} */ this.before = model.sites.triples(ids);
    /** @type {Float64Array} */ this.after = this.before;
  }

  get isOpen() {
    return this.model.open === this;
  }

  /** @param {Float64Array} xyr */
  to(xyr) {
    this.model.run(this.ids, () => this.model.sites.update(this.ids, xyr));
    this.after = xyr;
  }

  commit() {
    if (!this.isOpen) return;
    this.model.open = null;
    if (this.after !== this.before)
      this.model.record(movement(this.model.sites, this.ids, this.before, this.after));
  }

  /** Ends it where it is, as no edit: the set is taken to have been like this. */
  leave() {
    if (!this.isOpen) return;
    this.model.open = null;
    const { original } = this.model.sites;
    for (let k = 0; k < this.ids.length; k++)
      original.set(this.after.subarray(3 * k, 3 * k + 3), 3 * this.ids[k]);
  }

  cancel() {
    if (!this.isOpen) return;
    if (this.after !== this.before) this.to(this.before);
    this.model.open = null;
  }
}

/** Events: "before" and "change", with a Change; "history". */
export class Model extends EventTarget {
  sites = emptySites();
  history = new History();
  /** @type {OpenChange | null} */ open = null;

  get diagram() {
    return this.sites.diagram;
  }

  /** @param {Float64Array} xyr x, y, r of each @returns {Uint32Array} ids */
  insert(xyr, labels) {
    this.open?.commit();
    const command = insertion(this.sites, xyr, labels);
    this.#do(command);
    return command.ids;
  }

  /** @param {ArrayLike<number>} ids those that do not exist are passed over */
  remove(ids) {
    this.open?.commit();
    const there = Array.from(ids).filter((id) => this.diagram.has(id));
    if (there.length > 0) this.#do(removal(this.sites, there));
  }

  /** @param {ArrayLike<number>} ids @param {Float64Array} xyr */
  update(ids, xyr) {
    this.open?.commit();
    this.#do(movement(this.sites, ids, this.sites.triples(ids), xyr));
  }

  /** Begins a change in steps. @param {ArrayLike<number>} ids */
  begin(ids) {
    this.open?.commit();
    this.open = new OpenChange(this, ids);
    return this.open;
  }

  /** Shows another set; the first one has no way back. @param {Sites} sites */
  replace(sites, { isFirst = false } = {}) {
    this.open?.commit();
    const command = replacement(this, sites);
    if (isFirst) this.run(null, () => command.redo(), true);
    else this.#do(command);
  }

  /** Lets this share of the radii count; no edit. @param {number} weight */
  weigh(weight) {
    this.open?.commit();
    this.run(null, () => this.sites.weigh(weight));
  }

  undo() {
    return this.#travel("undo");
  }

  redo() {
    return this.#travel("redo");
  }

  // --- For this folder ---------------------------------------------------------------------------

  /** Changes these circles (null: all) with the events around it. */
  run(ids, change, isSet = false) {
    this.#tell("before", ids, isSet);
    try {
      change();
    } finally {
      this.#tell("change", ids, isSet);
    }
  }

  /** @param {Command} command that has been done */
  record(command) {
    this.history.push(command);
    this.dispatchEvent(new Event("history"));
  }

  /** @param {Command} command */
  #do(command) {
    this.#tell("before", command.name === "insert" ? [] : command.ids, command.ids === null);
    try {
      command.redo();
    } finally {
      this.#tell("change", command.ids, command.ids === null);
    }
    this.record(command);
  }

  /** @param {"undo" | "redo"} direction @returns {Command | null} */
  #travel(direction) {
    this.open?.commit();
    const { weight } = this.sites;
    this.#tell("before", null, false);
    const command = this.history[direction]();
    if (command && this.sites.weight !== weight) this.sites.weigh(weight);
    this.#tell("change", null, command?.ids === null);
    this.dispatchEvent(new Event("history"));
    return command;
  }

  #tell(type, ids, isSet) {
    this.dispatchEvent(new CustomEvent(type, { detail: { ids, isSet } }));
  }
}
