// Runs in a worker: measures how long this library, delaunator and flatbush take to build for
// random circles, and to find what is nearest to random places. Each message has a number of
// circles.
import { Diagram } from "apollonius-diagram";
import Delaunator from "delaunator";
import Flatbush from "flatbush";
import { whenLoaded } from "../../shared/package.js";
import { generator, randomCircles } from "../../shared/random_sets.js";

/** Microseconds a circle, or a query. */
export type Measured = {
  build: number;
  buildDelaunator: number;
  buildFlatbush: number;
  findMany: number;
  find: number;
  findFlatbush: number;
};
export type Told =
  | { kind: "progress"; what: string }
  | { kind: "done"; times: Measured }
  | { kind: "failed"; message: string };

const kSide = 1000; // units of the square that circles are in
const kHiddenShare = 0.05;
const kQueries = 50_000;
const kLeast = 5; // ms of one measurement, as clocks of browsers are coarse
const kWarm = 150; // ms before that, in which the browser compiles what is run often
const kEnough = 150; // ms of all measurements of one kind
const kMostTimes = 9;
const kMostRepeats = 500;

const tell = (told: Told) => self.postMessage(told);

/** The median time of one run, in microseconds; the first runs do not count. */
function timeOf(what: string, run: () => void): number {
  tell({ kind: "progress", what });
  const timed = (repeats: number) => {
    const start = performance.now();
    for (let k = 0; k < repeats; k++) run();
    return performance.now() - start;
  };
  let once = 0;
  for (let sum = 0; sum < kWarm; sum += once) once = timed(1);
  const repeats = Math.ceil(kLeast / Math.max(once, kLeast / kMostRepeats));
  const times: number[] = [];
  for (let sum = 0; times.length < 3 || (sum < kEnough && times.length < kMostTimes); ) {
    const time = timed(repeats);
    sum += time;
    times.push((1000 * time) / repeats);
  }
  return times.sort((a, b) => a - b)[times.length >> 1];
}

function flatbushOf(xy: Float64Array) {
  const index = new Flatbush(xy.length / 2);
  for (let k = 0; k < xy.length; k += 2) index.add(xy[k], xy[k + 1], xy[k], xy[k + 1]);
  index.finish();
  return index;
}

function measure(count: number): Measured {
  tell({ kind: "progress", what: "Making circles" });
  const box = { width: kSide, height: kSide };
  const xyr = randomCircles({ count, hiddenShare: kHiddenShare, seed: 1, ...box });
  const xy = Float64Array.from({ length: 2 * count }, (_, k) => xyr[3 * (k >> 1) + (k % 2)]);
  const random = generator(2);
  const places = Float64Array.from({ length: 2 * kQueries }, () => kSide * random());
  const eachPlace = (ask: (x: number, y: number) => void) => () => {
    for (let k = 0; k < places.length; k += 2) ask(places[k], places[k + 1]);
  };

  const build = timeOf("Building circles", () => new Diagram(xyr).dispose());
  const buildDelaunator = timeOf("Building with delaunator", () => new Delaunator(xy));
  const buildFlatbush = timeOf("Building with flatbush", () => flatbushOf(xy));
  using diagram = new Diagram(xyr);
  const index = flatbushOf(xy);
  const findMany = timeOf("Asking findMany", () => diagram.findMany(places));
  const find = timeOf(
    "Asking find",
    eachPlace((x, y) => diagram.find(x, y)),
  );
  const findFlatbush = timeOf(
    "Asking flatbush",
    eachPlace((x, y) => index.neighbors(x, y, 1)),
  );
  return {
    build: build / count,
    buildDelaunator: buildDelaunator / count,
    buildFlatbush: buildFlatbush / count,
    findMany: findMany / kQueries,
    find: find / kQueries,
    findFlatbush: findFlatbush / kQueries,
  };
}

self.onmessage = async ({ data: { count } }: MessageEvent<{ count: number }>) => {
  try {
    await whenLoaded([]);
    tell({ kind: "done", times: measure(count) });
  } catch (error) {
    tell({ kind: "failed", message: error instanceof Error ? error.message : String(error) });
  }
};
