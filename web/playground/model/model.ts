// What the page shows and how it came about. Every edit goes through here, so that everything can
// be undone.
import { type Command, insertion, movement, removal, replacement } from "./commands.js";
import { Emitter } from "./emitter.js";
import { History } from "./history.js";
import { signal } from "./signals.js";
import { emptySites, type Label, type Sites } from "./sites.js";

/** The circles that are about to change or have changed (null: all); whether it is another set. */
export type Change = { ids: ArrayLike<number> | null; isSet: boolean };

/**
 * A move or change of size that is still going on: steps of a drag are one edit. Whatever else
 * changes the circles ends it, as it stands; whoever drags asks `isOpen` before each step.
 */
export class OpenChange {
  readonly before: Float64Array;
  after: Float64Array;

  constructor(
    readonly model: Model,
    readonly ids: ArrayLike<number>,
  ) {
    this.before = model.sites.triples(ids);
    this.after = this.before;
  }

  get isOpen() {
    return this.model.open === this;
  }

  to(xyr: Float64Array) {
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

/** "before" and after each change. */
export type ModelEvents = { before: Change; change: Change };

export class Model extends Emitter<ModelEvents> {
  sites = emptySites();
  history = new History();
  open: OpenChange | null = null;

  readonly #edits = signal(0);

  /** How often something was done, undone or done again. */
  get edits() {
    return this.#edits.value;
  }

  get canUndo() {
    return this.edits > 0 && this.history.canUndo;
  }

  get canRedo() {
    return this.edits > 0 && this.history.canRedo;
  }

  get diagram() {
    return this.sites.diagram;
  }

  /** @param xyr x, y, r of each @returns ids */
  insert(xyr: Float64Array, labels?: readonly (Label | undefined)[]): Uint32Array {
    this.open?.commit();
    const command = insertion(this.sites, xyr, labels);
    this.#do(command);
    return command.ids;
  }

  /** @param ids those that do not exist are passed over */
  remove(ids: ArrayLike<number>) {
    this.open?.commit();
    const there = Array.from(ids).filter((id) => this.diagram.has(id));
    if (there.length > 0) this.#do(removal(this.sites, there));
  }

  update(ids: ArrayLike<number>, xyr: Float64Array) {
    this.open?.commit();
    this.#do(movement(this.sites, ids, this.sites.triples(ids), xyr));
  }

  /** Begins a change in steps. */
  begin(ids: ArrayLike<number>) {
    this.open?.commit();
    this.open = new OpenChange(this, ids);
    return this.open;
  }

  /** Shows another set; the first one has no way back. */
  replace(sites: Sites, { isFirst = false } = {}) {
    this.open?.commit();
    const command = replacement(this, sites);
    if (isFirst) this.run(null, () => command.redo(), true);
    else this.#do(command);
  }

  /** Lets this share of the radii count; no edit. */
  weigh(weight: number) {
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
  run(ids: ArrayLike<number> | null, change: () => void, isSet = false) {
    this.#tell("before", ids, isSet);
    try {
      change();
    } finally {
      this.#tell("change", ids, isSet);
    }
  }

  /** @param command that has been done */
  record(command: Command) {
    this.history.push(command);
    this.#edits.value = this.#edits.peek() + 1;
  }

  #do(command: Command) {
    this.#tell("before", command.name === "insert" ? [] : command.ids, command.ids === null);
    try {
      command.redo();
    } finally {
      this.#tell("change", command.ids, command.ids === null);
    }
    this.record(command);
  }

  #travel(direction: "undo" | "redo"): Command | null {
    this.open?.commit();
    const { weight } = this.sites;
    this.#tell("before", null, false);
    const command = this.history[direction]();
    if (command && this.sites.weight !== weight) this.sites.weigh(weight);
    this.#tell("change", null, command?.ids === null);
    this.#edits.value = this.#edits.peek() + 1;
    return command;
  }

  #tell(type: "before" | "change", ids: ArrayLike<number> | null, isSet: boolean) {
    this.emit(type, { ids, isSet });
  }
}
