// One line that says what went wrong, or that something was done; it goes away by itself.
import { messageOf } from "../../shared/errors.js";
import { element } from "./elements.js";

const kShown = 6000; // ms

let hiding = 0;

export function notify(text: string) {
  const notice = element("notice");
  notice.textContent = text;
  notice.hidden = false;
  clearTimeout(hiding);
  hiding = setTimeout(() => (notice.hidden = true), kShown);
}

/** Hides the notice: it no longer holds. */
export function silence() {
  clearTimeout(hiding);
  element("notice").hidden = true;
}

/** For the catch of what may fail: says what did and leaves the rest alive. */
export const sayWhatFailed = (what: string) => (error: unknown) => {
  if (error instanceof DOMException && error.name === "AbortError") return;
  notify(`${what}: ${messageOf(error)}`);
};
