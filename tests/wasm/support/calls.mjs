// Every public call of Diagram and Voronoi: one use of it that works, and what it refuses with
// which code and words. Tests check that nothing is missing here, neither a member of the classes
// nor a code that the documentation names.
import { Diagram } from "../../../build/packed/consumer.mjs";

const NONE = 1000; // an id that no site has
const bounds = [-100, -100, 100, 100];
const inWindow =
  (use) =>
  (d, ...values) =>
    use(d.voronoi(bounds), ...values);

const equal = (d) => new Array(d.voronoi(bounds).cellAreas().length).fill(1);
/** In a window that holds all centres. */
const fitBy =
  (name) =>
  (d, { targets = equal(d).map((_, k) => 1 + (k % 2)), ...options } = {}) =>
    d.voronoi([-1e4, -1e4, 1e4, 1e4])[name](targets, options);

// Each takes a call with one argument left open, and returns refusals: [code, call, text in the
// message].
const number = (name, call) => [
  ["not-finite", (d) => call(d, NaN), `${name} is NaN`],
  ["not-finite", (d) => call(d, "7"), `${name} is the string "7"`],
  ["out-of-range", (d) => call(d, -1e101), `${name} is -1e+101`],
  ["out-of-range", (d) => call(d, 1e-101), `${name} is 1e-101`],
];
/** Of calls that let whole numbers be that no site has. */
const wholeNumber = (call) => [
  ["unknown-site", (d) => call(d, "0"), 'site the string "0" does not exist: ids are whole numb'],
  ["unknown-site", (d) => call(d, 0.5), "site 0.5 does not exist: ids are whole numbers, not"],
  ["unknown-site", (d) => call(d, null), "site null does not exist: ids are whole numbers, not"],
];
const id = (call) => [
  ["unknown-site", (d) => call(d, NONE), "site 1000 does not exist"],
  ...wholeNumber(call),
];
const numbers = (name, multiple, call) => [
  ["not-finite", (d) => call(d, [1, 2, 3, 4, NaN, 6]), `${name}[4] is NaN`],
  ["out-of-range", (d) => call(d, [1, 2, 3, 1e200, 5, 6]), `${name}[3] is 1e+200`],
  [
    "bad-length",
    (d) => call(d, [1, 2, 3, 4, 5, 6, 7]),
    `expected a multiple of ${multiple} values in ${name}, got 7`,
  ],
  ["bad-length", (d) => call(d, 7), `${name} is 7`],
];
// 2^29 + 1 sites and as many as JavaScript can count, of which none is read.
const tooMany = (name, perSite, call) =>
  [2 ** 29 + 1, 2 ** 51].map((count) => [
    "too-large",
    (d) =>
      call(d, {
        length: perSite * count,
        get 0() {
          throw new Error("read");
        },
      }),
    `${name} holds ${count} sites, expected at most 2^29`,
  ]);
const window = (call) => [
  ["bad-bounds", (d) => call(d, [0, 0, 0, 5]), "bounds are [0, 0, 0, 5]"],
  [
    "bad-bounds",
    (d) => call(d, [0, 0, 5]),
    "bounds is an array of 3, expected [xmin, ymin, xmax, ymax]",
  ],
  ["bad-bounds", (d) => call(d, [0, 0, 5, "5"]), 'ymax of bounds is the string "5"'],
];
const tolerance = (call) => [
  ["not-finite", (d) => call(d, { tolerance: NaN }), "tolerance is NaN"],
  ["not-finite", (d) => call(d, { tolerance: null }), "tolerance is null"],
  ["out-of-range", (d) => call(d, { tolerance: 0 }), "tolerance is 0"],
];
const digits = (call) => [
  ["out-of-range", (d) => call(d, { digits: 16 }), "digits is 16"],
  ["out-of-range", (d) => call(d, { digits: "2" }), "digits is 2"],
];
const unknownOption = (call) => [
  ["bad-option", (d) => call(d, { tolerence: 1 }), "options.tolerence is unknown, expected {"],
  ["bad-option", (d) => call(d, 0.5), "options is 0.5, expected {"],
];
/** Of calls that give polygons. */
const polygons = (call) => [
  ...tolerance(call),
  ...unknownOption(call),
  ["bad-option", (d) => call(d, { flat: 1 }), "options.flat is 1, expected false or true"],
  ["bad-option", (d) => call(d, { nested: true }), "options.nested is unknown, expected { tol"],
];
/** Of calls that look for weights. */
const fitting = (call) => [
  ["bad-length", (d) => call(d, { targets: [1] }), "targets has 1 elements, expected "],
  ["bad-length", (d) => call(d, { targets: null }), "targets is null, expected an array of num"],
  ["bad-length", (d) => call(d, { start: [1] }), "start has 1 elements, expected "],
  ["bad-length", (d) => call(d, { start: 7 }), "start is 7"],
  ["unknown-site", (d) => call(d, { targets: new Map([[NONE, 1]]) }), "site 1000 does not exist"],
  ["bad-target", (d) => call(d, { targets: equal(d).fill(0) }), "] is 0, expected"],
  ["bad-target", (d) => call(d, { targets: {} }), "targets has none for site"],
  ["not-finite", (d) => call(d, { targets: { 0: "1" } }), 'targets[0] is the string "1"'],
  ["not-finite", (d) => call(d, { start: equal(d).fill(NaN) }), "start[0] is NaN"],
  ["out-of-range", (d) => call(d, { start: equal(d).fill(1e200) }), "start[0] is 1e+200"],
  ["bad-option", (d) => call(d, { onIteration: 7 }), "onIteration is 7"],
  ["bad-option", (d) => call(d, { strict: 1 }), "options.strict is 1, expected false or true"],
  ["bad-option", (d) => call(d, { signals: 1 }), "options.signals is unknown, expected {"],
  ["no-convergence", (d) => call(d, { maxIterations: 1 }), "after 1 steps areas are off by"],
  ["busy", (d) => call(d, { onIteration: () => d.removeMany([]) }), "changed meanwhile"],
  ...tolerance(call),
];
/** Of calls that draw: with options, and with a context. */
const drawing = (call, into) => [...tolerance(call), ...flat(call, into)];
const flat = (call, into) => [
  ...digits(call),
  ...unknownOption(call),
  [
    "bad-option",
    (d) => into(d, { digits: 2 }),
    "context is an object without moveTo(): options go behind it, as in render(null, {",
  ],
  ["bad-option", (d) => into(d, "canvas"), 'context is the string "canvas" without moveTo()'],
];

const works = (use) => ({ use, refuses: [] });
const ofSite = (name) => {
  const use = (d, site = 0) => d[name](site);
  return { use, refuses: id(use) };
};
const drawn = (name) => {
  const use = (d, options) => d[name](null, options);
  return { use, refuses: drawing(use, (d, context) => d[name](context)) };
};
const ofCell = (name, ...arguments_) => {
  const use = inWindow((v, site = 0) => v[name](site, ...arguments_));
  return { use, refuses: id(use) };
};

export const diagramCalls = {
  constructor: {
    use: () => new Diagram([1, 2, 3]),
    refuses: [
      ...numbers("xyr", 3, (_d, xyr) => new Diagram(xyr)),
      ...tooMany("xyr", 3, (_d, xyr) => new Diagram(xyr)),
      [
        "bad-option",
        () => new Diagram([], { location: "grid" }),
        'options.location is the string "grid"',
      ],
      [
        "bad-option",
        () => new Diagram([], { radius: 5 }),
        "options.radius is unknown, expected { location }",
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
        (d) => Diagram.fromBytes(d.toBytes(), { location: "grid" }),
        'options.location is the string "grid"',
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
    refuses: [...number("x", (d, x) => d.find(x, 0)), ...number("y", (d, y) => d.find(0, y))],
  },
  nearest: {
    use: (d) => d.nearest(0, 0),
    refuses: [...number("x", (d, x) => d.nearest(x, 0)), ...number("y", (d, y) => d.nearest(0, y))],
  },
  findMany: {
    use: (d) => d.findMany([0, 0]),
    refuses: [
      ...numbers("xy", 2, (d, xy) => d.findMany(xy)),
      [
        "bad-length",
        (d) => d.findMany([0, 0], new Float64Array(2)),
        "distances is Float64Array(2), expected Float64Array(1)",
      ],
      [
        "bad-length",
        (d) => d.findMany([0, 0], [0]),
        "distances is an array of 1, expected Float64Array(1)",
      ],
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
  within: {
    use: (d) => d.within(0, 0, 1),
    refuses: [
      ...number("x", (d, x) => d.within(x, 0, 1)),
      ...number("y", (d, y) => d.within(0, y, 1)),
      ...number("distance", (d, distance) => d.within(0, 0, distance)),
      ["not-finite", (d) => d.within(0, 0, -Infinity), "distance is -Infinity"],
      ["bad-option", (d) => d.within(0, 0, 1, { filter: [] }), "options.filter is an array of 0"],
    ],
  },
  pick: {
    use: (d) => d.pick(0, 0),
    refuses: [
      ...number("x", (d, x) => d.pick(x, 0)),
      ...number("y", (d, y) => d.pick(0, y)),
      ...number("maxDistance", (d, distance) => d.pick(0, 0, distance)),
      ["out-of-range", (d) => d.pick(0, 0, -1), "maxDistance is -1"],
      ["bad-option", (d) => d.pick(0, 0, 1, { top: "first" }), 'options.top is the string "first"'],
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
    ],
  },
  neighbors: ofSite("neighbors"),
  edges: works((d) => d.edges()),
  vertices: works((d) => d.vertices()),
  levels: works((d) => d.levels()),
  voronoi: { use: (d) => d.voronoi(), refuses: window((d, box) => d.voronoi(box)) },
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
  toBytes: works((d) => d.toBytes()),
  toJSON: works((d) => d.toJSON()),
  validate: works((d) => d.validate()),
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
    refuses: [tolerance, digits, unknownOption].flatMap((wrong) =>
      wrong(inWindow((v, options) => v.renderCells(options))),
    ),
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
        inWindow((v) => v.toGeoJSON({ winding: "cw" })),
        'options.winding is the string "cw", expected "counter-clockwise" or "clockwise"',
      ],
    ],
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
  cellArea: ofCell("cellArea"),
  cellCentroid: ofCell("cellCentroid"),
  cellPerimeter: ofCell("cellPerimeter"),
  cellMeasures: ofCell("cellMeasures"),
  cellWithin: {
    use: inWindow((v) => v.cellWithin(0, 5)),
    refuses: [
      ...id(inWindow((v, site) => v.cellWithin(site, 5))),
      ...number(
        "radius",
        inWindow((v, radius) => v.cellWithin(0, radius)),
      ),
      ["out-of-range", inWindow((v) => v.cellWithin(0, -1)), "radius is -1"],
      ["not-finite", inWindow((v) => v.cellWithin(0, -Infinity)), "radius is -Infinity"],
    ],
  },
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
    ],
  },
  cellCentroids: works(inWindow((v) => v.cellCentroids())),
  cellPerimeters: works(inWindow((v) => v.cellPerimeters())),
};

/** All of them: [name, { use, refuses, isAsync }]; those that are give promises. */
export const calls = [
  ...Object.entries(diagramCalls).map(([name, call]) => [`Diagram.${name}`, call]),
  ...Object.entries(voronoiCalls).map(([name, call]) => [`Voronoi.${name}`, call]),
];
