// Circles that move by themselves: one edit, from the start to the stop. Whatever else the visitor
// does ends it.

/**
 * @typedef {(seconds: number) => Float64Array} Step x, y, r of the circles that move; it may be the
 * same array each time
 */

const kLongest = 1 / 20; // seconds: a slow frame is no reason to jump

export class Motion {
  /** @type {ReturnType<import("../model/model.js").Model["begin"]> | null} */ #change = null;
  #frame = 0;
  #ended = () => {};

  /** @param {import("../app.js").App} app */
  constructor(app) {
    this.app = app;
  }

  get isRunning() {
    return this.#change?.isOpen ?? false;
  }

  /**
   * @param {ArrayLike<number>} ids @param {Step} step @param {() => void} ended
   */
  start(ids, step, ended = () => {}) {
    this.stop();
    this.#change = this.app.model.begin(ids);
    this.#ended = ended;
    this.app.painter.isLive = ids.length > 1;
    let last = performance.now();
    const frame = (now) => {
      if (!this.isRunning) {
        this.stop();
        return;
      }
      const seconds = Math.min(kLongest, Math.max(0, now - last) / 1000);
      last = now;
      this.#change.to(step(seconds));
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
    this.#ended();
  }
}
