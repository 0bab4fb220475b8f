// Mouse, pen and touch on the canvas. Every gesture means one thing, decided where and how it
// starts:
//   - click or tap on a circle selects it, with Shift deletes it; elsewhere it inserts one (Alt or
//     Ctrl: also upon a circle)
//   - drag a circle moves it, drag the selected circle's handle resizes it; drag elsewhere moves
//     the view
//   - drag with Alt or Ctrl draws a circle from its centre; two fingers move and zoom the view
//   - wheel over the selected circle or its handle resizes it; elsewhere it zooms (with Ctrl, as a
//     pinch does, always)
import { handleOf, radiusForHandle } from "./overlay_layer.js";

const kSlop = 4; // pixels that a click may move
// pixels around a point or a small circle that count as hit
const kReach = { mouse: 5, pen: 8, touch: 14 };
const kHandleReach = { mouse: 9, pen: 12, touch: 24 };
const kWheelPause = 250; // ms without wheel events: a new gesture

/** @param {HTMLElement} element @param {import("./app.js").App} app */
export function listenToPointer(element, app) {
  /** Pointers that are down, by id. @type {Map<number, { x: number, y: number }>} */
  const down = new Map();
  /**
   * What the pointers that are down do: a pinch has `last`, all others have the rest.
   * @type {null | {
   *   kind: "pan" | "draw" | "resize" | "move" | "pinch", moved: boolean,
   *   startX?: number, startY?: number, lastX?: number, lastY?: number,
   *   id?: number, dx?: number, dy?: number, event?: PointerEvent,
   *   last?: null | { x: number, y: number, size: number },
   * }}
   */
  let gesture = null;

  const position = (event) => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  const onHandle = (x, y, type) => {
    if (app.selected < 0) return false;
    const handle = handleOf(app.view, app.scene.site(app.selected));
    const distance = Math.hypot(x - handle.x, y - handle.y);
    const fromCentre = Math.hypot(x - handle.x + handle.radius, y - handle.y);
    // a small circle can still be moved
    return distance <= (kHandleReach[type] ?? 9) && distance < fromCentre;
  };

  /** What a gesture that starts here will do if it becomes a drag. */
  function begin(event, { x, y }) {
    const type = event.pointerType;
    const id = app.pick(x, y, kReach[type] ?? 5);
    const draws = event.altKey || event.ctrlKey || event.metaKey;
    /** @type {"pan" | "draw" | "resize" | "move"} */
    let kind = "pan";
    if (draws) kind = "draw";
    else if (onHandle(x, y, type)) kind = "resize";
    else if (id >= 0 && !event.shiftKey) kind = "move";
    let dx = 0;
    let dy = 0;
    if (kind === "move") {
      dx = app.view.toScreenX(app.scene.site(id).x) - x;
      dy = app.view.toScreenY(app.scene.site(id).y) - y;
    } else if (kind === "resize") {
      const handle = handleOf(app.view, app.scene.site(app.selected));
      dx = handle.x - x;
    }
    return { kind, startX: x, startY: y, moved: false, id, dx, dy, event };
  }

  function drag(x, y) {
    const { view, scene } = app;
    if (gesture.kind === "pan") {
      app.pan(x - gesture.lastX, y - gesture.lastY);
    } else if (gesture.kind === "move") {
      app.select(gesture.id);
      app.move(gesture.id, view.toWorldX(x + gesture.dx), view.toWorldY(y + gesture.dy));
    } else if (gesture.kind === "resize") {
      const site = scene.site(app.selected);
      const distance = Math.hypot(
        x + gesture.dx - view.toScreenX(site.x),
        y - view.toScreenY(site.y),
      );
      app.resize(app.selected, radiusForHandle(view, distance));
    } else if (gesture.kind === "draw") {
      app.painter.draft = draftTo(x, y);
      app.painter.redrawOverlay();
    }
  }

  const draftTo = (x, y) => ({
    x: app.view.toWorldX(gesture.startX),
    y: app.view.toWorldY(gesture.startY),
    r: Math.hypot(x - gesture.startX, y - gesture.startY) / app.view.scale,
  });

  function click() {
    const { id, startX, startY, kind, event } = gesture;
    if (event.shiftKey) {
      if (id >= 0) app.remove(id);
    } else if (kind === "draw") {
      app.insertAt(startX, startY);
    } else if (id >= 0) {
      app.select(id);
    } else if (kind !== "resize") {
      app.insertAt(startX, startY);
    }
  }

  function pinch() {
    const [a, b] = [...down.values()];
    const now = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, size: Math.hypot(a.x - b.x, a.y - b.y) };
    if (gesture.last) {
      app.view.pan(now.x - gesture.last.x, now.y - gesture.last.y);
      app.zoom(now.size / Math.max(gesture.last.size, 1), now.x, now.y);
    }
    gesture.last = now;
  }

  function showCursor(x, y, event) {
    const busy =
      gesture?.moved &&
      { pan: "grabbing", move: "grabbing", resize: "ew-resize", draw: "crosshair" }[gesture.kind];
    let cursor = "crosshair";
    if (onHandle(x, y, event.pointerType)) cursor = "ew-resize";
    else if (app.pick(x, y, kReach[event.pointerType] ?? 5) >= 0)
      cursor = event.shiftKey ? "not-allowed" : "grab";
    element.style.cursor = busy || cursor;
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    const at = position(event);
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, at);
    if (down.size === 1) {
      gesture = begin(event, at);
      gesture.lastX = at.x;
      gesture.lastY = at.y;
      app.hoverAt(at);
    } else if (down.size === 2) {
      app.painter.draft = null;
      gesture = { kind: "pinch", last: null, moved: true };
    }
  });

  element.addEventListener("mousedown", (event) => {
    if (!event.shiftKey) return;
    event.preventDefault(); // it would select text
    element.focus();
  });

  element.addEventListener("pointermove", (event) => {
    const at = position(event);
    if (down.has(event.pointerId)) down.set(event.pointerId, at);
    if (gesture?.kind === "pinch") {
      if (down.size === 2) pinch();
      return;
    }
    if (gesture && down.has(event.pointerId)) {
      if (!gesture.moved && Math.hypot(at.x - gesture.startX, at.y - gesture.startY) > kSlop)
        gesture.moved = true;
      app.pointer = at;
      if (gesture.moved) {
        drag(at.x, at.y);
        gesture.lastX = at.x;
        gesture.lastY = at.y;
      }
      if (!gesture.moved || gesture.kind === "draw") app.refreshHover();
    } else {
      app.hoverAt(at);
    }
    showCursor(at.x, at.y, event);
  });

  const end = (event) => {
    if (!down.delete(event.pointerId) || !gesture) return;
    if (gesture.kind === "pinch") {
      if (down.size === 0) gesture = null;
      return;
    }
    const at = position(event);
    const cancelled = event.type === "pointercancel";
    if (!cancelled && !gesture.moved) click();
    else if (!cancelled && gesture.kind === "draw")
      app.insertAt(gesture.startX, gesture.startY, draftTo(at.x, at.y).r);
    app.painter.draft = null;
    app.painter.redrawOverlay();
    gesture = null;
    if (event.pointerType === "touch") app.hoverAt(at);
  };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
  element.addEventListener("pointerleave", (event) => {
    if (!gesture && event.pointerType !== "touch") app.hoverAt(null);
  });
  element.addEventListener("contextmenu", (event) => {
    if (event.ctrlKey) event.preventDefault(); // Ctrl-click inserts
  });

  const wheel = { time: -Infinity, resizes: false };
  element.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const { x, y } = position(event);
      const now = performance.now();
      if (now - wheel.time > kWheelPause) wheel.resizes = !event.ctrlKey && overSelected(x, y);
      wheel.time = now;
      const unit = event.deltaMode === 1 ? 18 : event.deltaMode === 2 ? 300 : 1;
      const delta = Math.max(-240, Math.min(240, event.deltaY * unit));
      if (wheel.resizes && app.selected >= 0) {
        const { r } = app.scene.site(app.selected);
        app.resize(app.selected, Math.max(r, 1 / app.view.scale) * Math.exp(-delta * 0.001));
      } else {
        app.zoom(Math.exp(-delta * (event.ctrlKey ? 0.01 : 0.0016)), x, y);
      }
    },
    { passive: false },
  );

  function overSelected(x, y) {
    if (app.selected < 0) return false;
    const { radius } = handleOf(app.view, app.scene.site(app.selected));
    const { x: cx, y: cy } = app.scene.site(app.selected);
    const inside = Math.hypot(x - app.view.toScreenX(cx), y - app.view.toScreenY(cy)) <= radius;
    return inside || onHandle(x, y, "mouse");
  }
}
