// A program: calls made while the heap is full and cannot grow. Prints, for each, the code of what
// it threw ("none" if it did not) and whether the diagram was as before. A process of its own, as
// it replaces WebAssembly.Memory.prototype.grow.
import { Diagram } from "../../../build/packed/consumer.mjs";
import { levels, validate } from "../../../build/packed/diagnostics.mjs";
import { SphericalDiagram } from "../../../build/packed/sphere.mjs";
import { calls } from "./calls.mjs";

// One site with very many neighbours: then even a call about a single site needs much memory.
const kRing = 3000;
const hub = 0;
const xyr = new Float64Array(3 * (kRing + 1));
xyr.set([0, 0, 900]);
for (let k = 1; k <= kRing; ++k) {
  const angle = (2 * Math.PI * k) / kRing;
  xyr.set([1000 * Math.cos(angle), 1000 * Math.sin(angle), 0.05], 3 * k);
}
const diagram = new Diagram(xyr);
const view = diagram.voronoi([-1100, -1100, 1100, 1100]);

const many = 20_000;
const points = new Float64Array(2 * many).map((_, k) => k % 1009);
const sites = new Float64Array(3 * many).map((_, k) => (k % 3 === 2 ? 1 : (k * 7919) % 100_003));
const ids = new Uint32Array(many).fill(hub);
const targets = new Float64Array(kRing + 1).fill(1);
const bytes = diagram.toBytes();
const ink = { moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} };

/** Calls that need much memory. */
const large = {
  "Diagram.constructor": () => new Diagram(sites),
  "Diagram.from": () =>
    Diagram.from(
      { length: many },
      (_, k) => k % 1013,
      (_, k) => k % 997,
    ),
  "Diagram.insert": () => diagram.insert(0, 0, 5000), // covers all the others
  "Diagram.insertMany": () => diagram.insertMany(sites),
  "Diagram.remove": () => diagram.remove(hub),
  "Diagram.removeMany": () => diagram.removeMany(ids),
  "Diagram.update": () => diagram.update(hub, 0, 0, 10),
  "Diagram.updateMany": () => diagram.updateMany(ids, sites),
  "Diagram.fromBytes": () => Diagram.fromBytes(bytes),
  "Diagram.toBytes": () => diagram.toBytes(),
  "Diagram.ids": () => diagram.ids(),
  "Diagram.sites": () => diagram.sites(),
  "Diagram.toJSON": () => diagram.toJSON(),
  "Diagram.findMany": () => diagram.findMany(points),
  "Diagram.kNearest": () => diagram.kNearest(0, 0, Infinity),
  "Diagram.within": () => diagram.within(0, 0, 1e6),
  "Diagram.kNearestMany": () => diagram.kNearestMany(points, 5, { distances: true }),
  "Diagram.withinMany": () => diagram.withinMany(points, 100),
  "Diagram.pick": () => diagram.pick(0, 0),
  "Diagram.pickMany": () => diagram.pickMany(points),
  "Diagram.search": () => diagram.search(-1e6, -1e6, 1e6, 1e6),
  "Diagram.neighbors": () => diagram.neighbors(hub),
  "Diagram.edges": () => diagram.edges({ clearance: true }),
  "Diagram.vertices": () => diagram.vertices(),
  "Diagram.triangulation": () => diagram.triangulation(),
  "Diagram.hull": () => diagram.hull(),
  "Diagram.render": () => diagram.render(ink),
  "Diagram.renderSites": () => diagram.renderSites(ink),
  "Diagram.renderHull": () => diagram.renderHull(ink),
  "Diagram.smallestEnclosingCircle": () => diagram.smallestEnclosingCircle(),
  "diagnostics.levels": () => levels(diagram),
  "diagnostics.validate": () => validate(diagram),
  "Voronoi.render": () => view.render(ink),
  "Voronoi.renderCell": () => view.renderCell(hub, ink),
  "Voronoi.renderCells": () => view.renderCells(),
  "Voronoi.cellPolygon": () => view.cellPolygon(hub),
  "Voronoi.cellPolygons": () => [...view.cellPolygons()],
  "Voronoi.cellParts": () => view.cellParts(hub),
  "Voronoi.cellCurves": () => view.cellCurves(hub),
  "Voronoi.cellCircle": () => view.cellCircle(hub),
  "Voronoi.cellCircles": () => view.cellCircles(),
  "Voronoi.cellCirclesAsync": () => view.cellCirclesAsync(),
  "Voronoi.emptyCircles": () => view.emptyCircles(3),
  "Voronoi.largestEmptyCircle": () => view.largestEmptyCircle({ inside: true }),
  "Voronoi.edgeCurves": () => view.edgeCurves(),
  "Voronoi.edges": () => view.edges({ clearance: true }),
  "Voronoi.vertices": () => view.vertices(),
  "Voronoi.toGeoJSON": () => view.toGeoJSON(),
  "Voronoi.neighbors": () => view.neighbors(hub),
  "Voronoi.cellArea": () => view.cellArea(hub),
  "Voronoi.cellCentroid": () => view.cellCentroid(hub),
  "Voronoi.cellPerimeter": () => view.cellPerimeter(hub),
  "Voronoi.cellMeasures": () => view.cellMeasures(hub),
  "Voronoi.cellGeometry": () => view.cellGeometry(hub),
  "Voronoi.cellMesh": () => view.cellMesh(),
  "Voronoi.cellAreas": () => view.cellAreas(),
  "Voronoi.fitAreas": () => view.fitAreas(targets),
  "Voronoi.fitAreasAsync": () => view.fitAreasAsync(targets),
  "Voronoi.interpolate": () => view.interpolate(targets, points),
  "Voronoi.interpolateAsync": () => view.interpolateAsync(targets, points),
  "Voronoi.cellCentroids": () => view.cellCentroids(),
  "Voronoi.cellPerimeters": () => view.cellPerimeters(),
};
/** The other calls need no memory, and are used as their test uses them; the last one is clear. */
const small = Object.fromEntries(
  calls
    .filter(([name]) => !(name in large))
    .sort(([name]) => (name === "Diagram.clear" ? 1 : -1))
    .map(([name, { use }]) => [name, () => use(diagram)]),
);

const grow = WebAssembly.Memory.prototype.grow;

/**
 * Diagrams of all sizes, down to empty ones, until none finds a place; and from now on the heap
 * cannot grow.
 */
function filled() {
  // after calls about as many points, the library gives back the blocks that it keeps for the next
  diagram.findMany(points);
  WebAssembly.Memory.prototype.grow = () => {
    throw new RangeError("no more memory");
  };
  const fillers = [];
  for (let count = kRing / 2; ; count >>= 2) {
    // fewer than the ring: the library keeps room for as many ids as it gave last
    try {
      for (;;) fillers.push(new Diagram(sites.subarray(0, 3 * count)));
    } catch {
      if (count === 0) return fillers;
    }
  }
}

function emptied(fillers) {
  WebAssembly.Memory.prototype.grow = grow;
  for (const filler of fillers) filler.dispose();
}

/** All that a failed call must not change, as one number. */
function state() {
  const { sites: pairs, vertices } = diagram.edges();
  let sum = diagram.size + 7 * diagram.visibleSize;
  const add = (value) => (sum = (Math.imul(sum, 31) + value) | 0);
  for (const array of [diagram.ids(), pairs, vertices, diagram.vertices().sites])
    array.forEach(add);
  for (const id of diagram.ids())
    for (const value of Object.values(diagram.site(id))) add(Math.round(1e6 * value));
  return sum;
}

async function attempt(call) {
  const before = state();
  const fillers = filled();
  let code = "none";
  try {
    await call();
  } catch (error) {
    code = error.code ?? String(error);
  }
  emptied(fillers);
  return { code, isSame: state() === before };
}

/** The first call of each part: once in a full heap, and again when there is room. */
const firstCalls = { shapes: () => view.contains(hub, 0, 0), sphere: () => new SphericalDiagram() };
const parts = {};
for (const [part, call] of Object.entries(firstCalls)) {
  const { code } = await attempt(call);
  call();
  parts[part] = code;
}
const results = {};
for (const [name, call] of Object.entries({ ...large, ...small }))
  results[name] = { isLarge: name in large, ...(await attempt(call)) };
console.log(JSON.stringify({ parts, results, afterClear: diagram.size }));
