// Circles | Centres: lets the radii count less and less, or more and more, so that one sees what
// they do to the cells.
import type { App } from "../app.js";
import { signal } from "../model/signals.js";

const kTime = 800; // ms
const kMostMoving = 20_000; // circles

const eased = (t: number) => t * t * (3 - 2 * t);

export class Weights {
  #frame = 0;
  readonly #target = signal(1);

  constructor(readonly app: App) {}

  /** Where it is going. */
  get target() {
    return this.#target.value;
  }

  /** @param target 1 for circles, 0 for centres */
  go(target: number, { isAtOnce = false } = {}) {
    cancelAnimationFrame(this.#frame);
    this.#target.value = target;
    const { app } = this;
    const from = app.sites.weight;
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (isAtOnce || isStill || app.sites.size > kMostMoving) {
      app.model.weigh(target);
      return;
    }
    app.painter.isLive = true;
    const start = performance.now();
    const frame = (now: number) => {
      const t = Math.min(1, Math.max(0, now - start) / kTime);
      app.model.weigh(t === 1 ? target : from + (target - from) * eased(t));
      if (t < 1) {
        this.#frame = requestAnimationFrame(frame);
      } else {
        app.painter.isLive = false;
        app.painter.redraw();
      }
    };
    this.#frame = requestAnimationFrame(frame);
  }
}
