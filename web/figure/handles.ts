// Handles of a figure, for readers to take hold of: buttons over the canvas, so that a finger that
// starts on one drags it and a finger that starts elsewhere scrolls the page, and the Tab key finds
// them.
import { make } from "../shared/dom.js";
import { arrowOf, placeIn } from "../shared/input.js";
import type { Handle } from "./figure.js";

const kLeast = 32; // CSS pixels across: what a finger hits
const kStep = 4; // CSS pixels that an arrow key moves by; five times as many with Shift

type Held = { button: HTMLButtonElement; handle: Handle };

export class Handles {
  readonly #held: Held[] = [];
  #scale = 1;

  constructor(
    readonly stage: HTMLElement,
    readonly changed: () => void,
  ) {}

  /** Puts the buttons where the handles are; the smallest is on top. */
  place(handles: readonly Handle[], scale: number) {
    this.#scale = scale;
    while (this.#held.length > handles.length) this.#held.pop()?.button.remove();
    for (const [k, handle] of handles.entries()) {
      if (k === this.#held.length) this.#held.push({ button: this.#newButton(k), handle });
      this.#held[k].handle = handle;
      const { button } = this.#held[k];
      const size = Math.max(kLeast, 2 * (handle.r ?? 0) * scale);
      button.ariaLabel = handle.label;
      button.style.width = button.style.height = `${size}px`;
      button.style.left = `${handle.x * scale - size / 2}px`;
      button.style.top = `${handle.y * scale - size / 2}px`;
      button.style.zIndex = String(Math.round(10_000 / (1 + (handle.r ?? 0))));
    }
  }

  #newButton(k: number) {
    const button = make("button", { type: "button", className: "handle" });
    let offset: [number, number] | null = null;
    const at = (event: PointerEvent) => {
      const [x, y] = placeIn(this.stage, event);
      return [x / this.#scale, y / this.#scale];
    };
    button.addEventListener("pointerdown", (event) => {
      const [x, y] = at(event);
      const { handle } = this.#held[k];
      offset = [handle.x - x, handle.y - y];
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener("pointermove", (event) => {
      if (!offset) return;
      const [x, y] = at(event);
      this.#held[k].handle.move(x + offset[0], y + offset[1]);
      this.changed();
    });
    for (const type of ["pointerup", "pointercancel"] as const)
      button.addEventListener(type, () => {
        offset = null;
      });
    button.addEventListener("keydown", (event) => {
      const step = ((event.shiftKey ? 5 : 1) * kStep) / this.#scale;
      const arrow = arrowOf(event.key);
      if (!arrow) return;
      event.preventDefault();
      const { handle } = this.#held[k];
      handle.move(handle.x + arrow[0] * step, handle.y + arrow[1] * step);
      this.changed();
    });
    this.stage.append(button);
    return button;
  }
}
