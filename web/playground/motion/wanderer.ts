// At first one circle of the opening set moves slowly, until the visitor does something: so one
// sees that the diagram is alive. It is no edit, and with reduced motion it does not happen.
import type { App } from "../app.js";
import { kWanderer } from "../sets/opening.js";

export function letWander(app: App) {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const { id, reach, period } = kWanderer;
  const { x, y, r } = app.sites.site(id);
  const start = performance.now();
  const change = app.model.begin([id]);
  let frame = 0;

  const step = (now: number) => {
    if (!change.isOpen) return;
    const angle = (2 * Math.PI * Math.max(0, now - start)) / period;
    const round = (value: number) => Math.round(value * 10) / 10;
    const at = [
      round(x + reach * Math.sin(angle)),
      round(y + reach * Math.sin(2 * angle) * 0.6),
      r,
    ];
    change.to(Float64Array.from(at));
    frame = requestAnimationFrame(step);
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
