// How many circles there are, how long things take, and what a screen reader is told. Times are of
// many calls after a warm-up: a single one is shorter than the step of the browser's clock.

import { Diagram } from "apollonius-diagram";
import type { App } from "../app.js";
import { whenever } from "../model/signals.js";
import { duration, grouped, oncePerFrame, setText } from "./dom.js";
import { element } from "./elements.js";

const kAnnounceAfter = 400; // ms: a screen reader hears where a movement ended, not every step
const kQuiet = 600; // ms from the last edit to what is measured after it
const kQueries = 500;
const kMostRebuilt = 5000; // sites
const kBatches = 3;
const kLeast = 4; // ms that must have passed for a time to mean something

export function makeStatus(app: App) {
  let measuring = 0;
  let times = "";
  let announcing = 0;

  const update = oncePerFrame(() => {
    const { diagram, sites } = app;
    setText(element("count-all"), grouped(diagram.size));
    setText(element("count-hidden"), grouped(diagram.hiddenSize));
    element("of-hidden").hidden = diagram.hiddenSize === 0;
    setText(element("timing"), times);
    element("credit").hidden = sites.info.credit !== "cities";
    setText(element("about"), sites.info.about ?? "");
    for (const name of ["map", "coast"] as const) element(`layer-${name}`).hidden = !sites.info.map;
  });

  /** Anew once nothing has changed for a while: whoever edits is not to feel it. */
  const measureLater = () => {
    if (measuring && times === "") return;
    clearTimeout(measuring);
    measuring = setTimeout(() => {
      measuring = 0;
      times = measure(app);
      update();
    }, kQuiet);
  };
  app.model.on("change", ({ isSet }) => {
    if (isSet) times = "";
    update();
    measureLater();
  });
  whenever(
    () => app.selection.ids,
    () => announce(selectionText(app)),
  );

  function announce(text: string) {
    clearTimeout(announcing);
    announcing = setTimeout(() => setText(element("announcer"), text), kAnnounceAfter);
  }
  update();
  return { announce };
}

/** Of building and of asking for the nearest site. */
function measure({ diagram, sites, view, painter }: App) {
  if (diagram.size === 0 || painter.isLive) return "";
  const points = Array.from({ length: 256 }, () => [
    view.toWorldX(view.width * Math.random()),
    view.toWorldY(view.height * Math.random()),
  ]);
  const ask = () => {
    for (let k = 0; k < kQueries; k++) diagram.find(points[k & 255][0], points[k & 255][1]);
  };
  const perQuery = timeOf(ask) / kQueries;
  const xyr = sites.triples(sites.ids);
  const buildTime =
    sites.size <= kMostRebuilt && sites.weight === 1
      ? timeOf(() => new Diagram(xyr).dispose())
      : sites.buildTime;
  return `built in ${duration(buildTime)}, nearest in ${duration(perQuery)}`;
}

/** Milliseconds a run takes: of the fastest batch, as others are interrupted. */
function timeOf(run: () => void) {
  run();
  let least = Infinity;
  for (let batch = 0; batch < kBatches; batch++) {
    const start = performance.now();
    let runs = 0;
    do {
      run();
      runs++;
    } while (performance.now() - start < kLeast);
    least = Math.min(least, (performance.now() - start) / runs);
  }
  return least;
}

function selectionText({ selection, sites, diagram }: App) {
  if (selection.size === 0) return "Nothing selected";
  if (selection.size > 1) return `${grouped(selection.size)} circles selected`;
  const id = selection.single;
  const state = diagram.isHidden(id)
    ? `hidden inside ${sites.label(diagram.coverOf(id)).name}`
    : `${diagram.neighbors(id).length} neighbours`;
  return `${sites.label(id).name} selected, ${state}`;
}
