// What can be done to the circles, each with its way back. Ids come back too: a diagram gives the
// id that was freed last first, and history goes strictly backwards.

/** @typedef {import("./sites.js").Sites} Sites */
/**
 * @typedef {{
 *   name: string, ids: ArrayLike<number> | null, redo(): void, undo(): void,
 *   retained?: Sites[], release?(): void,
 * }} Command the ids that it touches, null for all
 */

const reversed = (/** @type {ArrayLike<number>} */ ids) => Uint32Array.from(ids).reverse();

/** @param {Sites} sites @param {Float64Array} xyr @param {import("./sites.js").Label[]} labels */
export function insertion(sites, xyr, labels = []) {
  const command = {
    name: "insert",
    /** @type {Uint32Array} */ ids: new Uint32Array(0),
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

/** @param {Sites} sites @param {ArrayLike<number>} ids */
export function removal(sites, ids) {
  const backwards = reversed(ids);
  const xyr = sites.triples(backwards);
  const labels = Array.from(ids, (id) => /** @type {const} */ ([id, sites.labels.get(id)]));
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

/**
 * @param {Sites} sites @param {ArrayLike<number>} ids
 * @param {Float64Array} before @param {Float64Array} after
 */
export function movement(sites, ids, before, after) {
  return {
    name: "change",
    ids,
    redo: () => sites.update(ids, after),
    undo: () => sites.update(ids, before),
  };
}

/** Shows another set. @param {{ sites: Sites }} model @param {Sites} after */
export function replacement(model, after) {
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
