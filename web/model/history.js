// Commands that were done and can be undone, and the other way round.

/** @typedef {import("./commands.js").Command} Command */

const kMost = 500; // commands
const kMostSites = 2_000_000; // in sets that are not shown but could be again

export class History {
  /** @type {Command[]} */ #done = [];
  /** @type {Command[]} */ #undone = [];

  get canUndo() {
    return this.#done.length > 0;
  }

  get canRedo() {
    return this.#undone.length > 0;
  }

  /** Remembers what has been done. @param {Command} command */
  push(command) {
    for (const lost of this.#undone) lost.release?.();
    this.#undone = [];
    this.#done.push(command);
    while (this.#done.length > 1 && this.#isTooMuch()) this.#done.shift().release?.();
  }

  /** @returns {Command | null} the command that has been undone */
  undo() {
    const command = this.#done.pop();
    if (!command) return null;
    command.undo();
    this.#undone.push(command);
    return command;
  }

  /** @returns {Command | null} */
  redo() {
    const command = this.#undone.pop();
    if (!command) return null;
    command.redo();
    this.#done.push(command);
    return command;
  }

  #isTooMuch() {
    const retained = new Set(this.#done.flatMap((command) => command.retained ?? []));
    let sites = 0;
    for (const set of retained) sites += set.size;
    return this.#done.length > kMost || (retained.size > 2 && sites > kMostSites);
  }
}
