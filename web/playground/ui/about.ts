// The sentence below the headline: what the set shows.
import type { App } from "../app.js";
import { setText } from "./dom.js";
import { element } from "./elements.js";

/** At once, not with the next frame: how tall it is decides what the picture is fitted into. */
export function makeAbout({ model }: App) {
  model.on("change", () => setText(element("about"), model.sites.info.about ?? ""));
}
