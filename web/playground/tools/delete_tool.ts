// Delete: what is clicked, and whatever the pointer is dragged over.
import type { App } from "../app.js";
import { type Gesture, kReach, type Tool, type Touch } from "./tool.js";

export class DeleteGesture implements Gesture {
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
    const [id] = this.app.pointer.circlesAt(at.x, at.y, kReach[at.type]);
    if (id !== undefined) this.app.model.remove([id]);
  }
}

export const deleteTool: Tool = {
  id: "delete",
  key: "x",
  label: "Delete",
  icon: [["path", { d: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13M10.5 11v5M13.5 11v5" }]],
  cursor: (app: App, at: Touch): string =>
    app.pointer.circlesAt(at.x, at.y, kReach.mouse).length > 0 ? "pointer" : "crosshair",
  gesture: (app: App, at: Touch): Gesture => new DeleteGesture(app, at),
  /** With something selected, "Delete" is what it says. */
  press(app: App): boolean {
    if (app.selection.size === 0) return false;
    app.edits.removeSelected();
    return true;
  },
};
