// Delete: what is clicked, and whatever the pointer is dragged over.
import type { App } from "../app.js";
import { kReach, type Touch } from "./gestures.js";

export class DeleteGesture {
  readonly cursor = "pointer";
  #start: Touch | null;

  constructor(
    readonly app: App,
    at: Touch,
  ) {
    this.#start = at;
  }

  move(at: Touch) {
    if (this.#start) this.#removeAt(this.#start);
    this.#start = null;
    this.#removeAt(at);
  }

  end() {
    if (this.#start) this.#removeAt(this.#start);
  }

  cancel() {}

  #removeAt(at: Touch) {
    const [id] = this.app.at(at.x, at.y, kReach[at.type]);
    if (id !== undefined) this.app.model.remove([id]);
  }
}
