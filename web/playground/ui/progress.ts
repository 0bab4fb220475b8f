// How far a long building is, and the way to stop it.
import type { Watch } from "../sets/building.js";
import { element } from "./elements.js";

/** Runs something that takes long, with its progress shown once there is any. */
export async function withProgress<T>(run: (watch: Watch) => Promise<T>): Promise<T> {
  latest.abort(new DOMException("another one was begun", "AbortError"));
  const controller = new AbortController();
  latest = controller;
  const { signal } = controller;
  const box = element("progress");
  element("progress-cancel").onclick = () =>
    controller.abort(new DOMException("cancelled", "AbortError"));
  try {
    return await run({
      signal,
      progress(share, what) {
        if (signal.aborted) return;
        box.hidden = false;
        element("progress-text").textContent = `${what}…`;
        const bar = element("progress-bar");
        if (share === undefined) bar.removeAttribute("value");
        else bar.value = share;
      },
    });
  } finally {
    if (latest === controller) box.hidden = true;
  }
}

let latest = new AbortController();

document.addEventListener(
  "keydown",
  (event) => {
    if (event.key !== "Escape" || element("progress").hidden) return;
    element("progress-cancel").click();
    event.preventDefault(); // it has been heard
  },
  true,
);
