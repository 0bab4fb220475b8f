// The link to what is shown, and files of it.
import type { App } from "../app.js";
import type { Address } from "../sets/address.js";
import { isFormat, save } from "../sets/export.js";
import { grouped } from "./dom.js";
import { element } from "./elements.js";
import { notify, sayWhatFailed } from "./notice.js";

/** @param writeAddress says what the address holds */
export function makeShareMenu(app: App, writeAddress: () => Address) {
  const update = () => {
    const { isWhole, length } = writeAddress();
    // A link without the changes would show something else.
    element("copy-link").disabled = !isWhole;
    element("link-note").textContent = isWhole
      ? "The link holds the set, your changes and the view."
      : `${tooLong(length)}: export a file. This browser keeps them until you leave.`;
    return isWhole;
  };
  // Not "toggle", which comes after the menu is seen: it would show what was true the last time.
  element("share").addEventListener("beforetoggle", update);
  element("copy-link").addEventListener("click", async () => {
    if (!update()) return;
    await copy(location.href, "The link is copied.");
    element("share").hidePopover();
  });
  element("exports").addEventListener("click", ({ target }) => {
    const format = target instanceof HTMLElement ? (target.dataset.format ?? "") : "";
    if (isFormat(format)) save(app, format).catch(sayWhatFailed("The file could not be made"));
  });
}

const tooLong = (length: number) =>
  Number.isFinite(length)
    ? `Too many changes for a link, which would have ${grouped(length)} characters`
    : "Too many changes for a link";

export async function copy(text: string, said: string) {
  try {
    await navigator.clipboard.writeText(text);
    notify(said);
  } catch {
    notify(`Copying is not allowed here. ${text.length < 200 ? text : ""}`);
  }
}
