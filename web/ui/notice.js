// One line that says what went wrong, or that something was done; it goes away by itself.
import { element } from "./dom.js";

const kShown = 6000; // ms

let hiding = 0;

/** @param {string} text @param {{ stays?: boolean }} [options] */
export function notify(text, { stays = false } = {}) {
  const notice = element("notice");
  notice.textContent = text;
  notice.hidden = false;
  clearTimeout(hiding);
  if (!stays) hiding = setTimeout(() => (notice.hidden = true), kShown);
}

/** For the catch of what may fail: says what did and leaves the rest alive. */
export const sayWhatFailed = (what) => (/** @type {any} */ error) => {
  if (error?.name === "AbortError") return;
  notify(`${what}: ${error?.message ?? error}`);
};
