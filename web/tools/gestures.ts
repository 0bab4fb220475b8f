// Mouse, pen and touch on the canvas. The first pointer that goes down begins a gesture of the
// current tool, which gets all its movements until it ends or is cancelled; a second finger makes
// it a pinch, which moves and zooms the view. The middle button and the space bar pan with any
// tool; the wheel zooms.
import type { App } from "../app.js";
import { DeleteGesture } from "./delete_tool.js";
import { DrawGesture } from "./draw_tool.js";
import { PanGesture } from "./pan_tool.js";
import { cursorOfSelect, isOnHandle, SelectGesture } from "./select_tool.js";

export type PointerKind = "mouse" | "pen" | "touch";
/** Where the pointer is, in pixels. */
export type Touch = {
  x: number;
  y: number;
  type: PointerKind;
  shiftKey: boolean;
  altKey: boolean;
  time: number;
};
/** `move` comes once the pointer has left where it went down; `hold` if it stays there. */
export type Gesture = {
  cursor: string;
  move(at: Touch): void;
  end(at: Touch): void;
  cancel(): void;
  hold?(at: Touch): void;
};

/** What a browser does not name is like a mouse. */
const kindOf = (type: string): PointerKind => (type === "pen" || type === "touch" ? type : "mouse");

const kSlop = { mouse: 4, pen: 6, touch: 10 }; // pixels that a click may move
const kHold = 500; // ms
/** Pixels around a point or a small circle that count as hit. */
export const kReach = { mouse: 5, pen: 8, touch: 16 };

export function listenToPointer(element: HTMLElement, app: App) {
  /** Pointers that are down, by id. */
  const down = new Map<number, Touch>();
  let gesture: Gesture | null = null;
  let start: Touch | null = null; // until the pointer has moved
  let pinch: { x: number; y: number; size: number } | null = null;
  let holding = 0;
  let isSpaceDown = false;

  const touchOf = (event: PointerEvent): Touch => {
    const box = element.getBoundingClientRect();
    return {
      x: event.clientX - box.left,
      y: event.clientY - box.top,
      type: kindOf(event.pointerType),
      shiftKey: event.shiftKey,
      altKey: event.altKey || event.ctrlKey || event.metaKey,
      time: event.timeStamp,
    };
  };

  function begin(at: Touch, button: number): Gesture {
    if (button === 1 || isSpaceDown || app.tool === "pan") return new PanGesture(app, at);
    const draws = app.tool === "draw" && !isOnHandle(app, at); // which resizes what was drawn
    if (draws || at.altKey) return new DrawGesture(app, at);
    if (app.tool === "delete") return new DeleteGesture(app, at);
    return new SelectGesture(app, at);
  }

  function cancel() {
    clearTimeout(holding);
    gesture?.cancel();
    gesture = null;
    start = null;
    pinch = null;
  }

  /** Two fingers. */
  function movePinch() {
    const [a, b] = [...down.values()];
    const now = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, size: Math.hypot(a.x - b.x, a.y - b.y) };
    if (pinch) {
      app.view.pan(now.x - pinch.x, now.y - pinch.y);
      app.zoom(now.size / Math.max(pinch.size, 1), now.x, now.y);
    }
    pinch = now;
  }

  function showCursor(at: Touch) {
    element.style.cursor =
      gesture?.cursor ??
      (isSpaceDown || app.tool === "pan" ? "grab" : null) ??
      (app.tool === "select" ? cursorOfSelect(app, at) : null) ??
      (app.tool === "draw" && isOnHandle(app, at) ? "ew-resize" : null) ??
      (app.tool === "delete" && app.at(at.x, at.y, kReach.mouse).length > 0
        ? "pointer"
        : "crosshair");
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.button > 1) return;
    if (event.button === 1) event.preventDefault();
    const at = touchOf(event);
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, at);
    if (down.size > 1) {
      cancel();
      return;
    }
    app.hoverAt({ x: at.x, y: at.y });
    start = at;
    gesture = begin(at, event.button);
    showCursor(at);
    holding = setTimeout(() => gesture && start && gesture.hold?.(start), kHold);
  });

  element.addEventListener("mousedown", (event) => {
    if (!event.shiftKey && event.button !== 1) return;
    event.preventDefault(); // it would select text, or scroll
    element.focus();
  });

  element.addEventListener("pointermove", (event) => {
    const at = touchOf(event);
    if (!down.has(event.pointerId)) {
      app.hoverAt({ x: at.x, y: at.y });
      if (app.tool === "draw")
        app.mark({ draft: isOnHandle(app, at) ? null : app.draftAt(at.x, at.y) });
      showCursor(at);
      return;
    }
    down.set(event.pointerId, at);
    if (down.size === 2) movePinch();
    if (down.size > 1 || !gesture) return;
    if (start && Math.hypot(at.x - start.x, at.y - start.y) > kSlop[at.type]) {
      start = null;
      clearTimeout(holding);
    }
    app.pointer = { x: at.x, y: at.y };
    if (start) app.refreshHover();
    else gesture.move(at);
    showCursor(at);
  });

  const end = (event: PointerEvent) => {
    if (!down.delete(event.pointerId)) return;
    pinch = null;
    clearTimeout(holding);
    if (!gesture) return;
    const at = touchOf(event);
    const ended = gesture;
    gesture = null;
    start = null;
    if (event.type === "pointercancel") ended.cancel();
    else ended.end(at);
    if (event.pointerType === "touch") app.hoverAt({ x: at.x, y: at.y });
    showCursor(at);
  };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
  element.addEventListener("pointerleave", (event) => {
    if (gesture || event.pointerType === "touch") return;
    app.mark({ draft: null });
    app.hoverAt(null);
  });
  element.addEventListener("dblclick", (event) => {
    if (app.tool !== "select") return;
    const box = element.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    if (app.at(x, y, kReach.mouse).length === 0) app.insertAt(x, y);
  });
  element.addEventListener("contextmenu", (event) => {
    // A long touch, and Ctrl-click on a Mac, mean something here.
    if (event.ctrlKey || gesture) event.preventDefault();
  });

  app.on("tool", () => {
    cancel();
    app.mark({ draft: null });
    element.style.cursor = "";
  });
  app.on("change", ({ isSet }) => {
    if (isSet) cancel();
  });

  element.addEventListener("keydown", (event) => {
    if (event.key === " ") {
      isSpaceDown = true;
      event.preventDefault();
    }
  });
  addEventListener("keyup", (event) => {
    if (event.key === " ") isSpaceDown = false;
  });
  addEventListener("blur", () => {
    isSpaceDown = false;
  });

  element.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const box = element.getBoundingClientRect();
      const unit = event.deltaMode === 1 ? 18 : event.deltaMode === 2 ? 300 : 1;
      const delta = Math.max(-240, Math.min(240, event.deltaY * unit));
      const factor = Math.exp(-delta * (event.ctrlKey ? 0.01 : 0.0016));
      app.zoom(factor, event.clientX - box.left, event.clientY - box.top);
    },
    { passive: false },
  );

  return {
    /** Whether there was a gesture to give up. */
    cancel() {
      const had = gesture !== null;
      cancel();
      return had;
    },
  };
}
