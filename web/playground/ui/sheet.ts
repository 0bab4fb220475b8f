// On a phone: one sheet at the bottom with two stops. A tap on its grip or a drag goes from one to
// the other. What is selected stays in sight.
import type { App } from "../app.js";
import { element } from "./elements.js";

const kDrag = 18; // pixels

export function makeSheet(app: App) {
  const sheet = element("sheet");
  const grip = element("grip");
  const open = (isOpen: boolean) => {
    sheet.classList.toggle("open", isOpen);
    grip.setAttribute("aria-expanded", String(isOpen));
    if (!isOpen) sheet.scrollTop = 0;
  };
  let from = 0;
  let wasDragged = false;
  grip.addEventListener("pointerdown", (event) => {
    from = event.clientY;
    wasDragged = false;
    grip.setPointerCapture(event.pointerId);
  });
  grip.addEventListener("pointermove", (event) => {
    if (!grip.hasPointerCapture(event.pointerId) || Math.abs(event.clientY - from) < kDrag) return;
    wasDragged = true;
    open(event.clientY < from);
  });
  grip.addEventListener("click", () => {
    if (!wasDragged) open(!sheet.classList.contains("open"));
    wasDragged = false;
  });
  element("answer").addEventListener("click", () => open(true));
  // From under the open sheet, and the place that was touched with it.
  new ResizeObserver(() => {
    if (!sheet.classList.contains("open") || app.selection.size === 0) return;
    const { originX, originY } = app.view;
    app.show(app.selection.last);
    const [dx, dy] = [app.view.originX - originX, app.view.originY - originY];
    if (app.pointer) app.hoverAt({ x: app.pointer.x + dx, y: app.pointer.y + dy });
  }).observe(sheet);
}
