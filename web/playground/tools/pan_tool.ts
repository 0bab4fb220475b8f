// Pan: the view moves with the pointer.
import type { App } from "../app.js";
import type { Gesture, Tool, Touch } from "./tool.js";

export class PanGesture implements Gesture {
  readonly cursor = "grabbing";
  #last: Touch;

  constructor(
    readonly app: App,
    at: Touch,
  ) {
    this.#last = at;
  }

  move(at: Touch) {
    this.app.camera.pan(at.x - this.#last.x, at.y - this.#last.y);
    this.#last = at;
  }

  end() {}

  cancel() {}
}

export const panTool: Tool = {
  id: "pan",
  key: "h",
  label: "Pan",
  icon: [["path", { d: "M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3" }]],
  cursor: () => "grab",
  gesture: (app: App, at: Touch): Gesture => new PanGesture(app, at),
  ignoresAlt: true,
};
