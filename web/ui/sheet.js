// On a phone: one sheet at the bottom with two stops. A tap on its grip or a drag goes from one to
// the other.
import { element } from "./dom.js";

const kDrag = 18; // pixels

export function makeSheet() {
  const sheet = element("sheet");
  const grip = element("grip");
  const open = (isOpen) => {
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
}
