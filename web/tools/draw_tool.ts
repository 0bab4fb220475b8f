// Draw: the pointer goes down at the centre and is dragged to the rim; a click inserts a circle of
// the size of the last one. The cell that it will have is shown.
import type { App, Point } from "../app.js";
import type { Touch } from "./gestures.js";

export class DrawGesture {
  readonly cursor = "crosshair";
  readonly #centre: Point;
  #hasMoved = false;

  constructor(
    readonly app: App,
    at: Touch,
  ) {
    this.#centre = { x: app.view.toWorldX(at.x), y: app.view.toWorldY(at.y) };
    app.mark({ draft: app.draftAt(at.x, at.y) });
  }

  move(at: Touch) {
    this.#hasMoved = true;
    this.app.mark({ draft: this.#draftTo(at) });
    this.app.refreshHover();
  }

  end(at: Touch) {
    const draft = this.#hasMoved ? this.#draftTo(at) : this.app.draftAt(at.x, at.y);
    this.cancel();
    const id = this.app.insertCircle({ ...this.#centre, r: draft.r });
    this.app.remember(id);
  }

  cancel() {
    this.app.mark({ draft: null });
  }

  #draftTo(at: Touch) {
    const { view } = this.app;
    const r = Math.hypot(
      view.toWorldX(at.x) - this.#centre.x,
      view.toWorldY(at.y) - this.#centre.y,
    );
    return { ...this.#centre, r };
  }
}
