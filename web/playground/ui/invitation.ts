// The text of an empty diagram: how to begin.
import type { App } from "../app.js";
import { oncePerFrame } from "./dom.js";
import { element } from "./elements.js";

export function makeInvitation(app: App) {
  const update = oncePerFrame(() => {
    element("invitation").hidden = app.sites.size > 0;
  });
  app.model.on("change", update);
  update();
}
