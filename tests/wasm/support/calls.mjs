// Every public call of Diagram and Voronoi, and those of diagnostics: one use of it that works, and
// what it refuses with which code and words. Tests check that nothing is missing here, neither a
// member of the classes nor a code that the documentation names.
import { Diagram } from "../../../build/packed/consumer.mjs";
import { levels, validate } from "../../../build/packed/diagnostics.mjs";
import {
  NONE,
  aspects,
  searchedBy,
  bounds,
  edgesBy,
  inWindow,
  fitBy,
  number,
  wholeNumber,
  id,
  numbers,
  tooMany,
  window,
  tolerance,
  digits,
  unknownOption,
  polygons,
  fitting,
  interpolateBy,
  interpolating,
  drawing,
  flat,
  works,
  ofSite,
  drawn,
  ofCell,
} from "./refusals.mjs";

const kInk = { moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} };

export const diagramCalls = {
  constructor: {
    use: () => new Diagram([1, 2, 3]),
    refuses: [
      ...numbers("xyr", 3, (_d, xyr) => new Diagram(xyr)),
      ...tooMany("xyr", 3, (_d, xyr) => new Diagram(xyr)),
      ["not-finite", () => new Diagram([], { r: "1" }), 'options.r is the string "1"'],
      ["out-of-range", () => new Diagram([0, 0], { r: 1e101 }), "options.r is 1e+101"],
      ["bad-length", () => new Diagram([0, 0, 1], { r: 1 }), "a multiple of 2 values in xy, got 3"],
      [
        "bad-option",
        () => new Diagram([], { radius: 5 }),
        "options.radius is unknown, expected { r }",
      ],
      ["not-finite", () => new Diagram([[0, 0, 1]]), "Diagram.from(rows) reads rows"],
      ["not-finite", () => new Diagram([{ x: 1 }, {}, {}]), "Diagram.from(rows) reads rows"],
    ],
  },
  from: {
    use: () => Diagram.from([[1, 2, 3]]),
    refuses: [
      ...["x", "y", "r"].flatMap((name) =>
        number(`${name} of item 1`, (_d, value) =>
          Diagram.from([[1, 2], { x: 1, y: 2, [name]: value }]),
        ),
      ),
      ...tooMany("items", 1, (_d, items) => Diagram.from(items)),
      ["bad-length", () => Diagram.from(7), "items is 7"],
      ["bad-option", () => Diagram.from([], 7), "x is 7"],
      [
        "bad-option",
        () =>
          Diagram.from(
            [[1, 2]],
            () => 1,
            {},
            () => 1,
          ),
        "not last",
      ],
      [
        "bad-option",
        () => Diagram.from([], ...Array(3).fill(() => 1), { r: 1 }),
        "an accessor of it",
      ],
      ["not-finite", () => Diagram.from([0, 1, NaN]), "xyr[2] is NaN"],
      ["bad-length", () => Diagram.from([0, 1, 2, 3]), "a multiple of 3 values in xyr, got 4"],
      ["bad-option", () => Diagram.from([{ x: 1, y: 2, radius: 5 }]), "(d) => d.radius"],
      ["bad-option", () => Diagram.from([{ x: 1, y: 2, size: 5 }]), "(d) => d.size"],
      ["bad-option", () => Diagram.from([{ x: 1, y: 2, weight: 5 }]), "(d) => d.weight"],
      ["not-finite", () => Diagram.from([{ x: 1, y: 2, r: null }]), "r of item 0 is null"],
      ["not-finite", () => Diagram.from([[1, 2], null]), "item 1 is null, expected {x, y, r}"],
    ],
  },
  fromBytes: {
    use: (d) => Diagram.fromBytes(d.toBytes()),
    refuses: [
      ["corrupt-snapshot", () => Diagram.fromBytes(new Uint8Array(56)), "bytes are no snapshot"],
      [
        "corrupt-snapshot",
        (d) => Diagram.fromBytes(d.toBytes().subarray(8)),
        "bytes are no snapshot",
      ],
      [
        "bad-length",
        () => Diagram.fromBytes([1, 2, 3]),
        "bytes is an array of 3, expected a Uint8Array",
      ],
      ["bad-length", () => Diagram.fromBytes(new Uint8ClampedArray(8)), "expected a Uint8Array"],
      [
        "bad-option",
        (d) => Diagram.fromBytes(d.toBytes(), { location: "walk" }),
        "expected { trust",
      ],
      [
        "bad-option",
        (d) => Diagram.fromBytes(d.toBytes(), { trusted: 1 }),
        "options.trusted is 1, expected false or",
      ],
    ],
  },
  insert: {
    use: (d) => d.insert(1, 2, 3),
    refuses: [
      ...number("x", (d, x) => d.insert(x, 0, 1)),
      ...number("y", (d, y) => d.insert(0, y)),
      ...number("r", (d, r) => d.insert(0, 0, r)),
    ],
  },
  insertMany: {
    use: (d) => d.insertMany([1, 2, 3]),
    refuses: [
      ...numbers("xyr", 3, (d, xyr) => d.insertMany(xyr)),
      ...tooMany("xyr", 3, (d, xyr) => d.insertMany(xyr)),
      ...numbers("xy", 2, (d, xy) => d.insertMany(xy, { r: 1 })),
      ["bad-option", (d) => d.insertMany([], { radius: 1 }), "options.radius is unknown"],
    ],
  },
  remove: { use: (d) => d.remove(0), refuses: wholeNumber((d, site) => d.remove(site)) },
  removeMany: {
    use: (d) => d.removeMany([0]),
    refuses: [
      ["bad-length", (d) => d.removeMany(7), "ids is 7"],
      ["unknown-site", (d) => d.removeMany([0, "1"]), 'ids[1]: site the string "1" does not'],
      ...wholeNumber((d, site) => d.removeMany([0, site])),
    ],
  },
  update: {
    use: (d) => d.update(0, 1, 2, 3),
    refuses: [
      ...id((d, site) => d.update(site, 1, 2, 3)),
      ...id((d, site) => d.update(site, 1, 2)),
      ...number("x", (d, x) => d.update(0, x, 0)),
      ...number("y", (d, y) => d.update(0, 0, y, 1)),
      ...number("r", (d, r) => d.update(0, 0, 0, r)),
    ],
  },
  updateMany: {
    use: (d) => d.updateMany([0], [1, 2, 3]),
    refuses: [
      ...numbers("xyr", 3, (d, xyr) => d.updateMany([0, 1], xyr)),
      [
        "bad-length",
        (d) => d.updateMany([0], [1, 2, 3, 4, 5, 6]),
        "expected 3 values in xyr for 1 ids, got 6",
      ],
      ["bad-length", (d) => d.updateMany(7, []), "ids is 7"],
      ["not-finite", (d) => d.updateMany([0], [1, NaN], { r: "keep" }), "xy[1] is NaN"],
      ["bad-option", (d) => d.updateMany([0], [1, 2], { radius: 1 }), "options.radius is unknown"],
      [
        "unknown-site",
        (d) => d.updateMany([0, NONE], [1, 2, 3, 4, 5, 6]),
        "ids[1]: site 1000 does not exist",
      ],
      ...wholeNumber((d, site) => d.updateMany([0, site], [1, 2, 3, 4, 5, 6])),
    ],
  },
  clear: works((d) => d.clear()),
  size: works((d) => d.size),
  visibleSize: works((d) => d.visibleSize),
  hiddenSize: works((d) => d.hiddenSize),
  has: { use: (d) => d.has(0), refuses: wholeNumber((d, site) => d.has(site)) },
  site: ofSite("site"),
  ids: works((d) => d.ids()),
  sites: works((d) => d.sites()),
  isHidden: ofSite("isHidden"),
  coverOf: ofSite("coverOf"),
  find: {
    use: (d) => d.find(0, 0),
    refuses: [
      ...number("x", (d, x) => d.find(x, 0)),
      ...number("y", (d, y) => d.find(0, y)),
      ...number("options.maxDistance", (d, maxDistance) => d.find(0, 0, { maxDistance })),
      ["bad-option", (d) => d.find(0, 0, { filter: 7 }), "options.filter is 7"],
    ],
  },
  nearest: {
    use: (d) => d.nearest(0, 0),
    refuses: [
      ...number("x", (d, x) => d.nearest(x, 0)),
      ...number("y", (d, y) => d.nearest(0, y)),
      ["bad-option", (d) => d.nearest(0, 0, { filter: 7 }), "options.filter is 7"],
    ],
  },
  farthest: {
    use: (d) => d.farthest(0, 0),
    refuses: [
      ...number("x", (d, x) => d.farthest(x, 0)),
      ...number("y", (d, y) => d.farthest(0, y)),
      ["bad-option", (d) => d.farthest(0, 0, { maxDistance: 1 }), "options.maxDistance is unknown"],
      ["bad-option", (d) => d.farthest(0, 0, { filter: 7 }), "options.filter is 7"],
    ],
  },
  findMany: {
    use: (d) => d.findMany([0, 0]),
    refuses: [
      ...numbers("xy", 2, (d, xy) => d.findMany(xy)),
      ...number("options.maxDistance", (d, maxDistance) => d.findMany([0, 0], { maxDistance })),
      ["bad-option", (d) => d.findMany([0, 0], new Float64Array(1)), "options is Float64Array(1)"],
      ["bad-option", (d) => d.findMany([0, 0], { filter: 7 }), "options.filter is 7"],
    ],
  },
  nearestMany: {
    use: (d) => d.nearestMany([0, 0]),
    refuses: [
      ...numbers("xy", 2, (d, xy) => d.nearestMany(xy)),
      ...number("options.maxDistance", (d, maxDistance) => d.nearestMany([0, 0], { maxDistance })),
      ["bad-option", (d) => d.nearestMany([0, 0], { top: "last" }), "options.top is unknown"],
    ],
  },
  kNearest: {
    use: (d) => d.kNearest(0, 0, 1),
    refuses: [
      ...number("x", (d, x) => d.kNearest(x, 0, 1)),
      ...number("y", (d, y) => d.kNearest(0, y, 1)),
      ["not-finite", (d) => d.kNearest(0, 0), "k is undefined"],
      ["out-of-range", (d) => d.kNearest(0, 0, 0.5), "k is 0.5"],
      ...number("options.maxDistance", (d, maxDistance) => d.kNearest(0, 0, 1, { maxDistance })),
      ["bad-option", (d) => d.kNearest(0, 0, 1, { filter: 7 }), "options.filter is 7"],
    ],
  },
  kNearestMany: {
    use: (d) => d.kNearestMany([0, 0], 1),
    refuses: [
      ...numbers("xy", 2, (d, xy) => d.kNearestMany(xy, 1)),
      ["not-finite", (d) => d.kNearestMany([0, 0]), "k is undefined"],
      ...number("options.maxDistance", (d, maxDistance) =>
        d.kNearestMany([0, 0], 1, { maxDistance }),
      ),
      ["bad-option", (d) => d.kNearestMany([0, 0], 1, { filter: 7 }), "options.filter is 7"],
      ["bad-option", (d) => d.kNearestMany([0, 0], 1, { distances: 7 }), "options.distances is 7"],
      ["bad-option", (d) => d.kNearestMany([0, 0], 1, { distance: true }), "options.distance"],
    ],
  },
  withinMany: {
    use: (d) => d.withinMany([0, 0], 1),
    refuses: [
      ...numbers("xy", 2, (d, xy) => d.withinMany(xy, 1)),
      ...number("maxDistance", (d, distance) => d.withinMany([0, 0], distance)),
      ["bad-option", (d) => d.withinMany([0, 0], 1, { filter: 7 }), "options.filter is 7"],
      ["bad-option", (d) => d.withinMany([0, 0], 1, { maxDistance: 7 }), "options.maxDistance is"],
    ],
  },
  within: {
    use: (d) => d.within(0, 0, 1),
    refuses: [
      ...number("x", (d, x) => d.within(x, 0, 1)),
      ...number("y", (d, y) => d.within(0, y, 1)),
      ...number("maxDistance", (d, distance) => d.within(0, 0, distance)),
      ["not-finite", (d) => d.within(0, 0, -Infinity), "maxDistance is -Infinity"],
      ["bad-option", (d) => d.within(0, 0, 1, { filter: [] }), "options.filter is an array of 0"],
    ],
  },
  pick: {
    use: (d) => d.pick(0, 0),
    refuses: [
      ...number("x", (d, x) => d.pick(x, 0)),
      ...number("y", (d, y) => d.pick(0, y)),
      ...number("options.maxDistance", (d, maxDistance) => d.pick(0, 0, { maxDistance })),
      ["out-of-range", (d) => d.pick(0, 0, { maxDistance: -1 }), "options.maxDistance is -1"],
      [
        "bad-option",
        (d) => d.pick(0, 0, 20),
        "options is 20, expected { maxDistance, top, filter }",
      ],
      ["bad-option", (d) => d.pick(0, 0, { top: "first" }), 'options.top is the string "first"'],
      ["bad-option", (d) => d.pick(0, 0, { filter: 7 }), "options.filter is 7"],
    ],
  },
  pickMany: {
    use: (d) => d.pickMany([0, 0]),
    refuses: [
      ...numbers("xy", 2, (d, xy) => d.pickMany(xy)),
      ...number("options.maxDistance", (d, maxDistance) => d.pickMany([0, 0], { maxDistance })),
      ["out-of-range", (d) => d.pickMany([0, 0], { maxDistance: -1 }), "options.maxDistance is -1"],
      ["bad-option", (d) => d.pickMany([0, 0], { filter: 7 }), "options.filter is 7"],
    ],
  },
  search: {
    use: (d) => d.search(0, 0, 1, 1),
    refuses: [
      ["bad-bounds", (d) => d.search(0, 0, 1), "ymax of bounds is undefined"],
      // without a limit on the wrong side
      ["bad-bounds", (d) => d.search(Infinity, 0, Infinity, 1), "xmin of bounds is Infinity"],
      ["bad-bounds", (d) => d.search(0, Infinity, 1, Infinity), "ymin of bounds is Infinity"],
      ["bad-bounds", (d) => d.search(-Infinity, 0, -Infinity, 1), "xmax of bounds is -Infinity"],
      ["bad-bounds", (d) => d.search(0, -Infinity, 1, -Infinity), "ymax of bounds is -Infinity"],
      ["bad-bounds", (d) => d.search(0, 2, 1, 1), "bounds are [0, 2, 1, 1], expected xmin <= xmax"],
      ["bad-option", (d) => d.search(0, 0, 1, 1, { filter: 7 }), "options.filter is 7"],
    ],
  },
  neighbors: ofSite("neighbors"),
  edges: edgesBy((d, options) => d.edges(options)),
  vertices: works((d) => d.vertices()),
  voronoi: {
    use: (d) => d.voronoi(),
    refuses: [
      ...window((d, box) => d.voronoi(box)),
      ...number("options.maxDistance", (d, maxDistance) => d.voronoi(bounds, { maxDistance })),
      [
        "bad-bounds",
        (d) => d.voronoi({ x: 0, y: 0, r: 0 }),
        "r of the disc is 0, expected a number",
      ],
      ["bad-bounds", (d) => d.voronoi({ x: 0, y: 0, r: "1" }), 'r of the disc is the string "1"'],
      ["bad-bounds", (d) => d.voronoi({ x: 0, r: 1 }), "y of the disc is undefined"],
      ["bad-option", (d) => d.voronoi(bounds, { project: 7 }), "options.project is 7, expected"],
      ["bad-option", (d) => d.voronoi(bounds, { reach: 7 }), "options.reach is unknown"],
    ],
  },
  triangulation: works((d) => d.triangulation()),
  hull: works((d) => d.hull()),
  render: {
    use: (d) => d.render(),
    refuses: [
      ...drawing(
        (d, options) => d.render(null, options),
        (d, context) => d.render(context),
      ),
      ...window((d, box) => d.render(null, { bounds: box })),
    ],
  },
  renderSites: drawn("renderSites"),
  renderHull: drawn("renderHull"),
  smallestEnclosingCircle: works((d) => d.smallestEnclosingCircle()),
  toBytes: works((d) => d.toBytes()),
  toJSON: works((d) => d.toJSON()),
};

export const voronoiCalls = {
  render: {
    use: inWindow((v) => v.render()),
    refuses: drawing(
      inWindow((v, options) => v.render(null, options)),
      inWindow((v, context) => v.render(context)),
    ),
  },
  renderBounds: {
    use: inWindow((v) => v.renderBounds()),
    refuses: flat(
      inWindow((v, options) => v.renderBounds(null, options)),
      inWindow((v, context) => v.renderBounds(context)),
    ),
  },
  renderCell: {
    use: inWindow((v) => v.renderCell(0)),
    refuses: [
      ...id(inWindow((v, site) => v.renderCell(site))),
      ...drawing(
        inWindow((v, options) => v.renderCell(0, null, options)),
        inWindow((v, context) => v.renderCell(0, context)),
      ),
    ],
  },
  renderCells: {
    use: inWindow((v) => v.renderCells()),
    refuses: [
      ...[tolerance, digits, unknownOption].flatMap((wrong) =>
        wrong(inWindow((v, options) => v.renderCells(null, options))),
      ),
      ["bad-option", inWindow((v) => v.renderCells({}, () => {})), "context is an object without"],
      ["bad-option", inWindow((v) => v.renderCells(kInk, 7)), "each is 7, expected a function"],
    ],
  },
  ...Object.fromEntries(
    ["cellPolygon", "cellParts"].map((name) => [
      name,
      {
        use: inWindow((v) => v[name](0)),
        refuses: [
          ...id(inWindow((v, site) => v[name](site))),
          ...polygons(inWindow((v, options) => v[name](0, options))),
        ],
      },
    ]),
  ),
  cellPolygons: {
    use: inWindow((v) => [...v.cellPolygons()]),
    refuses: polygons(inWindow((v, options) => [...v.cellPolygons(options)])),
  },
  cellCurves: ofCell("cellCurves"),
  edgeCurves: works(inWindow((v) => v.edgeCurves())),
  edges: edgesBy(inWindow((v, options) => v.edges(options))),
  vertices: works(inWindow((v) => v.vertices())),
  toGeoJSON: {
    use: inWindow((v) => v.toGeoJSON()),
    refuses: [
      ...[tolerance, unknownOption].flatMap((wrong) =>
        wrong(inWindow((v, options) => v.toGeoJSON(options))),
      ),
      [
        "bad-option",
        inWindow((v) => v.toGeoJSON({ properties: { a: 1 } })),
        "options.properties is an object, expected a function of an id",
      ],
      [
        "bad-option",
        inWindow((v) => v.toGeoJSON({ group: "team" })),
        'options.group is the string "team", expected a function of an id',
      ],
      [
        "bad-option",
        inWindow((v) => v.toGeoJSON({ group: () => 1, properties: {} })),
        "options.properties is an object, expected a function of a key",
      ],
      [
        "bad-option",
        inWindow((v) => v.toGeoJSON({ winding: "cw" })),
        'options.winding is the string "cw", expected "counter-clockwise" or "clockwise"',
      ],
    ],
  },
  cellGeometry: {
    use: inWindow((v) => v.cellGeometry(0)),
    refuses: [
      ...id(inWindow((v, site) => v.cellGeometry(site))),
      ...[tolerance, unknownOption].flatMap((wrong) =>
        wrong(inWindow((v, options) => v.cellGeometry(0, options))),
      ),
      [
        "bad-option",
        inWindow((v) => v.cellGeometry(0, { winding: "cw" })),
        'options.winding is the string "cw", expected "counter-clockwise" or "clockwise"',
      ],
    ],
  },
  cellMesh: {
    use: inWindow((v) => v.cellMesh()),
    refuses: [tolerance, unknownOption].flatMap((wrong) =>
      wrong(inWindow((v, options) => v.cellMesh(options))),
    ),
  },
  contains: {
    use: inWindow((v) => v.contains(0, 0, 0)),
    refuses: [
      ...id(inWindow((v, site) => v.contains(site, 0, 0))),
      ...number(
        "x",
        inWindow((v, x) => v.contains(0, x, 0)),
      ),
      ...number(
        "y",
        inWindow((v, y) => v.contains(0, 0, y)),
      ),
    ],
  },
  neighbors: ofCell("neighbors"),
  naturalWeights: {
    use: inWindow((v) => v.naturalWeights(7, 7, { r: 1 })),
    refuses: [
      ...number(
        "x",
        inWindow((v, x) => v.naturalWeights(x, 0)),
      ),
      ...number(
        "y",
        inWindow((v, y) => v.naturalWeights(0, y)),
      ),
      ...number(
        "options.r",
        inWindow((v, r) => v.naturalWeights(0, 0, { r })),
      ),
      ["bad-option", inWindow((v) => v.naturalWeights(0, 0, 1)), "options is 1, expected { r }"],
    ],
  },
  interpolate: {
    use: (d) => interpolateBy("interpolate")(d),
    refuses: interpolating(interpolateBy("interpolate")),
  },
  interpolateAsync: {
    isAsync: true,
    use: async (d) => interpolateBy("interpolateAsync")(d),
    refuses: [
      ...interpolating(interpolateBy("interpolateAsync")),
      [
        "busy",
        (d) => {
          const promise = interpolateBy("interpolateAsync")(d, new Float64Array(1e6));
          d.removeMany([]);
          return promise;
        },
        "changed meanwhile",
      ],
      [
        "bad-option",
        (d) => interpolateBy("interpolateAsync")(d, [1, 2], { onProgress: 7 }),
        "options.onProgress is 7, expected",
      ],
    ],
  },
  largestEmptyCircle: {
    use: inWindow((v, options) => v.largestEmptyCircle(options)),
    refuses: [
      ...unknownOption(inWindow((v, options) => v.largestEmptyCircle(options))),
      [
        "bad-option",
        inWindow((v) => v.largestEmptyCircle({ inside: 1 })),
        "options.inside is 1, expected false or true",
      ],
      ...searchedBy((v) => v.largestEmptyCircle({ inside: true })),
    ],
  },
  cellCircle: {
    use: ofCell("cellCircle").use,
    refuses: [
      ...ofCell("cellCircle").refuses,
      ...aspects(inWindow((v, options) => v.cellCircle(0, options))),
      ...searchedBy((v) => v.cellCircle(0)),
    ],
  },
  cellCircles: {
    use: inWindow((v) => v.cellCircles()),
    refuses: [
      ...aspects(inWindow((v, options) => v.cellCircles(options))),
      ...searchedBy((v) => v.cellCircles()),
    ],
  },
  cellCirclesAsync: {
    isAsync: true,
    use: async (d) => inWindow((v) => v.cellCirclesAsync())(d),
    refuses: [
      ...aspects(inWindow((v, options) => v.cellCirclesAsync(options))),
      ...searchedBy((v) => v.cellCirclesAsync()),
      [
        "busy",
        () => {
          const many = new Diagram(
            Float64Array.from({ length: 9000 }, (_, k) => (k * 7919) % 1009),
          );
          const promise = many.voronoi([0, 0, 1009, 1009]).cellCirclesAsync();
          many.removeMany([]);
          return promise;
        },
        "changed meanwhile",
      ],
      [
        "bad-option",
        inWindow((v) => v.cellCirclesAsync({ onProgress: 7 })),
        "options.onProgress is 7, expected",
      ],
    ],
  },
  emptyCircles: {
    use: inWindow((v) => v.emptyCircles(2)),
    refuses: [
      ...unknownOption(inWindow((v, options) => v.emptyCircles(2, options))),
      ...searchedBy((v) => v.emptyCircles(2, { inside: true })),
      ["not-finite", inWindow((v) => v.emptyCircles(NaN)), "count is NaN"],
      ["out-of-range", inWindow((v) => v.emptyCircles(-1)), "count is -1"],
    ],
  },
  cellArea: ofCell("cellArea"),
  cellCentroid: ofCell("cellCentroid"),
  cellPerimeter: ofCell("cellPerimeter"),
  cellMeasures: ofCell("cellMeasures"),
  cellAreas: works(inWindow((v) => v.cellAreas())),
  fitAreas: {
    use: (d) => fitBy("fitAreas")(d),
    refuses: [
      ...fitting(fitBy("fitAreas")),
      [
        "bad-option",
        (d) => fitBy("fitAreas")(d, { signal: AbortSignal.abort() }),
        "options.signal is unknown, expected {",
      ],
    ],
  },
  fitAreasAsync: {
    isAsync: true,
    use: async (d) => fitBy("fitAreasAsync")(d),
    refuses: [
      ...fitting(fitBy("fitAreasAsync")),
      [
        "bad-option",
        (d) => fitBy("fitAreasAsync")(d, { signal: 7 }),
        "options.signal is 7, expected",
      ],
      [
        "bad-option",
        (d) => fitBy("fitAreasAsync")(d, { onProgress: 7 }),
        "options.onProgress is 7, expected a function",
      ],
    ],
  },
  cellCentroids: works(inWindow((v) => v.cellCentroids())),
  cellPerimeters: works(inWindow((v) => v.cellPerimeters())),
};

const noDiagram = (call) => [
  ["bad-option", () => call({}), "a method was called on an object, expected a diagram"],
];
export const diagnosticsCalls = {
  levels: { use: (d) => levels(d), refuses: noDiagram(levels) },
  validate: { use: (d) => validate(d), refuses: noDiagram(validate) },
};

/** All of them: [name, { use, refuses, isAsync }]; those that are give promises. */
export const calls = [
  ...Object.entries(diagramCalls).map(([name, call]) => [`Diagram.${name}`, call]),
  ...Object.entries(voronoiCalls).map(([name, call]) => [`Voronoi.${name}`, call]),
  ...Object.entries(diagnosticsCalls).map(([name, call]) => [`diagnostics.${name}`, call]),
];
