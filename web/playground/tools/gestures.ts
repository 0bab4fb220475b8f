// Mouse, pen and touch on the canvas. The first pointer that goes down begins a gesture of the
// current tool, which gets all its movements until it ends or is cancelled; a second finger makes
// it a pinch, which moves and zooms the view. The middle button and the space bar pan with any
// tool; the wheel zooms.
import { placeIn } from "../../shared/input.js";
import type { App } from "../app.js";
import { whenever } from "../model/signals.js";
import { drawTool } from "./draw_tool.js";
import { panTool } from "./pan_tool.js";
import { toolOf } from "./registry.js";
import type { Gesture, PointerKind, Touch } from "./tool.js";

/** A pointer that a browser does not name is like a mouse. */
const kindOf = (type: string): PointerKind => (type === "pen" || type === "touch" ? type : "mouse");

const kSlop = { mouse: 4, pen: 6, touch: 10 }; // pixels that a click may move
const kHold = 500; // ms

export function listenToPointer(element: HTMLElement, app: App) {
  /** Pointers that are down, by id. */
  const down = new Map<number, Touch>();
  let gesture: Gesture | null = null;
  let start: Touch | null = null; // until the pointer has moved
  let pinch: { x: number; y: number; size: number } | null = null;
  let holding = 0;
  let isSpaceDown = false;

  const touchOf = (event: PointerEvent): Touch => {
    const [x, y] = placeIn(element, event);
    return {
      x,
      y,
      type: kindOf(event.pointerType),
      shiftKey: event.shiftKey,
      altKey: event.altKey || event.ctrlKey || event.metaKey,
      time: event.timeStamp,
    };
  };

  function begin(at: Touch, button: number): Gesture {
    if (button === 1 || isSpaceDown) return panTool.gesture(app, at);
    const tool = toolOf(app.tool);
    // Where there is nothing to select, the first drag draws: the invitation says so.
    if (app.tool === "select" && app.sites.size === 0) return drawTool.gesture(app, at);
    return (at.altKey && !tool.ignoresAlt ? drawTool : tool).gesture(app, at);
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
      app.camera.zoom(now.size / Math.max(pinch.size, 1), now.x, now.y);
    }
    pinch = now;
  }

  function showCursor(at: Touch) {
    const idle = isSpaceDown ? panTool : toolOf(app.tool);
    element.style.cursor = gesture?.cursor ?? idle.cursor(app, at);
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
    app.pointer.moveTo({ x: at.x, y: at.y });
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
      app.pointer.moveTo({ x: at.x, y: at.y });
      toolOf(app.tool).hover?.(app, at);
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
    app.pointer.at = { x: at.x, y: at.y };
    if (start) app.pointer.refresh();
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
    if (event.pointerType === "touch") app.pointer.moveTo({ x: at.x, y: at.y });
    showCursor(at);
  };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
  element.addEventListener("pointerleave", (event) => {
    if (gesture || event.pointerType === "touch") return;
    app.mark({ draft: null });
    app.pointer.moveTo(null);
  });
  element.addEventListener("dblclick", (event) => {
    toolOf(app.tool).doubleClick?.(app, ...placeIn(element, event));
  });
  element.addEventListener("contextmenu", (event) => {
    // A long touch, and Ctrl-click on a Mac, mean something here.
    if (event.ctrlKey || gesture) event.preventDefault();
  });

  const changeTool = () => {
    cancel();
    app.mark({ draft: null });
    element.style.cursor = "";
  };
  whenever(() => app.tool, changeTool);
  app.model.on("change", ({ isSet }) => {
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
      const unit = event.deltaMode === 1 ? 18 : event.deltaMode === 2 ? 300 : 1;
      const delta = Math.max(-240, Math.min(240, event.deltaY * unit));
      const factor = Math.exp(-delta * (event.ctrlKey ? 0.01 : 0.0016));
      app.camera.zoom(factor, ...placeIn(element, event));
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
