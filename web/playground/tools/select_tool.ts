// Select: a click selects the circle that hovering highlights, a second one what lies beneath it;
// elsewhere it selects nothing. A drag of a circle moves it, of the handle resizes it; elsewhere it
// moves the view, or with Shift or after a long touch selects what a box holds.
import type { App } from "../app.js";
import type { OpenChange } from "../model/model.js";
import { handleOf, radiusForHandle } from "../picture/overlay_layer.js";
import type { Box } from "../picture/view.js";
import { type Gesture, kReach, type Tool, type Touch } from "./tool.js";

const kHandleReach = { mouse: 9, pen: 12, touch: 24 };
const kSamePlace = 4; // pixels between clicks that mean the same place

export function isOnHandle(app: App, { x, y, type }: Touch) {
  const id = app.selection.single;
  if (id < 0) return false;
  const handle = handleOf(app.view, app.sites, id);
  const distance = Math.hypot(x - handle.x, y - handle.y);
  const fromCentre = Math.hypot(x - handle.x + handle.radius, y - handle.y);
  // a small circle can still be moved
  return distance <= kHandleReach[type] && distance < fromCentre;
}

function cursorOfSelect(app: App, at: Touch): string {
  if (isOnHandle(app, at)) return "ew-resize";
  if (app.sites.size === 0) return "crosshair";
  return app.pointer.circlesAt(at.x, at.y, kReach.mouse).length > 0 ? "move" : "default";
}

export class SelectGesture implements Gesture {
  cursor = "default";
  #drag: { move(at: Touch): boolean; end(): void; cancel(): void } | null = null;
  #isLong = false;
  readonly #found: number[];
  readonly start: Touch;
  readonly isOnHandle: boolean;

  constructor(
    readonly app: App,
    at: Touch,
  ) {
    this.start = at;
    this.#found = app.pointer.circlesAt(at.x, at.y, kReach[at.type]);
    this.isOnHandle = isOnHandle(app, at);
  }

  /** The circle that was under the pointer when it went down, and is still there. */
  get found() {
    return this.#found.filter((id) => this.app.diagram.has(id));
  }

  /** A long touch is what Shift is to a mouse. */
  hold(at: Touch) {
    if (at.type !== "touch") return;
    this.#isLong = true;
    const [id] = this.found;
    if (id !== undefined) this.app.selection.toggle(id);
    else
      this.app.mark({ box: { left: at.x - 8, top: at.y - 8, right: at.x + 8, bottom: at.y + 8 } });
  }

  move(at: Touch) {
    this.#drag ??= this.#begin();
    if (!this.#drag.move(at)) this.#drag = kNoDrag; // what was dragged is gone
    this.app.pointer.refresh();
  }

  end(at: Touch) {
    if (this.#drag) this.#drag.end();
    else if (!this.#isLong) this.#click(at);
    this.app.mark({ box: null });
  }

  cancel() {
    this.#drag?.cancel();
    this.app.mark({ box: null });
  }

  #begin() {
    const { app, start, found } = this;
    const extends_ = start.shiftKey || this.#isLong;
    if (this.isOnHandle && app.selection.single >= 0) {
      this.cursor = "ew-resize";
      return new Resize(app, start);
    }
    if (found.length === 0 && extends_) return new BoxSelection(app, start);
    if (found.length === 0) {
      this.cursor = "grabbing";
      return new ViewDrag(app, start);
    }
    this.cursor = "grabbing";
    // A selected circle is dragged wherever it lies; with it all that are selected.
    const isSelected = found.some((id) => app.selection.has(id));
    if (!isSelected) app.selection.set(extends_ ? [...app.selection.ids, found[0]] : [found[0]]);
    return new Move(app, start);
  }

  #click(at: Touch) {
    const { app, start, found } = this;
    if (found.length === 0) {
      if (!start.shiftKey && !this.isOnHandle) app.selection.clear();
    } else if (start.shiftKey) {
      app.selection.toggle(found[0]);
    } else {
      app.selection.set([found[nextIn(found, app.selection.single, at)]]);
    }
    lastClick = { x: at.x, y: at.y };
  }
}

let lastClick = { x: Infinity, y: Infinity };

/** The first, or what follows the selected one if the click is where the last one was. */
function nextIn(found: number[], selected: number, at: Touch) {
  const isSame = Math.hypot(at.x - lastClick.x, at.y - lastClick.y) <= kSamePlace;
  const index = isSame ? found.indexOf(selected) : -1;
  return (index + 1) % found.length;
}

const kNoDrag = { move: () => true, end() {}, cancel() {} };

/** Moves all selected circles. */
class Move {
  readonly x: number;
  readonly y: number;
  readonly change: OpenChange;

  constructor(
    readonly app: App,
    start: Touch,
  ) {
    this.x = app.view.toWorldX(start.x);
    this.y = app.view.toWorldY(start.y);
    this.change = app.model.begin(app.selection.ids);
  }

  move(at: Touch) {
    const { app, change } = this;
    if (!change.isOpen) return false;
    const shift = [app.view.toWorldX(at.x) - this.x, app.view.toWorldY(at.y) - this.y, 0];
    change.to(change.before.map((v, k) => (k % 3 === 2 ? v : app.edits.rounded(v + shift[k % 3]))));
    return true;
  }

  end() {
    this.change.commit();
  }

  cancel() {
    this.change.cancel();
  }
}

/** Changes the radius of the selected circle. */
class Resize {
  readonly id: number;
  readonly dx: number;
  readonly change: OpenChange;

  constructor(
    readonly app: App,
    start: Touch,
  ) {
    this.id = app.selection.single;
    this.dx = handleOf(app.view, app.sites, this.id).x - start.x;
    this.change = app.model.begin([this.id]);
  }

  move(at: Touch) {
    const { app, change } = this;
    if (!change.isOpen) return false;
    const [x, y] = change.before;
    const distance = Math.hypot(
      at.x + this.dx - app.view.toScreenX(x),
      at.y - app.view.toScreenY(y),
    );
    const radius = radiusForHandle(app.view, distance);
    change.to(Float64Array.of(x, y, app.edits.rounded(radius)));
    return true;
  }

  end() {
    if (this.change.isOpen) this.app.edits.remember(this.id);
    this.change.commit();
  }

  cancel() {
    this.change.cancel();
  }
}

class ViewDrag {
  last: Touch;

  constructor(
    readonly app: App,
    start: Touch,
  ) {
    this.last = start;
  }

  move(at: Touch) {
    this.app.camera.pan(at.x - this.last.x, at.y - this.last.y);
    this.last = at;
    return true;
  }

  end() {}

  cancel() {}
}

/** Selects the circles whose centres are in a box, besides those that are selected. */
class BoxSelection {
  readonly before: readonly number[];

  constructor(
    readonly app: App,
    readonly start: Touch,
  ) {
    this.before = app.selection.ids;
  }

  move(at: Touch) {
    const { app, start } = this;
    const box = {
      left: Math.min(at.x, start.x),
      top: Math.min(at.y, start.y),
      right: Math.max(at.x, start.x),
      bottom: Math.max(at.y, start.y),
    };
    app.mark({ box });
    const before = this.before.filter((id) => app.diagram.has(id));
    app.selection.set([...before, ...centresIn(app, box)]);
    return true;
  }

  end() {}

  cancel() {
    this.app.selection.set(this.before.filter((id) => this.app.diagram.has(id)));
  }
}

function centresIn({ view, sites, painter }: App, box: Box) {
  const [left, right] = [view.toWorldX(box.left), view.toWorldX(box.right)];
  const [bottom, top] = [view.toWorldY(box.bottom), view.toWorldY(box.top)];
  const { xyr } = sites;
  return Array.from(sites.ids).filter((id) => {
    const [x, y] = [xyr[3 * id], xyr[3 * id + 1]];
    if (x < left || x > right || y < bottom || y > top) return false;
    return painter.layers.hidden || !sites.isHidden(id);
  });
}

export const selectTool: Tool = {
  id: "select",
  key: "v",
  label: "Select",
  icon: [["path", { d: "M5 3l13 9-6 1 3 6-2.5 1.200-3-6L5 18z" }]],
  help: {
    fine: [
      "*Click* selects, again what lies beneath; with Shift adds.",
      "*Double-click* inserts.",
      "*Drag* moves a circle, its handle resizes it; elsewhere moves the view, with Shift selects" +
        " by a box.",
    ],
    coarse: [
      "*Tap* selects, again what lies beneath.",
      "*Drag* moves a circle, its handle resizes it; elsewhere moves the view.",
      "*Hold* adds to the selection, *hold and drag* selects by a box.",
    ],
  },
  cursor: cursorOfSelect,
  gesture: (app: App, at: Touch): Gesture => new SelectGesture(app, at),
  doubleClick(app: App, x: number, y: number) {
    if (app.pointer.circlesAt(x, y, kReach.mouse).length === 0) app.edits.insertAt(x, y);
  },
};
