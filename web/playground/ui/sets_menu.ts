// The menu of sets: presets with a small picture of each, random circles, the visitor's own data.
import { make, makeSvg } from "../../shared/dom.js";
import type { App } from "../app.js";
import type { Triple } from "../model/circle.js";
import type { Sites } from "../model/sites.js";
import { sitesFromFile, sitesFromText } from "../sets/import.js";
import { kPresets, type Params } from "../sets/presets.js";
import { element } from "./elements.js";
import { notify, sayWhatFailed, silence } from "./notice.js";
import { isIn } from "../tools/targets.js";

const kPicture = 120; // circles in one

/** Actions of the menu: `load` a set by its name, `show` the visitor's own. */
type Actions = {
  load(key: string, params?: Params): Promise<void>;
  show(sites: Sites): void;
};

export function makeSetsMenu(app: App, actions: Actions) {
  const menu = element("sets");
  const buttons = [
    ...Object.entries(kPresets).map(([key, { title, circles }]) => ({
      key,
      title,
      picture: pictureOf(circles()),
    })),
    { key: "cities", title: "Cities of the world", picture: null },
  ].map(({ key, title, picture }) => {
    const button = make("button", { type: "button" }, picture ?? worldPicture(), title);
    button.dataset.set = key;
    button.addEventListener("click", () => {
      menu.hidePopover();
      actions.load(key);
    });
    return button;
  });
  element("presets").append(...buttons, globeLink());
  app.model.on("change", ({ isSet }) => {
    if (!isSet) return;
    for (const button of buttons)
      button.setAttribute("aria-current", String(button.dataset.set === app.sites.info.key));
  });

  element("random").addEventListener("submit", (event) => {
    event.preventDefault();
    const fields = new FormData(element("random"));
    const asked = Object.fromEntries(Array.from(fields, ([name, value]) => [name, String(value)]));
    menu.hidePopover();
    actions.load("random", asked);
  });
  element("clear").addEventListener("click", () => {
    menu.hidePopover();
    app.edits.clear();
    element("overlay").focus();
  });
  listenToData(actions, () => menu.hidePopover());
}

function listenToData({ show }: Actions, close: () => void) {
  const read = async (make: () => Sites | Promise<Sites>) => {
    try {
      const sites = await make();
      show(sites);
      close();
      if (sites.info.about) notify(sites.info.about);
      else silence(); // a failure before this is over
    } catch (error) {
      sayWhatFailed("These circles could not be read")(error);
    }
  };
  const file = element("file");
  element("load-text").addEventListener("click", () =>
    read(() => sitesFromText(element("paste").value)),
  );
  element("load-file").addEventListener("click", () => file.click());
  file.addEventListener("change", () => {
    const [chosen] = file.files ?? [];
    if (chosen) read(() => sitesFromFile(chosen));
    file.value = "";
  });

  // Dropped anywhere; without this the browser would leave the page for the file.
  const drop = element("drop");
  addEventListener("dragover", (event) => {
    event.preventDefault();
    drop.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) drop.hidden = true;
  });
  addEventListener("drop", (event) => {
    event.preventDefault();
    drop.hidden = true;
    const [dropped] = event.dataTransfer?.files ?? [];
    const text = event.dataTransfer?.getData("text/plain");
    if (dropped) read(() => sitesFromFile(dropped));
    else if (text) read(() => sitesFromText(text));
  });
  addEventListener("paste", (event) => {
    if (isIn(event.target, "input, textarea")) return;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (text.trim() !== "") read(() => sitesFromText(text));
  });
}

/** Some of the circles, the largest ones. */
function pictureOf(circles: Triple[]) {
  const boxes = circles.map(([x, y, r]) => [x - r, y - r, x + r, y + r]);
  const low = [0, 1].map((axis) => Math.min(...boxes.map((box) => box[axis])));
  const high = [2, 3].map((axis) => Math.max(...boxes.map((box) => box[axis])));
  const size = [0, 1].map((axis) => high[axis] - low[axis]);
  const pad = 0.06 * Math.max(...size);
  const viewBox = [low[0] - pad, -high[1] - pad, size[0] + 2 * pad, size[1] + 2 * pad].join(" ");
  const largest = circles.toSorted((a, b) => b[2] - a[2]).slice(0, kPicture);
  const shapes = largest.map(([x, y, r]) =>
    makeSvg("circle", { cx: x, cy: -y, r: Math.max(r, size[0] / 60) }),
  );
  return makeSvg("svg", { viewBox, "aria-hidden": "true" }, ...shapes);
}

/** A link to the cities where distances are those on the Earth: a page of the examples. */
const globeLink = () =>
  make("a", { href: "../examples/globe.html" }, globePicture(), "Cities on the globe");

/** Small towards the rim, as on a ball. */
const globePicture = () =>
  pictureOf([
    [0, 0, 100],
    [12, 26, 22],
    [-38, 6, 15],
    [44, -16, 16],
    [-8, -44, 15],
    [-46, 54, 9],
    [62, 46, 8],
    [-72, -34, 7],
    [36, -72, 7],
    [88, 10, 5],
    [-90, 18, 4],
  ]);

/** A few cities stand for all. */
const worldPicture = () =>
  pictureOf([
    [-99, 19, 9],
    [-74, 41, 8],
    [-58, -34, 8],
    [-47, -23, 9],
    [0, 51, 6],
    [37, 55, 8],
    [29, 41, 9],
    [31, 30, 7],
    [3, 6, 7],
    [67, 24, 9],
    [77, 28, 9],
    [73, 19, 9],
    [121, 31, 12],
    [116, 40, 9],
    [140, 36, 8],
    [107, -6, 8],
    [151, -34, 5],
  ]);
