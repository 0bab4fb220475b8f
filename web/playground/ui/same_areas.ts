// The switch "Same area for all".

import type { App } from "../app.js";
import { effect } from "../model/signals.js";
import type { SameAreas } from "../motion/same_areas.js";
import { oncePerFrame } from "./dom.js";
import { element } from "./elements.js";
import { sayWhatFailed } from "./notice.js";
import { withProgress } from "./progress.js";

export function makeSameAreasSwitch(app: App, areas: SameAreas) {
  const input = element("same-areas");
  const update = oncePerFrame(() => {
    const { hindrance } = areas;
    input.disabled = hindrance !== "";
    element("same-areas-hindrance").textContent = hindrance;
    element("same-areas-hindrance").hidden = hindrance === "";
  });
  const show = () => {
    input.checked = areas.isOn;
    for (const id of ["same-areas-radii", "radii"] as const) {
      element(id).textContent = areas.radii;
      element(id).hidden = areas.radii === "";
    }
  };
  effect(show);
  app.model.on("change", update);
  update();

  input.addEventListener("change", async () => {
    element("show").hidePopover();
    if (!input.checked) {
      areas.turnOff();
      return;
    }
    try {
      await withProgress((watch) => areas.turnOn(watch), "Cancel fitting");
    } catch (error) {
      sayWhatFailed("The areas cannot be the same")(error);
    }
    show();
  });
}
