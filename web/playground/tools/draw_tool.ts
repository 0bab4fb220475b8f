// Draw: the pointer goes down at the centre and is dragged to the rim; a click inserts a circle of
// the size of the last one. The cell that it will have is shown.
import type { App } from "../app.js";
import type { Point } from "../pointer.js";
import { isOnHandle, SelectGesture } from "./select_tool.js";
import type { Gesture, Tool, Touch } from "./tool.js";

export class DrawGesture implements Gesture {
  readonly cursor = "crosshair";
  readonly #centre: Point;
  #hasMoved = false;

  constructor(
    readonly app: App,
    at: Touch,
  ) {
    this.#centre = { x: app.view.toWorldX(at.x), y: app.view.toWorldY(at.y) };
    app.mark({ draft: app.edits.draftAt(at.x, at.y) });
  }

  move(at: Touch) {
    this.#hasMoved = true;
    this.app.mark({ draft: this.#draftTo(at) });
    this.app.pointer.refresh();
  }

  end(at: Touch) {
    const draft = this.#hasMoved ? this.#draftTo(at) : this.app.edits.draftAt(at.x, at.y);
    this.cancel();
    const id = this.app.edits.insertCircle({ ...this.#centre, r: draft.r });
    this.app.edits.remember(id);
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

export const drawTool: Tool = {
  id: "draw",
  key: "d",
  label: "Draw",
  icon: [
    ["circle", { cx: "11", cy: "13", r: "7" }],
    ["path", { d: "M11 10v6M8 13h6" }],
  ],
  help: { fine: ["*Alt-drag* draws."] },
  cursor: (app: App, at: Touch): string => (isOnHandle(app, at) ? "ew-resize" : "crosshair"),
  /** The handle resizes what was drawn. */
  gesture: (app: App, at: Touch): Gesture =>
    isOnHandle(app, at) && !at.altKey ? new SelectGesture(app, at) : new DrawGesture(app, at),
  hover(app: App, at: Touch) {
    app.mark({ draft: isOnHandle(app, at) ? null : app.edits.draftAt(at.x, at.y) });
  },
};
