// On a phone: one sheet at the bottom with two stops. A tap on its grip or a drag goes from one to
// the other. What is selected comes out from under the open sheet, and the picture goes back when
// the sheet closes, unless it has been moved meanwhile.
import type { App } from "../app.js";
import { whenever } from "../model/signals.js";
import { element } from "./elements.js";

const kDrag = 18; // pixels

export function makeSheet(app: App) {
  const sheet = element("sheet");
  const grip = element("grip");
  const open = (isOpen: boolean) => {
    sheet.classList.toggle("open", isOpen);
    grip.setAttribute("aria-expanded", String(isOpen));
    if (!isOpen) sheet.scrollTop = 0;
    if (!isOpen) giveBack();
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

  /** How far the picture was moved, in pixels, and how often it had moved then. */
  let lent = { x: 0, y: 0, looks: -1 };
  /** With the place that was touched. */
  const movedBy = (dx: number, dy: number) => {
    if (app.pointer.at) app.pointer.moveTo({ x: app.pointer.at.x + dx, y: app.pointer.at.y + dy });
  };
  function giveBack() {
    const { x, y, looks } = lent;
    lent = { x: 0, y: 0, looks: -1 };
    if (looks !== app.camera.looks || (x === 0 && y === 0)) return;
    app.camera.pan(-x, -y);
    movedBy(-x, -y);
  }
  new ResizeObserver(() => {
    if (!sheet.classList.contains("open") || app.selection.size === 0) return;
    const { originX, originY } = app.view;
    const before = lent.looks === app.camera.looks ? lent : { x: 0, y: 0 };
    app.camera.show(app.selection.last);
    const [dx, dy] = [app.view.originX - originX, app.view.originY - originY];
    if (dx === 0 && dy === 0) return;
    lent = { x: before.x + dx, y: before.y + dy, looks: app.camera.looks };
    movedBy(dx, dy);
  }).observe(sheet);
  whenever(
    () => app.selection.size,
    () => app.selection.size === 0 && giveBack(),
  );
}
