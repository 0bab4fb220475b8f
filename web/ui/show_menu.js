// The menu of what is shown and answered, of motion, and of the steps of the algorithm.
import { drift } from "../motion/drift.js";
import { relax } from "../motion/relax.js";
import { element } from "./dom.js";
import { notify } from "./notice.js";

const kMostMoving = { drift: 20_000, relax: 5000 }; // circles
const kRateTime = 500; // ms over which frames are counted

/**
 * @param {import("../app.js").App} app
 * @param {import("../motion/motion.js").Motion} motion
 */
export function makeShowMenu(app, motion) {
  const layers = element("layers");
  layers.addEventListener("change", ({ target }) => app.setLayer(target.name, target.checked));
  const questions = element("questions");
  questions.addEventListener("change", () => {
    const isAsked = (name) => questions.querySelector(`[name=${name}]`).checked;
    app.ask({
      neighbors: isAsked("neighbors"),
      under: isAsked("under"),
      empty: isAsked("empty"),
      nearest: isAsked("nearest") ? element("nearest-count").valueAsNumber || 0 : 0,
    });
  });
  app.addEventListener("layers", () => {
    for (const [name, isShown] of Object.entries(app.painter.layers))
      layers.querySelector(`[name=${name}]`).checked = isShown;
  });

  let isMoving = false;
  const stop = () => isMoving && motion.stop();
  element("stop-motion").addEventListener("click", stop);
  element("overlay").addEventListener("click", stop);
  const onKey = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Escape" || !isMoving) return;
    event.preventDefault(); // one thing after another: the selection stays
    motion.stop();
  };
  document.addEventListener("keydown", onKey, { capture: true });
  const showMotion = (/** @type {boolean} */ isShown) => {
    isMoving = isShown;
    element("stop-motion").hidden = !isShown;
  };

  for (const [name, make] of /** @type {const} */ ([
    ["drift", drift],
    ["relax", relax],
  ])) {
    const button = element(name);
    const press = (isPressed) => button.setAttribute("aria-pressed", String(isPressed));
    button.addEventListener("click", () => {
      const wasPressed = button.getAttribute("aria-pressed") === "true";
      motion.stop();
      if (wasPressed) return;
      const { sites } = app;
      if (sites.size === 0 || sites.size > kMostMoving[name]) {
        notify(`This moves up to ${kMostMoving[name].toLocaleString("en")} circles.`);
        return;
      }
      motion.start(sites.ids, make(sites), () => {
        press(false);
        showMotion(false);
      });
      press(true);
      showMotion(true);
      element("show").hidePopover();
    });
  }
  element("show-rate").addEventListener("change", ({ target }) => showRate(target.checked));
}

let rateFrame = 0;

/** Frames a second. */
function showRate(isShown) {
  const rate = element("rate");
  rate.hidden = !isShown;
  cancelAnimationFrame(rateFrame);
  if (!isShown) return;
  let frames = 0;
  let since = performance.now();
  const frame = (now) => {
    frames++;
    if (now - since >= kRateTime) {
      rate.textContent = `${Math.round((1000 * frames) / (now - since))} frames/s`;
      frames = 0;
      since = now;
    }
    rateFrame = requestAnimationFrame(frame);
  };
  rateFrame = requestAnimationFrame(frame);
}
