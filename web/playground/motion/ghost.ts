// In the state Centres a pointer that nobody holds goes back and forth between a place where the
// nearest centre is the wrong pick and one where it is the right one, as long as nobody acts. With
// reduced motion it does not.
import type { App, Point } from "../app.js";
import { whenever } from "../model/signals.js";
import type { Verdict } from "../model/verdict.js";

const kPatience = 1500; // ms in which nobody has acted
const kPeriod = 5000; // ms there and back
const kDwell = 0.3; // the share of it that the pointer rests at each end
const kActs = ["pointerdown", "pointermove", "keydown", "wheel", "popstate"];

const eased = (t: number) => t * t * (3 - 2 * t);

/** How much of the way it has gone: from 0 to 1, and back. */
function wayAt(time: number) {
  const t = (time / kPeriod) % 1;
  const half = t < 0.5 ? t : 1 - t;
  const going = 0.5 - kDwell;
  return eased(Math.max(0, Math.min(1, (half - kDwell / 2) / going)));
}

export function letGhostPoint(app: App, verdict: { value: Verdict | null }) {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  let waiting = 0;
  let frame = 0;
  let real: Point | null = null; // where the visitor's own pointer was

  const stop = () => {
    clearTimeout(waiting);
    if (frame === 0) return;
    cancelAnimationFrame(frame);
    frame = 0;
    app.mark({ ghost: null });
    app.hoverAt(real);
  };
  const start = () => {
    const { wrong, right } = verdict.value ?? {};
    if (!wrong || !right || document.querySelector(":popover-open, dialog[open]")) return;
    real = app.pointer;
    const begin = performance.now();
    const step = (now: number) => {
      const t = wayAt(Math.max(0, now - begin));
      const at = { x: wrong.x + (right.x - wrong.x) * t, y: wrong.y + (right.y - wrong.y) * t };
      app.mark({ ghost: at });
      app.hoverAt(at);
      frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
  };
  const wait = () => {
    stop();
    if (verdict.value?.wrong) waiting = setTimeout(start, kPatience);
  };
  for (const type of kActs) addEventListener(type, wait, { capture: true, passive: true });
  whenever(() => verdict.value, wait);
}
