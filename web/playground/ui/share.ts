// The link to what is shown, and files of it.
import type { App } from "../app.js";
import { isFormat, save } from "../sets/export.js";
import { element } from "./elements.js";
import { notify, sayWhatFailed } from "./notice.js";

/** @param writeAddress says whether the address holds everything */
export function makeShareMenu(app: App, writeAddress: () => boolean) {
  element("share").addEventListener("toggle", () => {
    element("link-note").textContent = writeAddress()
      ? "The link holds the set, your changes and the view."
      : "Too many changes for a link: export them. This browser keeps them until you leave.";
  });
  element("copy-link").addEventListener("click", async () => {
    writeAddress();
    await copy(location.href, "The link is copied.");
    element("share").hidePopover();
  });
  element("exports").addEventListener("click", ({ target }) => {
    const format = target instanceof HTMLElement ? (target.dataset.format ?? "") : "";
    if (isFormat(format)) save(app, format).catch(sayWhatFailed("The file could not be made"));
  });
}

export async function copy(text: string, said: string) {
  try {
    await navigator.clipboard.writeText(text);
    notify(said);
  } catch {
    notify(`Copying is not allowed here. ${text.length < 200 ? text : ""}`);
  }
}
