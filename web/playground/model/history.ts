// Commands that were done and can be undone, and the other way round.
import type { Command } from "./commands.js";

const kMost = 500; // commands
const kMostSites = 2_000_000; // in sets that are not shown but could be again

export class History {
  #done: Command[] = [];
  #undone: Command[] = [];

  get canUndo() {
    return this.#done.length > 0;
  }

  get canRedo() {
    return this.#undone.length > 0;
  }

  /** Remembers what has been done. */
  push(command: Command) {
    for (const lost of this.#undone) lost.release?.();
    this.#undone = [];
    this.#done.push(command);
    while (this.#done.length > 1 && this.#isTooMuch()) this.#done.shift()?.release?.();
  }

  /** Forgets everything, and what only it has kept. */
  clear() {
    for (const lost of [...this.#done, ...this.#undone]) lost.release?.();
    this.#done = [];
    this.#undone = [];
  }

  /** @returns the command that has been undone */
  undo(): Command | null {
    const command = this.#done.pop();
    if (!command) return null;
    command.undo();
    this.#undone.push(command);
    return command;
  }

  redo(): Command | null {
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
