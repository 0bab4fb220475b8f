// Circles | Centres: lets the radii count less and less, or more and more, so that one sees what
// they do to the cells.

const kTime = 800; // ms
const kMostMoving = 20_000; // circles

const eased = (t) => t * t * (3 - 2 * t);

/** Events: "target". */
export class Weights extends EventTarget {
  #frame = 0;
  /** Where it is going. */
  target = 1;

  /** @param {import("../app.js").App} app */
  constructor(app) {
    super();
    this.app = app;
  }

  /** @param {number} target 1 for circles, 0 for centres */
  go(target, { isAtOnce = false } = {}) {
    cancelAnimationFrame(this.#frame);
    this.target = target;
    this.dispatchEvent(new Event("target"));
    const { app } = this;
    const from = app.sites.weight;
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (isAtOnce || isStill || app.sites.size > kMostMoving) {
      app.model.weigh(target);
      return;
    }
    app.painter.isLive = true;
    const start = performance.now();
    const frame = (now) => {
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
