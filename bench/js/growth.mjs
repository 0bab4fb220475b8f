// Measures the growth of calls. bench/js/growth_calls.mjs lists the calls and the promised growth.
// An answer has `cost`, the promise in units that cancel when two sizes are compared. Samples are
// processor time for one use of a call.
import path from "node:path";
import { hierarchy } from "d3-hierarchy";
import {
  callsOfDiagrams,
  callsOfTrees,
  callsOfViews,
  callsOfWindows,
  slowCalls,
} from "./growth_calls.mjs";
import { sizedRings, starRing } from "./land.mjs";
import { boxOf, processorTime, readDoubles, sampled } from "./sampling.mjs";
import { sharesOf } from "./shares.mjs";
import { toSphere } from "./sphere.mjs";
import { randomTree } from "./treemaps.mjs";

const kPlaces = 256; // points that are asked about, one after the other
const kCells = 128; // cells, likewise
const kMoved = 256; // sites that are inserted, removed or moved
const kLeastSamples = 3;
const kMostSamples = 15;

/** The box of sites, with some height where they are on a line. */
function roomOf(sites) {
  const [xmin, ymin, xmax, ymax] = boxOf(sites, 3);
  const pad = ymin < ymax ? 0 : (xmax - xmin) / 10;
  return [xmin, ymin - pad, xmax, ymax + pad];
}

/** Some visible sites, and the one with the most neighbours. */
function askedIds(diagram) {
  const visible = Array.from(diagram.ids()).filter((id) => !diagram.isHidden(id));
  const degreeOf = (id) => diagram.neighbors(id).length;
  const step = Math.max(1, Math.floor(visible.length / kCells));
  const most = visible.reduce((a, b) => (degreeOf(b) > degreeOf(a) ? b : a));
  const ids = visible.filter((id, k) => k % step === 0 && id !== most);
  return [most, ...ids.slice(0, kCells - 1)];
}

/** A surface, as the uses of calls get it: diagram and view, places and ids that are asked for. */
function surfaceOf(Class, sites, places, box) {
  const make = (triples) => new Class(triples);
  const diagram = make(sites);
  const degreesOf = (list) => list.map((id) => diagram.neighbors(id).length);
  const n = sites.length / 3;
  const ids = askedIds(diagram);
  const count = Math.min(kMoved, n >> 2);
  const last = Array.from({ length: count }, (_, k) => n - count + k);
  const moved = {
    ids: Uint32Array.from(last),
    xyr: sites.slice(3 * (n - count)),
    degrees: degreesOf(last),
  };
  const all = Uint32Array.from(sites.subarray(0, n), (_, k) => k);
  const values = Float64Array.from(sites.subarray(0, n), (_, k) => k % 7);
  const degrees = degreesOf(ids);
  return { Class, make, diagram, sites, places, box, n, all, ids, degrees, moved, values };
}

function planeOf({ Diagram, enclose }, set) {
  const sites = readDoubles(`${set}.sites`);
  const places = readDoubles(`${set}.near`).subarray(0, 2 * kPlaces);
  const box = roomOf(sites);
  const surface = surfaceOf(Diagram, sites, places, box);
  const { diagram, n } = surface;
  const ring = starRing(box, n);
  const starPoints = new Uint32Array(n);
  for (const id of diagram.findMany(ring.flat())) ++starPoints[id];
  return {
    ...surface,
    enclose,
    view: diagram.voronoi(box),
    star: diagram.voronoi([ring]),
    starRings: [ring],
    starPoints,
  };
}

function globeOf({ SphericalDiagram }, set) {
  const sites = readDoubles(`${set}.sites`);
  const box = roomOf(sites);
  const places = readDoubles(`${set}.box`).subarray(0, 2 * kPlaces);
  const surface = surfaceOf(
    SphericalDiagram,
    toSphere(sites, 3, box),
    toSphere(places, 2, box),
    [-180, -90, 180, 90],
  );
  return { ...surface, view: surface.diagram.voronoi() };
}

/** "rim": sites on a circle around a large one, in a rectangle; else a window of n points. */
function windowOf({ Diagram }, set) {
  const [shape, size] = path.basename(set).split("-");
  const n = +size;
  if (shape === "rim") {
    const rim = sizedRings.disc([-300, -300, 300, 300], n)[0];
    const diagram = new Diagram([0, 0, 100, ...rim.flatMap(([x, y]) => [x, y, 0])]);
    return { n, diagram, view: diagram.voronoi([-500, -500, 500, 500]) };
  }
  const diagram = new Diagram([1, 3, 0]);
  return { n, diagram, view: diagram.voronoi(sizedRings[shape]([-10, -10, 10, 10], n)) };
}

function treeOf({ treemap }, set) {
  const n = +path.basename(set).split("-")[1];
  const rootOf = (data) => hierarchy(data).sum(({ size = 0 }) => size);
  const flat = { children: Array.from(sharesOf(n, false), (size) => ({ size })) };
  return { n, layout: treemap, groups: rootOf(randomTree(n)), flat: rootOf(flat) };
}

/** @param {any} library the classes and functions of the package */
export function growthOperations(library) {
  const makers = { plane: planeOf, globe: globeOf, window: windowOf, tree: treeOf };
  const kept = { set: "", kind: "", surface: undefined };

  /** Made once, as many calls in a row are on it. */
  function surfaceFor(kind, { set }) {
    if (kept.set !== set || kept.kind !== kind) {
      kept.surface?.diagram?.dispose();
      Object.assign(kept, { set: "", surface: undefined });
      Object.assign(kept, { set, kind, surface: makers[kind](library, set) });
    }
    return kept.surface;
  }

  const timed = (call) => (request) => {
    const surface = surfaceFor(call.surface, request);
    const { cost, use, before = () => {}, after = () => {} } = call;
    const once = () => void use(surface);
    const { seconds } = request;
    let isUsed = false;
    const prepare = () => {
      if (isUsed) after(surface);
      before(surface);
      isUsed = true;
    };
    kept.set = ""; // if it throws, all is made again
    const promised = cost.of(surface);
    const limits = { seconds, least: kLeastSamples, most: kMostSamples };
    const { samples } = sampled(limits, 1, once, prepare, processorTime);
    after(surface);
    kept.set = request.set;
    return { samples, cost: promised, promise: cost.text };
  };
  const calls = [
    ...callsOfDiagrams,
    ...callsOfViews,
    ...slowCalls,
    ...callsOfWindows,
    ...callsOfTrees,
  ];
  return Object.fromEntries(calls.map((call) => [call.name, timed(call)]));
}
