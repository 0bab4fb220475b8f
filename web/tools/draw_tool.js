// Draw: the pointer goes down at the centre and is dragged to the rim; a click inserts a circle of
// the size of the last one. The cell that it will have is shown.

export class DrawGesture {
  cursor = "crosshair";

  /** @param {import("../app.js").App} app @param {import("./gestures.js").Touch} at */
  constructor(app, at) {
    this.app = app;
    this.centre = { x: app.view.toWorldX(at.x), y: app.view.toWorldY(at.y) };
    this.hasMoved = false;
    app.mark({ draft: app.draftAt(at.x, at.y) });
  }

  move(at) {
    this.hasMoved = true;
    this.app.mark({ draft: this.#draftTo(at) });
    this.app.refreshHover();
  }

  end(at) {
    const draft = this.hasMoved ? this.#draftTo(at) : this.app.draftAt(at.x, at.y);
    this.cancel();
    const id = this.app.insertCircle({ ...this.centre, r: draft.r });
    this.app.remember(id);
  }

  cancel() {
    this.app.mark({ draft: null });
  }

  #draftTo(at) {
    const { view } = this.app;
    const r = Math.hypot(view.toWorldX(at.x) - this.centre.x, view.toWorldY(at.y) - this.centre.y);
    return { ...this.centre, r };
  }
}
