// Circles that move by themselves: one edit, from the start to the stop. Whatever else the visitor
// does ends it.
import type { App } from "../app.js";
import type { OpenChange } from "../model/model.js";
import { signal } from "../model/signals.js";
import { roundMoved } from "./rounding.js";

/** Gives x, y, r of the circles that move; it may be the same array each time. */
export type Step = (seconds: number) => Float64Array;

const kLongest = 1 / 20; // seconds: a slow frame is no reason to jump

export class Motion {
  readonly #change = signal<OpenChange | null>(null);
  #frame = 0;

  constructor(readonly app: App) {}

  get isRunning() {
    return this.#change.value?.isOpen ?? false;
  }

  start(ids: ArrayLike<number>, step: Step) {
    this.stop();
    const change = this.app.model.begin(ids, (open) => roundMoved(this.app, open));
    this.#change.value = change;
    this.app.painter.isLive = ids.length > 1;
    let last = performance.now();
    const frame = (now: number) => {
      if (!change.isOpen) {
        this.stop();
        return;
      }
      const seconds = Math.min(kLongest, Math.max(0, now - last) / 1000);
      last = now;
      change.to(step(seconds));
      this.#frame = requestAnimationFrame(frame);
    };
    this.#frame = requestAnimationFrame(frame);
  }

  stop() {
    const change = this.#change.peek();
    if (!change) return;
    cancelAnimationFrame(this.#frame);
    change.commit();
    this.app.painter.isLive = false;
    this.app.painter.redraw();
    this.#change.value = null;
  }
}
