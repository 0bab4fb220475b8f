// Pan: the view moves with the pointer.
import type { App } from "../app.js";
import type { Touch } from "./gestures.js";

export class PanGesture {
  readonly cursor = "grabbing";
  #last: Touch;

  constructor(
    readonly app: App,
    at: Touch,
  ) {
    this.#last = at;
  }

  move(at: Touch) {
    this.app.pan(at.x - this.#last.x, at.y - this.#last.y);
    this.#last = at;
  }

  end() {}

  cancel() {}
}
