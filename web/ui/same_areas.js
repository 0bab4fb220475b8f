// The switch "Same area for all".
import { element, oncePerFrame } from "./dom.js";
import { sayWhatFailed } from "./notice.js";
import { withProgress } from "./progress.js";

/**
 * @param {import("../app.js").App} app
 * @param {import("../motion/same_areas.js").SameAreas} areas
 */
export function makeSameAreasSwitch(app, areas) {
  const input = element("same-areas");
  const update = oncePerFrame(() => {
    const { hindrance } = areas;
    input.disabled = hindrance !== "";
    element("same-areas-hindrance").textContent = hindrance;
    element("same-areas-hindrance").hidden = hindrance === "";
  });
  const show = () => {
    input.checked = areas.isOn;
  };
  areas.addEventListener("change", show);
  app.addEventListener("change", update);
  update();

  input.addEventListener("change", async () => {
    element("show").hidePopover();
    if (!input.checked) {
      areas.turnOff();
      return;
    }
    try {
      await withProgress((watch) => areas.turnOn(watch));
    } catch (error) {
      sayWhatFailed("The areas cannot be the same")(error);
    }
    show();
  });
}
