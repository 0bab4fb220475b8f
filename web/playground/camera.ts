// Moves the view, and tells the picture, the pointer and whoever asks for `looks`.
import type { Bounds } from "./model/circle.js";
import type { Model } from "./model/model.js";
import { signal } from "./model/signals.js";
import type { View } from "./picture/view.js";
import type { Pointer } from "./pointer.js";

const kEdge = 24; // pixels from the border at which a circle moved by keys takes the view along
const kNoInsets = { left: 0, top: 0, right: 0, bottom: 0 };

/** One point has no extent: as much around it as it is away from zero, but 1 at least. */
function withExtent([xmin, ymin, xmax, ymax]: Bounds): Bounds {
  if (xmin < xmax || ymin < ymax) return [xmin, ymin, xmax, ymax];
  const reach = Math.max(1, Math.abs(xmin), Math.abs(ymin));
  return [xmin - reach, ymin - reach, xmin + reach, ymin + reach];
}

export class Camera {
  /** The margins that the page's bars cover, in pixels. */
  insets = () => kNoInsets;
  readonly #looks = signal(0);

  constructor(
    readonly model: Model,
    readonly view: View,
    readonly pointer: Pointer,
  ) {}

  /** How often the view has changed. */
  get looks() {
    return this.#looks.value;
  }

  pan(dx: number, dy: number) {
    this.view.pan(dx, dy);
    this.viewChanged();
  }

  zoom(factor: number, x = this.#middle.x, y = this.#middle.y) {
    this.view.zoom(factor, x, y);
    this.viewChanged();
  }

  /** Shows all circles beside the bars. */
  fit(bounds = this.model.sites.bounds(), margin?: number) {
    this.view.fit(bounds ? withExtent(bounds) : [0, 0, 1000, 600], this.insets(), margin);
    this.viewChanged();
  }

  /** Moves the view as little as it must to show a circle's centre. */
  show(id: number) {
    const { x, y } = this.model.sites.site(id);
    const [px, py] = [this.view.toScreenX(x), this.view.toScreenY(y)];
    const { left, top, right, bottom } = this.insets();
    const into = (p: number, low: number, high: number) =>
      Math.max(low - p, 0) + Math.min(high - p, 0);
    const dx = into(px, left + kEdge, this.view.width - right - kEdge);
    const dy = into(py, top + kEdge, this.view.height - bottom - kEdge);
    if (dx !== 0 || dy !== 0) this.pan(dx, dy);
  }

  /** The middle of what the bars leave free. */
  get #middle() {
    const { left, top, right, bottom } = this.insets();
    return {
      x: (left + this.view.width - right) / 2,
      y: (top + this.view.height - bottom) / 2,
    };
  }

  /** Where keys act: under the pointer, else in the middle. */
  get place() {
    return this.pointer.at ?? this.#middle;
  }

  /** The view has been changed. */
  viewChanged() {
    this.pointer.painter.viewChanged();
    this.pointer.refresh();
    this.#looks.value = this.#looks.peek() + 1;
  }
}
