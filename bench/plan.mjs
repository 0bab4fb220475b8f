// The plan of measurements: scenes, each one set with the operations on it, in order. A scene is
// run `rounds` times, and in each round every step asks its contenders in turn; `rounds` of a step
// limits how often a slow one takes part.
import { availableParallelism } from "node:os";
import { countCities } from "./cities.mjs";
import {
  callsOfDiagrams,
  callsOfTrees,
  callsOfViews,
  callsOfWindows,
  slowCalls,
} from "./js/growth_calls.mjs";

export const families = [
  "random0",
  "random5",
  "random20",
  "random50",
  "lattice",
  "decimal",
  "cocircular",
  "collinear",
  "clustered",
  "powerlaw",
  "planet",
  "cities",
  "outlier",
  "towns",
  "scales",
];

/** Hidden sites in percent (the families random0 ...) for the paper's h/n. */
export const tableOneFamilies = {
  "1.00": "random0",
  0.95: "random5",
  "0.80": "random20",
  "0.50": "random50",
};

/** The label of scenes that are left out of the report. */
export const kWarmUp = "warm-up";

const modes = {
  quick: {
    rounds: 1,
    seconds: 0.1,
    limit: 3,
    sizes: [1e3, 1e4, 1e5],
    family: 1e4,
    tableOne: 1e4,
    walk: 1e4,
    memory: 1e5,
    churn: 2e4,
    growth: { n: 500, of: ["random5", "lattice", "collinear", "clustered", "planet"] },
  },
  default: {
    rounds: 3,
    seconds: 0.3,
    limit: 15,
    sizes: [1e3, 1e4, 1e5, 1e6],
    family: 1e5,
    tableOne: 1e6,
    walk: 1e5,
    memory: 1e6,
    churn: 1e6,
    growth: { n: 1e3, of: families },
  },
  full: {
    rounds: 5,
    seconds: 0.5,
    limit: 900,
    sizes: [1e3, 1e4, 1e5, 1e6, 1e7],
    family: 1e6,
    tableOne: 1e6,
    walk: 1e6,
    memory: 1e6,
    churn: 1e6,
    growth: { n: 1e3, of: families },
  },
};
export const modeNames = Object.keys(modes);

const ours = ["wasm", "native"];

/** Against the number of sites, with the opponents. */
function scaling({ rounds, seconds, limit, sizes }) {
  return sizes.map((n) => {
    const isHuge = n > 1e6;
    const common = { seconds, limit };
    const queries = { ...common, count: Math.min(n, 2e5) };
    const slowly = n >= 1e6 ? 1 : rounds; // CGAL's minutes
    return {
      part: "scaling",
      family: "random5",
      n,
      rounds: isHuge ? 1 : rounds,
      steps: [
        {
          op: "build",
          who: isHuge ? [...ours, "delaunator"] : [...ours, "cgal", "delaunator", "flatbush"],
          ...common,
        },
        { op: "buildSorted", who: isHuge ? [] : ["cgal"], ...common, rounds: slowly },
        {
          op: "find",
          who: isHuge ? ours : [...ours, "cgal", "flatbush", "d3-delaunay"],
          ...queries,
          limit: 5,
        },
        { op: "findMany", who: ours, ...queries },
        {
          op: "remove",
          who: isHuge ? ours : [...ours, "cgal"],
          ...common,
          count: Math.max(1000, n / 10),
        },
        { op: "removeMany", who: ours, ...common, count: Math.max(1000, n / 10) },
        { op: "insert", who: ours, ...common },
        { op: "insert", who: n > 1e5 ? [] : ["cgal"], ...common },
      ],
    };
  });
}

/** Every kind of input; native as well, for its counts of stages. */
function kinds({ rounds, seconds, limit, family: n }) {
  const sizes = n > 1e5 ? [1e5, n] : [n];
  return sizes.flatMap((size) =>
    families.map((family) => {
      const common = { seconds, limit };
      const steps = [
        { op: "build", ...common },
        { op: "find", ...common, count: 50_000 },
        { op: "findNear", ...common, count: 50_000 },
        { op: "remove", ...common, count: size / 10 },
        { op: "insert", ...common },
      ];
      return {
        part: "families",
        family,
        n: family === "cities" ? Math.min(size, countCities()) : size,
        rounds: Math.min(rounds, 3),
        steps: steps.flatMap((step) => [
          { ...step, who: ["wasm"] },
          { ...step, who: ["native"], rounds: 1, seconds: 0 },
        ]),
      };
    }),
  );
}

/** Table 1 of the paper: one by one, both ways to locate. */
function tableOne({ seconds, limit, rounds, tableOne: largest, walk }) {
  return [1e3, 1e4, 1e5, 1e6]
    .filter((n) => n <= largest)
    .flatMap((n) =>
      Object.values(tableOneFamilies).map((family) => ({
        part: "table1",
        family,
        n,
        rounds: n >= 1e6 ? 1 : Math.min(rounds, 3),
        steps: [
          { op: "insert", who: ours, seconds, limit: Math.max(limit, 60) },
          {
            op: "insertByWalk",
            who: n <= walk ? ["native"] : [],
            seconds,
            limit: Math.max(limit, 60),
          },
        ],
      })),
    );
}

/**
 * Moves 10 000 of n sites a frame, and all of them, far and by a hundredth, against building.
 * Steps are in mean spacings; each frame is a sample.
 */
function moves({ rounds, seconds, limit, sizes }) {
  const among = [1e4, ...sizes.filter((n) => n === 1e6)];
  const steps = { "all far": 30, "all 0.01 spacings": 0.01 };
  const all = [1e4, 1e5]
    .filter((n) => n <= Math.max(...sizes))
    .flatMap((n) =>
      Object.entries(steps).map(([label, step]) => ({
        part: "moves",
        family: "random5",
        n,
        label,
        rounds: Math.min(rounds, 3),
        steps: [
          { op: "build", who: ours, seconds, limit },
          { op: "updateMany", who: ours, count: n, step, seconds, rebuild: true },
        ],
      })),
    );
  return all.concat(
    among.flatMap((n) =>
      [0.001, 0.01, 0.1].map((step) => ({
        part: "moves",
        family: "random5",
        n,
        label: `${step} spacings`,
        rounds: Math.min(rounds, 2),
        steps: ["update", "updateMany"].map((op) => ({
          op,
          who: ours,
          count: 1e4,
          step,
          seconds: 4 * seconds,
          rebuild: true,
        })),
      })),
    ),
  );
}

/**
 * All edges of all cells into a context that adds up, against d3-delaunay with the same centres;
 * and all areas against building.
 */
function drawing({ rounds, seconds, sizes }) {
  const n = Math.min(1e5, Math.max(...sizes));
  return ["random0", "random5", "random50"].map((family) => ({
    part: "drawing",
    family,
    n,
    rounds,
    steps: [
      { op: "draw", who: ["wasm", "d3-delaunay"], seconds },
      { op: "redraw", who: ["d3-delaunay"], seconds },
      { op: "build", who: ["wasm"], seconds },
      { op: "cellAreas", who: ["wasm"], seconds },
    ],
  }));
}

/** Sorted orders against random ones, and sites that hide each other. `insert` is one by one. */
function orders({ rounds, seconds, limit, family: n }) {
  const common = { seconds, limit };
  const scene = (family, size, ...steps) => ({
    part: "orders",
    family,
    n: size,
    rounds: Math.min(rounds, 3),
    steps: steps.map((step) => ({ ...step, who: ours, ...common })),
  });
  const sorted = ["line", "parallels", "rows"].flatMap((family) => [family, `${family}-shuffled`]);
  return [
    ...[n / 10, n].flatMap((size) => sorted.map((family) => scene(family, size, { op: "insert" }))),
    scene("line-shuffled", n, { op: "removeNearest", count: n / 10 }),
    ...["duplicates", "concentric", "chain"].map((family) =>
      scene(family, n, { op: "kNearest", count: 1000 }, { op: "removeNearest", count: n / 10 }),
    ),
    scene("random5", n, { op: "kNearest", count: 10_000 }, { op: "removeNearest", count: n / 10 }),
  ];
}

/**
 * Prescribed areas against d3-voronoi-map, which takes seconds for 1000 sites: time, and the
 * accuracy that is reached.
 */
function fit({ rounds, seconds, limit, sizes }) {
  const common = { seconds, limit, rounds: Math.min(rounds, 2) };
  const kinds = ["fitAreas", "fitTailed"];
  const inHoles = ["fitInHoles", "fitTailedInHoles"];
  return [100, 1e3, 1e4]
    .filter((n) => n <= Math.max(...sizes))
    .map((n) => ({
      part: "fit",
      family: "random0",
      n,
      rounds: common.rounds,
      steps: [
        ...kinds.map((op) => ({
          op,
          who: n <= 1e3 ? ["wasm", "d3-voronoi-map"] : ["wasm"],
          ...common,
        })),
        ...(n >= 1e3 ? inHoles : []).map((op) => ({ op, who: ["wasm"], ...common })),
      ],
    }));
}

/**
 * All areas in the outline of the world's land, and in a thousand segments, against bounds; a map
 * of values among a thousand stations; labels of all cells, and one in a star of many points.
 */
function windows({ rounds, seconds, sizes }) {
  const most = Math.max(...sizes);
  const scene = (family, n, ...ops) => ({
    part: "windows",
    family,
    n,
    rounds: Math.min(rounds, 3),
    steps: ops.map((op) => ({ op, who: ["wasm"], seconds })),
  });
  const hundred = Math.min(1e5, most);
  const land = ["boxAreas", "landAreas", "landAreasAnew"];
  const segments = ["boxAreas", "segmentAreas", "segmentAreasAnew"];
  return [
    scene("cities", Math.min(hundred, countCities()), ...land),
    scene("random5", hundred, ...land),
    scene("random5", Math.min(1e6, most), ...segments),
    scene("random0", Math.min(1e3, most), "interpolate"),
    scene("random5", 2e3, "toGeoJSON", "cellCircles"),
    scene("star", 5e3, "starLabel"),
  ];
}

/** The sphere against d3-geo-voronoi with the same centres, and against the plane. */
function sphere({ rounds, seconds, limit, sizes }) {
  const both = ["wasm", "d3-geo-voronoi"];
  const common = { seconds, limit, rounds: Math.min(rounds, 3) };
  return [1e4, 1e5]
    .filter((n) => n <= Math.max(...sizes))
    .map((n) => ({
      part: "sphere",
      family: "random5",
      n,
      rounds: common.rounds,
      steps: [
        { op: "build", who: ["wasm"], ...common },
        { op: "sphereBuild", who: both, ...common },
        { op: "find", who: ["wasm"], ...common, count: 50_000 },
        { op: "sphereFind", who: both, ...common, count: 50_000 },
        { op: "spherePolygons", who: both, ...common },
        { op: "sphereCut", who: ["wasm"], ...common },
        { op: "sphereAreas", who: ["wasm"], ...common },
      ],
    }));
}

/** Trees of cells within cells, against d3-voronoi-treemap, which always moves sites. */
function treemap({ rounds, seconds, limit, sizes }) {
  const common = { seconds, limit, rounds: Math.min(rounds, 3) };
  const trees = [
    ["flare", 220],
    ["tree", 1000],
    ["tree", 3000],
  ];
  return trees
    .filter(([, n]) => n <= Math.max(...sizes))
    .map(([family, n]) => ({
      part: "treemap",
      family,
      n,
      rounds: common.rounds,
      steps: [
        { op: "treemapMove", who: ["wasm", "d3-voronoi-treemap"], ...common },
        { op: "treemapStay", who: ["wasm"], ...common },
        { op: "treemapLabels", who: ["wasm"], ...common },
      ],
    }));
}

/** Snapshots against building, and `findMany` on threads that restored one. */
function snapshots({ rounds, seconds, limit, sizes }) {
  const cores = availableParallelism();
  const threads = [...new Set([1, 2, 4, 8, 16, cores])].filter(
    (count) => count <= cores || count <= 2,
  );
  return sizes
    .filter((n) => n >= 1e4 && n <= 1e6)
    .flatMap((n) => [
      {
        part: "snapshots",
        family: "random5",
        n,
        rounds,
        steps: ["build", "toBytes", "fromBytes"].map((op) => ({ op, who: ours, seconds, limit })),
      },
      ...threads.map((count) => ({
        part: "snapshots",
        family: "random5",
        n,
        label: `${count} thread${count > 1 ? "s" : ""}`,
        rounds: Math.min(rounds, 2),
        steps: [{ op: "findManyOnThreads", who: ["wasm"], count, seconds }],
      })),
    ]);
}

/**
 * Every call to which the reference gives a cost, at n and 4 n of all families: those of diagrams
 * at larger n, slow ones at smaller n. In windows of n points at n and 2 n.
 */
function growth({ seconds, growth: { n, of } }) {
  const scene = (calls, family, size, more) => ({
    part: "growth",
    family,
    n: size,
    rounds: 1,
    steps: calls.map(({ name }) => ({ op: name, who: ["growth"], seconds: seconds / 6 })),
    ...more,
  });
  const grown = (calls, family, size) => {
    const least = family === "cities" ? Math.min(size, Math.floor(countCities() / 4)) : size;
    return [least, 4 * least].map((some) => scene(calls, family, some));
  };
  const bySize = [
    [callsOfDiagrams, 10 * n],
    [callsOfViews, n],
    [slowCalls, n / 2],
  ];
  // Minutes, where distances differ by that much.
  const isTooSlow = (calls, family) =>
    calls === slowCalls && ["outlier", "towns", "scales"].includes(family);
  return [
    // The engine compiles what will be hot.
    ...bySize.map(([calls, size]) => scene(calls, "random5", size / 2, { label: kWarmUp })),
    ...of.flatMap((family) =>
      bySize.flatMap(([calls, size]) =>
        isTooSlow(calls, family) ? [] : grown(calls, family, size),
      ),
    ),
    ...grown(callsOfTrees, "tree", n / 4),
    ...["disc", "ring", "star", "jagged", "rim"].flatMap((shape) =>
      [2 * n, 4 * n].map((points) => scene(callsOfWindows, shape, points)),
    ),
  ];
}

/** The cost of a call that does nothing else, and the heap. */
function border({ rounds, seconds, memory, churn }) {
  return [
    {
      part: "border",
      family: "random5",
      n: 1e4,
      rounds,
      steps: [
        { op: "callSize", who: ["wasm"], seconds },
        { op: "callHas", who: ["wasm"], seconds },
      ],
    },
    {
      part: "memory",
      family: "random5",
      n: memory,
      rounds: 1,
      steps: [{ op: "memory", who: ["wasm"], seconds: 0, fresh: true }],
    },
    // 100 000 sites, so that the heap is larger than the 16 MiB that it starts with.
    {
      part: "memory",
      family: "random5",
      n: 1e5,
      rounds: 1,
      steps: [{ op: "churn", who: ["wasm"], count: churn, fresh: true }],
    },
  ];
}

export const parts = {
  scaling,
  families: kinds,
  orders,
  table1: tableOne,
  moves,
  drawing,
  windows,
  fit,
  sphere,
  treemap,
  snapshots,
  border,
  growth,
};

/** Takes as long as all others together, and is not among them. */
const kOnlyAsked = ["growth"];

/** The scenes of a mode, of all parts or of one. */
export function scenesOf(mode, only) {
  return Object.entries(parts)
    .filter(([name]) => (only ? only === name : !kOnlyAsked.includes(name)))
    .flatMap(([, part]) => part(modes[mode]));
}
