// Circles | Centres: lets the radii count less and less, or more and more, so that one sees what
// they do to the cells.
import type { App } from "../app.js";
import { Emitter } from "../model/emitter.js";

const kTime = 800; // ms
const kMostMoving = 20_000; // circles

const eased = (t: number) => t * t * (3 - 2 * t);

/** "target": it goes somewhere else. */
export class Weights extends Emitter<{ target: undefined }> {
  #frame = 0;
  /** Where it is going. */
  target = 1;

  constructor(readonly app: App) {
    super();
  }

  /** @param target 1 for circles, 0 for centres */
  go(target: number, { isAtOnce = false } = {}) {
    cancelAnimationFrame(this.#frame);
    this.target = target;
    this.emit("target");
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
