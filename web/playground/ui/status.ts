// How many circles there are, and how long things take. Times are medians of many calls after a
// warm-up: a single one is shorter than the step of the browser's clock. What differs too much from
// run to run is not shown, and what is shown stays until it is clearly wrong.

import { Diagram } from "apollonius-diagram";
import type { App } from "../app.js";
import { duration, grouped, oncePerFrame, setText } from "./dom.js";
import { element } from "./elements.js";

const kQuiet = 600; // ms from the last edit to what is measured after it
const kQueries = 500;
const kMostRebuilt = 5000; // sites
const kBatches = 7;
const kMostSpread = 1.5; // of the middle batches' times, as a ratio
const kSame = 1.6; // the ratio from which on another time replaces the one that is shown
const kLongEnough = 20; // ms: a single run this long is measured well
const kLeast = 4; // ms that must have passed for a time to mean something

export function makeStatus(app: App) {
  let measuring = 0;
  let times: Times = {};

  const update = oncePerFrame(() => {
    const { diagram, sites } = app;
    setText(element("count-all"), grouped(diagram.size));
    setText(element("count-hidden"), grouped(diagram.hiddenSize));
    element("of-hidden").hidden = diagram.hiddenSize === 0;
    setText(element("timing"), textOf(times));
    element("credit").hidden = sites.info.credit !== "cities";
    for (const name of ["map", "coast"] as const) element(`layer-${name}`).hidden = !sites.info.map;
  });

  /** Anew once nothing has changed for a while: whoever edits is not to feel it. */
  const measureLater = () => {
    if (measuring && textOf(times) === "") return;
    clearTimeout(measuring);
    measuring = setTimeout(() => {
      measuring = 0;
      times = steady(times, measure(app));
      update();
    }, kQuiet);
  };
  app.model.on("change", ({ isSet }) => {
    if (isSet) times = {};
    update();
    measureLater();
  });
  update();
}

/** Milliseconds that building takes, and asking for the nearest site; none without a good one. */
type Times = { build?: number; nearest?: number };

function textOf({ build, nearest }: Times) {
  const said = [];
  if (build !== undefined) said.push(`built in about ${duration(build)}`);
  if (nearest !== undefined) said.push(`nearest in about ${duration(nearest)}`);
  return said.join(", ");
}

/** Returns the times that are shown next. */
function steady(shown: Times, found: Times): Times {
  const next = (before?: number, now?: number) => {
    if (before === undefined || now === undefined) return now ?? before;
    return Math.max(before / now, now / before) < kSame ? before : now;
  };
  return { build: next(shown.build, found.build), nearest: next(shown.nearest, found.nearest) };
}

function measure({ diagram, sites, view, painter }: App): Times {
  if (diagram.size === 0 || painter.isLive) return {};
  const points = Array.from({ length: 256 }, () => [
    view.toWorldX(view.width * Math.random()),
    view.toWorldY(view.height * Math.random()),
  ]);
  const ask = () => {
    for (let k = 0; k < kQueries; k++) diagram.find(points[k & 255][0], points[k & 255][1]);
  };
  const queries = timeOf(ask);
  const nearest = queries && queries / kQueries;
  if (sites.size > kMostRebuilt)
    return { nearest, build: sites.buildTime >= kLongEnough ? sites.buildTime : undefined };
  const xyr = sites.triples(sites.ids);
  return { nearest, build: timeOf(() => new Diagram(xyr).dispose()) };
}

/** Milliseconds a run takes: the median of batches, if those in the middle agree. */
function timeOf(run: () => void) {
  run();
  const batches = Array.from({ length: kBatches }, () => {
    const start = performance.now();
    let runs = 0;
    do {
      run();
      runs++;
    } while (performance.now() - start < kLeast);
    return (performance.now() - start) / runs;
  }).sort((a, b) => a - b);
  const quarter = Math.floor(kBatches / 4);
  const isGood = batches[kBatches - 1 - quarter] < kMostSpread * batches[quarter];
  return isGood ? batches[Math.floor(kBatches / 2)] : undefined;
}
