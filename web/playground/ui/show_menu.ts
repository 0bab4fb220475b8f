// The menu of what is shown and answered, and of motion.
import type { App } from "../app.js";
import type { Questions } from "../pointer.js";
import { effect } from "../model/signals.js";
import { drift } from "../motion/drift.js";
import type { Motion } from "../motion/motion.js";
import { isLayer } from "../picture/picture.js";
import { element } from "./elements.js";
import { notify } from "./notice.js";

const kMostMoving = 20_000; // circles

/** The box of a name in a list of them. */
function boxIn(list: HTMLElement, name: string): HTMLInputElement {
  const found = list.querySelector(`[name=${name}]`);
  if (!(found instanceof HTMLInputElement)) throw new Error(`the page has no box named ${name}`);
  return found;
}

export function makeShowMenu(app: App, motion: Motion) {
  const layers = element("layers");
  layers.addEventListener("change", ({ target }) => {
    if (!(target instanceof HTMLInputElement) || !isLayer(app.painter.layers, target.name)) return;
    app.setLayer(target.name, target.checked);
  });
  const questions = element("questions");
  questions.addEventListener("change", () => {
    const isAsked = (name: keyof Questions) => boxIn(questions, name).checked;
    app.pointer.ask({
      neighbors: isAsked("neighbors"),
      under: isAsked("under"),
      empty: isAsked("empty"),
      nearest: isAsked("nearest") ? element("nearest-count").valueAsNumber || 0 : 0,
    });
  });
  effect(() => {
    for (const [name, isShown] of Object.entries(app.painter.layers))
      boxIn(layers, name).checked = isShown;
  });

  effect(() => {
    element("stop-motion").hidden = !motion.isRunning;
    element("drift").setAttribute("aria-pressed", String(motion.isRunning));
  });
  const stop = () => motion.stop();
  element("stop-motion").addEventListener("click", stop);
  element("overlay").addEventListener("click", stop);
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || !motion.isRunning || event.defaultPrevented) return;
    event.preventDefault(); // one thing after another: the selection stays
    motion.stop();
  };
  document.addEventListener("keydown", onKey, { capture: true });
  element("drift").addEventListener("click", () => {
    const { sites } = app;
    if (motion.isRunning) motion.stop();
    else if (sites.size === 0 || sites.size > kMostMoving)
      notify(`This moves up to ${kMostMoving.toLocaleString("en")} circles.`);
    else {
      motion.start(sites.ids, drift(sites));
      element("show").hidePopover();
    }
  });
}
