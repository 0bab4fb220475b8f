// At first one circle of the opening set goes its way once and comes home, unless the visitor does
// something before: so one sees that the diagram is alive. It is no edit. With reduced motion it
// does not happen.
import { isDue } from "../../shared/pace.js";
import type { App } from "../app.js";
import { kWanderer } from "../sets/opening.js";

/** Slow at first and at last. */
const eased = (t: number) => t * t * (3 - 2 * t);
const rounded = (value: number) => Math.round(value * 10) / 10;

export function letWander(app: App) {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const { id, reach, time } = kWanderer;
  const { x, y, r } = app.sites.site(id);
  const change = app.model.begin([id]);
  let start = -1;
  let last = -Infinity;
  let frame = 0;

  const step = (now: number) => {
    if (!change.isOpen) return;
    if (start < 0) start = now;
    if (now - start >= time) {
      change.cancel();
      stop();
      return;
    }
    frame = requestAnimationFrame(step);
    if (!isDue(now, last)) return;
    last = now;
    const angle = 2 * Math.PI * eased((now - start) / time);
    const at = [x + reach * Math.sin(angle), y + reach * Math.sin(2 * angle) * 0.6].map(rounded);
    change.to(Float64Array.of(...at, r));
  };
  const stop = () => {
    cancelAnimationFrame(frame);
    change.leave();
    for (const type of kActs) removeEventListener(type, stop, true);
  };
  for (const type of kActs) addEventListener(type, stop, true);
  frame = requestAnimationFrame(step);
}

const kActs = ["pointerdown", "keydown", "wheel", "popstate"];
