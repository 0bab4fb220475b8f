// The packed package as a contender. The operations are those of bench/native/operations.cpp, and
// calls, memory and churn.
import path from "node:path";
import { pathToFileURL } from "node:url";
import {
  boxOf,
  forEachUntil,
  forMilliseconds,
  readDoubles,
  readQueries,
  sampled,
  sampledLater,
  sampledQueries,
  Sum,
} from "./sampling.mjs";
import { sphereOperations } from "./sphere.mjs";
import { growthOperations } from "./growth.mjs";
import { startFinders } from "./threads.mjs";
import { kHeight, kWidth, labelsOfTreemap, treemapOperations } from "./treemaps.mjs";
import { windowOperations } from "./windows.mjs";

// The package does not show its heap, so the instance's memory is caught when it is made.
let memory;
WebAssembly.Instance = class extends WebAssembly.Instance {
  constructor(...args) {
    super(...args);
    memory ??= Object.values(this.exports).find((value) => value instanceof WebAssembly.Memory);
  }
};
const heapBytes = () => memory.buffer.byteLength;

const entry = (name) => import(pathToFileURL(path.join(process.env.BENCH_PACKAGE, name)).href);
const { Diagram, enclose } = await entry("consumer.mjs");
const { SphericalDiagram } = await entry("sphere.mjs");
const { treemap } = await entry("treemap.mjs");
const treemapOf = (sites) => treemap().shape([0, 0, kWidth, kHeight]).sites(sites);

// The last set and its diagram are kept, so that several queries in a row need one construction.
const current = { set: "", sites: new Float64Array(), diagram: new Diagram(), isWhole: false };

function renew(diagram) {
  current.diagram.dispose();
  current.diagram = diagram;
}

function load({ set }) {
  if (set === current.set) return;
  current.set = set;
  current.sites = readDoubles(`${set}.sites`);
  renew(new Diagram());
  current.isWhole = false;
}

function ensureDiagram(request) {
  load(request);
  if (current.isWhole) return;
  current.diagram.dispose(); // before, not after: one diagram in the heap at a time
  current.diagram = new Diagram(current.sites);
  current.isWhole = true;
}

const size = () => current.sites.length / 3;
const countOf = (request) => (request.count > 0 ? Math.min(request.count, size()) : size());
const withVisible = (answer) => ({ ...answer, visible: current.diagram.visibleSize });

// --- Construction --------------------------------------------------------------------------------

function build(request) {
  load(request);
  const work = () => {
    current.diagram = new Diagram(current.sites);
  };
  const answer = sampled(request, size(), work, () => renew(new Diagram()));
  current.isWhole = true;
  return withVisible(answer);
}

function insertOneByOne(request) {
  load(request);
  const { sites } = current;
  const count = countOf(request);
  const prepare = () => {
    renew(new Diagram());
    current.isWhole = false;
  };
  const work = () => {
    const { diagram } = current;
    return forEachUntil(request.limit, count, (k) => {
      diagram.insert(sites[3 * k], sites[3 * k + 1], sites[3 * k + 2]);
    });
  };
  return withVisible(sampled(request, count, work, prepare));
}

// --- Snapshots -----------------------------------------------------------------------------------

function toBytes(request) {
  ensureDiagram(request);
  const work = () => ({ sink: current.diagram.toBytes().length });
  return withVisible(sampled(request, size(), work));
}

function fromBytes(request) {
  ensureDiagram(request);
  const bytes = current.diagram.toBytes();
  const work = () => {
    current.diagram = Diagram.fromBytes(bytes, { trusted: true });
    return { sink: bytes.length };
  };
  return withVisible(sampled(request, size(), work, () => renew(new Diagram())));
}

/**
 * findMany with the points dealt out to `count` threads, each with a diagram restored from one
 * snapshot. Moving the points and results between threads is timed, too.
 */
async function findManyOnThreads(request) {
  ensureDiagram(request);
  const points = readQueries({ ...request, count: 0 });
  const finders = await startFinders(request.count, current.diagram.toBytes());
  let sink = 0;
  const answer = await sampledLater(request, points.length / 2, async () => {
    sink = await finders.find(points);
  });
  await finders.stop();
  return withVisible({ ...answer, sink });
}

// --- Queries -------------------------------------------------------------------------------------

function find(request) {
  ensureDiagram(request);
  const { diagram } = current;
  const stepOf = (points) => (k) => diagram.find(points[2 * k], points[2 * k + 1]);
  return withVisible(sampledQueries(request, stepOf));
}

function findMany(request) {
  ensureDiagram(request);
  const points = readQueries(request);
  let found;
  const answer = sampled(request, points.length / 2, () => {
    found = current.diagram.findMany(points);
  });
  return withVisible({ ...answer, sink: found.reduce((sum, id) => sum + id, 0) });
}

// --- Shapes: in the bounding box of the centres --------------------------------------------------

function draw(request) {
  ensureDiagram(request);
  const bounds = boxOf(current.sites, 3);
  const work = () => {
    const sum = new Sum();
    current.diagram.voronoi(bounds).render(sum);
    return { sink: sum.value };
  };
  return withVisible(sampled(request, size(), work));
}

function cellAreas(request) {
  ensureDiagram(request);
  const [xmin, ymin, xmax, ymax] = boxOf(current.sites, 3);
  let areas;
  const answer = sampled(request, size(), () => {
    areas = current.diagram.voronoi([xmin, ymin, xmax, ymax]).cellAreas();
  });
  const sink = areas.reduce((sum, area) => sum + area, 0);
  const error = Math.abs(sink / ((xmax - xmin) * (ymax - ymin)) - 1);
  return error < 1e-9
    ? withVisible({ ...answer, sink })
    : { error: `areas do not add up: ${error}` };
}

/** Ten. */
function kNearest(request) {
  ensureDiagram(request);
  const { diagram } = current;
  const stepOf = (points) => (k) => diagram.kNearest(points[2 * k], points[2 * k + 1], 10).at(-1);
  return withVisible(sampledQueries(request, stepOf));
}

// --- Changes: on the sites at the end of the set, whose ids are their places in it ---------------

/** The visible ones among the last `count` sites, last first: CGAL cannot remove the others. */
function visibleAtEnd(count) {
  const last = size() - 1;
  return Uint32Array.from({ length: count }, (_, k) => last - k).filter(
    (id) => !current.diagram.isHidden(id),
  );
}

function removed(request, atOnce) {
  ensureDiagram(request);
  const ids = visibleAtEnd(countOf(request));
  const work = () => {
    const { diagram } = current;
    current.isWhole = false;
    if (atOnce) return { sink: diagram.removeMany(ids) };
    return forEachUntil(request.limit, ids.length, (k) => diagram.remove(ids[k]));
  };
  return withVisible(sampled(request, ids.length, work, () => ensureDiagram(request)));
}

/** The site nearest to each of `count` places: of sites that hide each other, the visible one. */
function removeNearest(request) {
  load(request);
  const points = readQueries(request);
  const count = Math.min(points.length / 2, size() - 1);
  const work = () => {
    const { diagram } = current;
    current.isWhole = false;
    return forEachUntil(request.limit, count, (k) =>
      diagram.remove(diagram.find(points[2 * k], points[2 * k + 1])),
    );
  };
  return withVisible(sampled(request, count, work, () => ensureDiagram(request)));
}

function meanSpacing(sites) {
  const [xmin, ymin, xmax, ymax] = boxOf(sites, 3);
  return Math.sqrt(((xmax - xmin) * (ymax - ymin)) / (sites.length / 3));
}

/**
 * The last `count` sites move at constant velocities of up to `step` mean spacings a frame; each
 * frame is one sample.
 */
function moved(request, atOnce) {
  ensureDiagram(request);
  current.isWhole = false;
  const { diagram } = current;
  const count = countOf(request);
  const first = size() - count;
  const ids = Uint32Array.from({ length: count }, (_, k) => first + k);
  const moving = current.sites.slice(3 * first);
  const step = request.step * meanSpacing(current.sites);
  const fraction = (value) => value - Math.floor(value);
  const nextFrame = () => {
    for (let k = 0; k < count; ++k) {
      moving[3 * k] += step * (2 * fraction(k * 0.6180339887498949) - 1);
      moving[3 * k + 1] += step * (2 * fraction(k * 0.4142135623730951) - 1);
    }
  };
  const work = () => {
    if (atOnce) return void diagram.updateMany(ids, moving);
    return forEachUntil(request.limit, count, (k) => {
      diagram.update(ids[k], moving[3 * k], moving[3 * k + 1], moving[3 * k + 2]);
    });
  };
  return withVisible(sampled(request, count, work, nextFrame));
}

// --- The border and the memory -------------------------------------------------------------------

/** A million calls that do nothing but cross the border. */
function calls(request, call) {
  ensureDiagram(request);
  const { diagram } = current;
  const count = request.count || 1_000_000;
  return sampled(request, count, () => {
    let sink = 0;
    for (let k = 0; k < count; ++k) sink += call(diagram, k);
    return { sink };
  });
}

/**
 * Growth of the heap by one construction; only the first one of a process tells, because the heap
 * never shrinks.
 */
function memoryOfBuild(request) {
  load(request);
  const before = heapBytes();
  const answer = build(request);
  return { ...answer, bytesPerSite: (heapBytes() - before) / size() };
}

/**
 * `count` pairs of a removal and an insertion of a new site elsewhere; the heap after the first
 * thousand and after all.
 */
function churn(request) {
  ensureDiagram(request);
  current.isWhole = false;
  const { diagram, sites } = current;
  const points = readQueries(request);
  const ids = diagram.ids();
  const count = request.count || 1_000_000;
  const pair = (k) => {
    const slot = (k * 7919) % ids.length;
    const query = 2 * (k % (points.length / 2));
    diagram.remove(ids[slot]);
    ids[slot] = diagram.insert(points[query], points[query + 1], sites[3 * slot + 2]);
  };
  const pairsTo = (end, start) => {
    for (let k = start; k < end; ++k) pair(k);
  };
  pairsTo(1000, 0);
  const afterThousand = heapBytes();
  const answer = sampled({ ...request, seconds: 0 }, count - 1000, () => pairsTo(count, 1000));
  return withVisible({ ...answer, bytesAfterThousand: afterThousand, bytesAfterAll: heapBytes() });
}

export const operations = {
  build,
  find,
  findMany,
  draw,
  cellAreas,
  churn,
  toBytes,
  fromBytes,
  findManyOnThreads,
  kNearest,
  removeNearest,
  findNear: find,
  insert: insertOneByOne,
  remove: (request) => removed(request, false),
  removeMany: (request) => removed(request, true),
  update: (request) => moved(request, false),
  updateMany: (request) => moved(request, true),
  callSize: (request) => calls(request, (diagram) => diagram.size),
  callHas: (request) => calls(request, (diagram, k) => diagram.has(k)),
  memory: memoryOfBuild,
  ...windowOperations(Diagram),
  ...growthOperations({ Diagram, SphericalDiagram, enclose, treemap: treemapOf("stay") }),
  ...treemapOperations(
    { treemapMove: treemapOf("move"), treemapStay: treemapOf("stay") },
    (leaf) => leaf.area,
  ),
  treemapLabels: labelsOfTreemap(treemapOf("move")),
  ...sphereOperations({
    make: (lonLatR) => new SphericalDiagram(lonLatR),
    end: (diagram) => diagram.dispose(),
    find: (diagram, lon, lat) => diagram.find(lon, lat),
    polygons: (diagram) => diagram.voronoi().toGeoJSON({ winding: "clockwise" }),
    others: {
      sphereAreas: (diagram) => diagram.voronoi().cellAreas(),
      sphereCut: (diagram) => diagram.voronoi().toGeoJSON(),
    },
  }),
};

export function warmUp() {
  let state = 1;
  const random = () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
  forMilliseconds(700, () => {
    const sites = Float64Array.from(
      { length: 3 * 2000 },
      (_, k) => random() * (k % 3 === 2 ? 20 : 2000),
    );
    const diagram = new Diagram(sites);
    for (let k = 0; k < 500; ++k) {
      diagram.find(2000 * random(), 2000 * random());
      diagram.update(2 * k, 2000 * random(), 2000 * random(), 20 * random());
      diagram.remove(2 * k + 1);
      diagram.insert(2000 * random(), 2000 * random(), 20 * random());
    }
    diagram.findMany(sites.subarray(0, 4000));
    diagram.voronoi([0, 0, 2000, 2000]).render(new Sum());
    diagram.dispose();
  });
}
