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
  #change: OpenChange | null = null;
  #frame = 0;
  #ended = () => {};
  readonly #name = signal("");

  constructor(readonly app: App) {}

  get isRunning() {
    return this.#change?.isOpen ?? false;
  }

  /** What runs until somebody stops it, as a button says it: "drift"; "" if nothing does. */
  get name() {
    return this.#name.value;
  }

  /** @param name of what does not end by itself, and so comes to rest anywhere */
  start(ids: ArrayLike<number>, step: Step, ended: () => void = () => {}, name = "") {
    this.stop();
    this.#name.value = name;
    const settle = name === "" ? undefined : (open: OpenChange) => roundMoved(this.app, open);
    const change = this.app.model.begin(ids, settle);
    this.#change = change;
    this.#ended = ended;
    this.app.painter.isLive = ids.length > 1;
    let last = performance.now();
    const frame = (now: number) => {
      if (!this.isRunning) {
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
    if (!this.#change) return;
    cancelAnimationFrame(this.#frame);
    const change = this.#change;
    this.#change = null;
    change.commit();
    this.app.painter.isLive = false;
    this.app.painter.redraw();
    this.#name.value = "";
    this.#ended();
  }
}
