// Delete: what is clicked, and whatever the pointer is dragged over.
import { kReach } from "./gestures.js";

export class DeleteGesture {
  cursor = "pointer";

  /** @param {import("../app.js").App} app @param {import("./gestures.js").Touch} at */
  constructor(app, at) {
    this.app = app;
    this.start = at;
  }

  move(at) {
    if (this.start) this.#removeAt(this.start);
    this.start = null;
    this.#removeAt(at);
  }

  end() {
    if (this.start) this.#removeAt(this.start);
  }

  cancel() {}

  #removeAt(at) {
    const [id] = this.app.at(at.x, at.y, kReach[at.type] ?? 5);
    if (id !== undefined) this.app.model.remove([id]);
  }
}
