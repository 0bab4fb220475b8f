// Pan: the view moves with the pointer.

export class PanGesture {
  cursor = "grabbing";

  /** @param {import("../app.js").App} app @param {import("./gestures.js").Touch} at */
  constructor(app, at) {
    this.app = app;
    this.last = at;
  }

  move(at) {
    this.app.pan(at.x - this.last.x, at.y - this.last.y);
    this.last = at;
  }

  end() {}

  cancel() {}
}
