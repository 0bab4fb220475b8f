// The calls to which the reference gives a cost, each with a use of it that is timed, and with what
// the reference promises for that use. Costs are in units that cancel when two sizes are compared.
// A use gets a surface (js/growth.mjs).
import { sharesOf } from "./shares.mjs";

const kTimes = 2000; // calls in one use, where a call takes less than a microsecond

const meanOf = (list, cost) => list.reduce((sum, item) => sum + cost(item), 0) / list.length;
const sorted = (m) => m * Math.log2(1 + m);

// --- What the reference promises -----------------------------------------------------------------

const one = { text: "O(1)", of: () => 1 };
const location = { text: "O(log n)", of: ({ n }) => Math.log2(n) };
const linear = { text: "O(n)", of: ({ n }) => n };
const linearithmic = { text: "O(n log n)", of: ({ n }) => sorted(n) };
const hull = { text: "O(hull)", of: ({ diagram }) => diagram.hull().length };
const degree = { text: "O(d)", of: ({ degrees }) => meanOf(degrees, (d) => 1 + d) };
const degreeSorted = {
  text: "O(d log d)",
  of: ({ degrees }) => meanOf(degrees, (d) => 1 + sorted(d)),
};
const change = {
  text: "O(log n + d)",
  of: ({ n, moved }) => Math.log2(n) + meanOf(moved.degrees, (d) => d),
};
/** A new point on a circle of sites takes a part of all their cells. */
const interpolation = {
  text: "O(log n + d)",
  of: (surface) => {
    const sharers = ([x, y]) => surface.view.naturalWeights(x, y)?.ids.length ?? 0;
    return Math.log2(surface.n) + meanOf(placesOf(surface), sharers);
  },
};
const removal = {
  text: "O(log n + d log d)",
  of: ({ n, moved }) => Math.log2(n) + meanOf(moved.degrees, sorted),
};
/** `found(surface, x, y)` are the sites that are looked at. */
const nearby = (found) => ({
  text: "O(log n + m log m)",
  of: (surface) => {
    const { n, diagram } = surface;
    const neighbours = ([x, y]) =>
      found(diagram, x, y).reduce((sum, id) => sum + diagram.neighbors(id).length, 0);
    return Math.log2(n) + meanOf(placesOf(surface), (place) => sorted(neighbours(place)));
  },
});
const nearest = nearby((diagram, x, y) => diagram.kNearest(x, y, 10));
const containing = nearby((diagram, x, y) => diagram.within(x, y, 0));
const searched = {
  text: "O(log n + m log m)",
  of: (surface) =>
    Math.log2(surface.n) + sorted(surface.diagram.search(...quarterOf(surface)).length),
};
/** Degrees of the cells that are asked for, and the points of their polygons. */
const degreeAndPoints = {
  text: "O(d + points)",
  of: ({ view, ids, degrees }) =>
    meanOf(degrees, (d) => d) + meanOf(ids, (id) => view.cellPolygon(id).length),
};
const allPoints = {
  text: "O(n + points)",
  of: ({ n, view }) => Array.from(view.cellPolygons()).reduce((sum, ring) => sum + ring.length, n),
};
/** Cells in a star of n points: with the points that are in them. */
const starCells = {
  text: "O(d + points)",
  of: ({ ids, degrees, starPoints }) =>
    meanOf(degrees, (d) => 1 + d) + meanOf(ids, (id) => starPoints[id]),
};
const starCellsSorted = {
  text: "O(d log d)",
  of: ({ ids, degrees, starPoints }) =>
    meanOf([...ids.keys()], (k) => 1 + sorted(degrees[k] + starPoints[ids[k]])),
};

// --- Uses ----------------------------------------------------------------------------------------

const placesOf = ({ places }) =>
  Array.from({ length: places.length / 2 }, (_, k) => places.subarray(2 * k, 2 * k + 2));

/** A rectangle with a quarter of the sites' box. */
const quarterOf = ({ box: [xmin, ymin, xmax, ymax] }) => [
  (3 * xmin + xmax) / 4,
  (3 * ymin + ymax) / 4,
  (xmin + 3 * xmax) / 4,
  (ymin + 3 * ymax) / 4,
];

const often = (call) => (surface) => {
  for (let k = 0; k < kTimes; ++k) call(surface);
};
const atPlaces = (call) => (surface) => {
  const { places } = surface;
  for (let k = 0; k < places.length; k += 2) call(surface, places[k], places[k + 1]);
};
const forCells = (call) => (surface) => {
  for (const id of surface.ids) call(surface, id);
};
const inView = (name, ...args) => forCells(({ view }, id) => view[name](id, ...args));
const inStar = (name, ...args) => forCells(({ star }, id) => star[name](id, ...args));

const kInk = { moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} };

const takeOut = ({ diagram, moved }) => diagram.removeMany(moved.ids);
const putBack = ({ diagram, moved }) => {
  moved.ids = diagram.insertMany(moved.xyr);
};
/** Changes the diagram, as little as that can be. */
const touch = ({ diagram, sites, box, moved }) => {
  moved.isAside = !moved.isAside;
  const aside = moved.isAside ? 1e-9 * (box[2] - box[0]) : 0;
  diagram.update(0, sites[0] + aside, sites[1], sites[2]);
};
/** Disposes of the object that the use made. */
const forget = (surface) => {
  surface.made?.dispose();
  surface.made = undefined;
};
const making = (make) => (surface) => {
  surface.made = make(surface);
};
/** A diagram that the use may spoil. */
const copied = (surface) => {
  forget(surface);
  surface.made = surface.make(surface.sites);
};

const isEven = { filter: (id) => id % 2 === 0 };

/** Calls of both surfaces: their names after the dot, their costs, and their uses. */
const diagramCalls = {
  sites: [linear, ({ diagram }) => diagram.sites()],
  "[Symbol.iterator]": [linear, ({ diagram }) => [...diagram]],
  remove: [
    removal,
    ({ diagram, moved }) => moved.ids.forEach((id) => diagram.remove(id)),
    { after: putBack },
  ],
  removeMany: [removal, takeOut, { after: putBack }],
  clear: [linear, ({ made }) => made.clear(), { before: copied, after: forget }],
  size: [one, often(({ diagram }) => diagram.size)],
  visibleSize: [one, often(({ diagram }) => diagram.visibleSize)],
  hiddenSize: [one, often(({ diagram }) => diagram.hiddenSize)],
  has: [one, often(({ diagram }) => diagram.has(7))],
  ids: [linear, ({ diagram }) => diagram.ids()],
  isHidden: [one, often(({ diagram }) => diagram.isHidden(7))],
  site: [one, often(({ diagram }) => diagram.site(7))],
  coverOf: [location, ({ diagram, moved }) => moved.ids.forEach((id) => diagram.coverOf(id))],
  insert: [
    change,
    ({ diagram, moved: { ids, xyr } }) => {
      for (let k = 0; k < ids.length; ++k)
        ids[k] = diagram.insert(xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]);
    },
    { before: takeOut },
  ],
  insertMany: [location, putBack, { before: takeOut }],
  update: [
    removal,
    ({ diagram, moved: { ids, xyr } }) => {
      // Each to the place of the next, which has left by then.
      const half = ids.length / 2;
      for (let k = 0; k < half; ++k) {
        const to = 3 * (half + k);
        diagram.update(ids[k], xyr[to], xyr[to + 1], xyr[to + 2]);
      }
    },
    {
      before: ({ diagram, moved }) => {
        diagram.removeMany(moved.ids.subarray(moved.ids.length / 2));
      },
      after: (surface) => {
        const { diagram, moved } = surface;
        diagram.removeMany(moved.ids.subarray(0, moved.ids.length / 2));
        putBack(surface);
      },
    },
  ],
  updateMany: [
    linearithmic,
    ({ diagram, all, steps }) => diagram.updateMany(all, steps),
    {
      // All by a thousandth of their distance, and back.
      before: (surface) => {
        const { sites, n, box } = surface;
        const step = (box[2] - box[0]) / Math.sqrt(n) / 3000;
        surface.steps ??= sites.map((value, k) =>
          k % 3 === 0 ? value + step * ((k % 7) - 3) : value,
        );
      },
      after: ({ diagram, all, sites }) => diagram.updateMany(all, sites),
    },
  ],
  find: [location, atPlaces(({ diagram }, x, y) => diagram.find(x, y))],
  "find(filter)": [nearest, atPlaces(({ diagram }, x, y) => diagram.find(x, y, isEven))],
  nearest: [location, atPlaces(({ diagram }, x, y) => diagram.nearest(x, y))],
  findMany: [location, ({ diagram, places }) => diagram.findMany(places)],
  "findMany(filter)": [nearest, ({ diagram, places }) => diagram.findMany(places, isEven)],
  nearestMany: [location, ({ diagram, places }) => diagram.nearestMany(places)],
  kNearest: [nearest, atPlaces(({ diagram }, x, y) => diagram.kNearest(x, y, 10))],
  kNearestMany: [nearest, ({ diagram, places }) => diagram.kNearestMany(places, 10)],
  within: [containing, atPlaces(({ diagram }, x, y) => diagram.within(x, y, 0))],
  withinMany: [containing, ({ diagram, places }) => diagram.withinMany(places, 0)],
  pick: [containing, atPlaces(({ diagram }, x, y) => diagram.pick(x, y))],
  pickMany: [containing, ({ diagram, places }) => diagram.pickMany(places)],
  "farthest(filter)": [linearithmic, ({ diagram }) => diagram.farthest(0, 0, isEven)],
  vertices: [linear, ({ diagram }) => diagram.vertices()],
  triangulation: [linear, ({ diagram }) => diagram.triangulation()],
  neighbors: [degree, forCells(({ diagram }, id) => diagram.neighbors(id))],
  voronoi: [one, often(({ diagram }) => diagram.voronoi())],
  edges: [linear, ({ diagram }) => diagram.edges()],
  toBytes: [linear, ({ diagram }) => diagram.toBytes()],
  toJSON: [linear, ({ diagram }) => diagram.toJSON()],
  toString: [one, often(({ diagram }) => diagram.toString())],
  dispose: [one, ({ made }) => made.dispose(), { before: copied, after: forget }],
};

const planeDiagramCalls = {
  search: [searched, (surface) => surface.diagram.search(...quarterOf(surface))],
  farthest: [hull, atPlaces(({ diagram }, x, y) => diagram.farthest(x, y))],
  hull: [hull, ({ diagram }) => diagram.hull()],
  "voronoi(region)": [linearithmic, (s) => s.diagram.voronoi(s.starRings).dispose()],
  "edges(clearance)": [linear, ({ diagram }) => diagram.edges({ clearance: true })],
  render: [linear, ({ diagram }) => diagram.render(kInk)],
  renderSites: [linear, ({ diagram }) => diagram.renderSites(kInk)],
  renderHull: [hull, ({ diagram }) => diagram.renderHull(kInk)],
  smallestEnclosingCircle: [hull, ({ diagram }) => diagram.smallestEnclosingCircle()],
};

const globeDiagramCalls = {
  farthest: [location, atPlaces(({ diagram }, x, y) => diagram.farthest(x, y))],
};

/** Constructor and static calls. */
const classCalls = {
  constructor: [linearithmic, making(({ make, sites }) => make(sites)), { after: forget }],
  from: [
    linearithmic,
    making(({ Class, rows }) => Class.from(rows)),
    { before: (surface) => (surface.rows ??= surface.diagram.toJSON()), after: forget },
  ],
  "fromBytes(trusted)": [
    linear,
    making(({ Class, bytes }) => Class.fromBytes(bytes, { trusted: true })),
    { before: (surface) => (surface.bytes = surface.diagram.toBytes()), after: forget },
  ],
  fromBytes: [
    linearithmic,
    making(({ Class, bytes }) => Class.fromBytes(bytes)),
    { before: (surface) => (surface.bytes = surface.diagram.toBytes()), after: forget },
  ],
};

const planeFunctions = {
  enclose: [
    linearithmic,
    ({ enclose, rows }) => enclose(rows),
    { before: (surface) => (surface.rows ??= surface.diagram.toJSON()) },
  ],
};

const slowPlaneCalls = {
  fitAreas: [
    linearithmic,
    ({ made, box, targets }) => made.voronoi(box).fitAreas(targets),
    {
      before: (surface) => {
        copied(surface);
        surface.targets ??= sharesOf(surface.n, false);
      },
      after: forget,
    },
  ],
};

const viewCalls = {
  neighbors: [degreeSorted, inView("neighbors")],
  vertices: [linear, ({ view }) => view.vertices()],
  edges: [linear, ({ view }) => view.edges()],
  contains: [location, atPlaces(({ view, ids }, x, y) => view.contains(ids[0], x, y))],
  cellAreas: [linear, ({ view }) => view.cellAreas()],
  cellCentroids: [linear, ({ view }) => view.cellCentroids()],
  cellPerimeters: [linear, ({ view }) => view.cellPerimeters()],
  largestEmptyCircle: [linearithmic, ({ view }) => view.largestEmptyCircle()],
  emptyCircles: [linearithmic, ({ view }) => view.emptyCircles(10)],
  naturalWeights: [interpolation, atPlaces(({ view }, x, y) => view.naturalWeights(x, y))],
  interpolate: [interpolation, ({ view, values, places }) => view.interpolate(values, places)],
};

const planeViewCalls = {
  render: [linear, ({ view }) => view.render(kInk)],
  renderBounds: [one, often(({ view }) => view.renderBounds(kInk))],
  renderCell: [degreeSorted, inView("renderCell", kInk)],
  renderCells: [linear, ({ view }) => view.renderCells(kInk, () => {})],
  cellPolygon: [degreeSorted, inView("cellPolygon")],
  cellParts: [degreeSorted, inView("cellParts")],
  cellGeometry: [degreeSorted, inView("cellGeometry")],
  cellPolygons: [linearithmic, ({ view }) => Array.from(view.cellPolygons())],
  cellCurves: [degreeSorted, inView("cellCurves")],
  edgeCurves: [linear, ({ view }) => view.edgeCurves()],
  cellMesh: [linearithmic, ({ view }) => view.cellMesh()],
  toGeoJSON: [linearithmic, ({ view }) => view.toGeoJSON()],
  "largestEmptyCircle(inside)": [
    linearithmic,
    ({ view }) => view.largestEmptyCircle({ inside: true }),
  ],
  "emptyCircles(inside)": [linearithmic, ({ view }) => view.emptyCircles(10, { inside: true })],
  cellCircle: [degreeSorted, inView("cellCircle")],
  cellCircles: [linearithmic, ({ view }) => view.cellCircles()],
  "cellCircle(aspect)": [degreeSorted, inView("cellCircle", { aspect: 4 })],
  cellArea: [degreeSorted, inView("cellArea")],
  cellCentroid: [degreeSorted, inView("cellCentroid")],
  cellPerimeter: [degreeSorted, inView("cellPerimeter")],
  cellMeasures: [degreeSorted, inView("cellMeasures")],
  // In a star of as many points as there are sites.
  "cellAreas@star,first": [linearithmic, ({ star }) => star.cellAreas(), { before: touch }],
  "cellAreas@star": [linear, ({ star }) => star.cellAreas()],
  "toGeoJSON@star": [linearithmic, ({ star }) => star.toGeoJSON()],
  "cellArea@star": [starCells, inStar("cellArea")],
  "cellPolygon@star": [starCellsSorted, inStar("cellPolygon")],
  "cellCircle@star": [starCellsSorted, inStar("cellCircle")],
  "cellCircles@star": [linearithmic, ({ star }) => star.cellCircles()],
  "emptyCircles@star": [linearithmic, ({ star }) => star.emptyCircles(10)],
  "emptyCircles(inside)@star": [
    linearithmic,
    ({ star }) => star.emptyCircles(10, { inside: true }),
  ],
};

/** A millisecond a cell. */
const slowGlobeCalls = {
  cellCircle: [degree, inView("cellCircle")],
  cellCircles: [linear, ({ view }) => view.cellCircles()],
};

const globeViewCalls = {
  cellPolygon: [degreeAndPoints, inView("cellPolygon")],
  cellPolygons: [allPoints, ({ view }) => Array.from(view.cellPolygons())],
  cellGeometry: [degreeAndPoints, inView("cellGeometry")],
  cellMesh: [allPoints, ({ view }) => view.cellMesh()],
  toGeoJSON: [allPoints, ({ view }) => view.toGeoJSON()],
  cellArea: [degree, inView("cellArea")],
  cellCentroid: [degree, inView("cellCentroid")],
  cellPerimeter: [degree, inView("cellPerimeter")],
  cellMeasures: [degree, inView("cellMeasures")],
};

const named = (prefix, surface, ...groups) =>
  groups.flatMap((group) =>
    Object.entries(group).map(([name, [cost, use, around = {}]]) => ({
      name: prefix && !name.startsWith("[") ? `${prefix}.${name}` : `${prefix}${name}`,
      surface,
      cost,
      use,
      ...around,
    })),
  );

/** Calls that are timed on many sites. */
export const callsOfDiagrams = [
  ...named("", "plane", planeFunctions),
  ...named("Diagram", "plane", classCalls),
  ...named("diagram", "plane", diagramCalls, planeDiagramCalls),
  ...named("SphericalDiagram", "globe", classCalls),
  ...named("sphericalDiagram", "globe", diagramCalls, globeDiagramCalls),
];
/** Calls that are timed on fewer sites. */
export const callsOfViews = [
  ...named("voronoi", "plane", viewCalls, planeViewCalls),
  ...named("sphericalVoronoi", "globe", viewCalls, globeViewCalls),
];
/** Calls that are timed on the fewest sites. */
export const slowCalls = [
  ...named("voronoi", "plane", slowPlaneCalls),
  ...named("sphericalVoronoi", "globe", slowGlobeCalls),
];

/** Calls that are timed in windows of more and more points, or on sites around a large one. */
export const callsOfWindows = named("voronoi", "window", {
  "cellCircle:window": [linearithmic, ({ view }) => view.cellCircle(0)],
  "largestEmptyCircle(inside):window": [
    linearithmic,
    ({ view }) => view.largestEmptyCircle({ inside: true }),
  ],
  "emptyCircles(inside):window": [
    linearithmic,
    ({ view }) => view.emptyCircles(10, { inside: true }),
  ],
});

/** Leaves in groups of 5 to 12 and in groups of those, and all leaves in one group. */
export const callsOfTrees = named("treemap", "tree", {
  groups: [linear, ({ layout, groups }) => layout(groups)],
  flat: [linearithmic, ({ layout, flat }) => layout(flat)],
});
