// The page's circles, and how they came about. Every edit goes through here, so that everything can
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

  /** @param settle takes the last step, when it ends */
  constructor(
    readonly model: Model,
    readonly ids: ArrayLike<number>,
    readonly settle: (change: OpenChange) => void = () => {},
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
    const hasChanged = this.after !== this.before;
    if (hasChanged) this.settle(this);
    this.model.open = null;
    if (hasChanged)
      this.model.record(movement(this.model.sites, this.ids, this.before, this.after));
  }

  /** Ends it where it is, as no edit that could be undone. */
  leave() {
    if (this.isOpen) this.model.open = null;
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
  begin(ids: ArrayLike<number>, settle?: (change: OpenChange) => void) {
    this.open?.commit();
    this.open = new OpenChange(this, ids, settle);
    return this.open;
  }

  /** Shows another set. */
  replace(sites: Sites) {
    this.open?.commit();
    this.#do(replacement(this, sites));
  }

  /** Shows a set from which no way leads back to what was before. */
  restart(sites: Sites) {
    this.open?.commit();
    const wasEdited = this.history.canUndo || this.history.canRedo;
    this.history.clear();
    const command = replacement(this, sites);
    this.run(null, () => command.redo(), true);
    command.release();
    if (wasEdited) this.#edits.value = this.#edits.peek() + 1;
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
    this.#tell("before", null, false);
    const command = this.history[direction]();
    this.#tell("change", null, command?.ids === null);
    this.#edits.value = this.#edits.peek() + 1;
    return command;
  }

  #tell(type: "before" | "change", ids: ArrayLike<number> | null, isSet: boolean) {
    this.emit(type, { ids, isSet });
  }
}
