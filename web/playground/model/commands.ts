// Commands change the circles, each with its way back. Ids come back too: a diagram gives the id
// that was freed last first, and history goes strictly backwards.
import type { Label, Sites } from "./sites.js";

/** The ids that it touches, null for all. */
export type Command = {
  name: string;
  ids: ArrayLike<number> | null;
  redo(): void;
  undo(): void;
  retained?: Sites[];
  release?(): void;
};

const reversed = (ids: ArrayLike<number>) => Uint32Array.from(ids).reverse();

export function insertion(
  sites: Sites,
  xyr: Float64Array,
  labels: readonly (Label | undefined)[] = [],
) {
  const command = {
    name: "insert",
    ids: new Uint32Array(0) as Uint32Array,
    redo() {
      command.ids = sites.insert(xyr);
      labels.forEach((label, k) => label && sites.labels.set(command.ids[k], label));
    },
    undo() {
      sites.remove(reversed(command.ids));
    },
  };
  return command;
}

export function removal(sites: Sites, ids: ArrayLike<number>) {
  const backwards = reversed(ids);
  const xyr = sites.triples(backwards);
  const labels = Array.from(ids, (id) => [id, sites.labels.get(id)] as const);
  return {
    name: "delete",
    ids,
    redo: () => sites.remove(ids),
    undo() {
      sites.insert(xyr);
      for (const [id, label] of labels) if (label) sites.labels.set(id, label);
    },
  };
}

export function movement(
  sites: Sites,
  ids: ArrayLike<number>,
  before: Float64Array,
  after: Float64Array,
) {
  return {
    name: "change",
    ids,
    redo: () => sites.update(ids, after),
    undo: () => sites.update(ids, before),
  };
}

/** Shows another set. */
export function replacement(model: { sites: Sites }, after: Sites) {
  const before = model.sites;
  let isDone = false;
  return {
    name: "set",
    ids: null,
    retained: [before, after],
    redo() {
      model.sites = after;
      isDone = true;
    },
    undo() {
      model.sites = before;
      isDone = false;
    },
    /** The one that is not shown will never be again. */
    release: () => (isDone ? before : after).dispose(),
  };
}
