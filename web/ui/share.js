// The link to what is shown, and files of it.
import { save } from "../sets/export.js";
import { element } from "./dom.js";
import { notify, sayWhatFailed } from "./notice.js";

/**
 * @param {import("../app.js").App} app
 * @param {() => boolean} writeAddress says whether the address holds everything
 */
export function makeShareMenu(app, writeAddress) {
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
    const { format } = target.dataset;
    if (format) save(app, format).catch(sayWhatFailed("The file could not be made"));
  });
}

/** @param {string} text @param {string} said */
export async function copy(text, said) {
  try {
    await navigator.clipboard.writeText(text);
    notify(said);
  } catch {
    notify(`Copying is not allowed here. ${text.length < 200 ? text : ""}`);
  }
}
