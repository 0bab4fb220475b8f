// The goals of issues 2 to 5 as ratios of this run's numbers. For information: timing decides no
// test.
import { short, table } from "./tables.mjs";

/**
 * A lookup in microseconds, us("scaling random5 1000000 build wasm"), of the medians or of the
 * fastest samples.
 */
function lookup(records, member) {
  const found = new Map(
    records.map((record) => [
      [record.part, record.family, record.n, record.label, record.op, record.contender]
        .filter(Boolean)
        .join(" "),
      record,
    ]),
  );
  return (key) => found.get(key)?.[member];
}

const information = { text: "", isMet: () => null };
const most = (limit) => ({ text: `≤ ${limit}`, isMet: (value) => value <= limit });
const least = (limit) => ({ text: `≥ ${limit}`, isMet: (value) => value >= limit });

/** The largest measured size up to a wanted one: a quick run has no million. */
function largestSize(records, part, wanted) {
  const isOne = (record) =>
    record.part === part && record.family === "random5" && record.n <= wanted;
  return Math.max(...records.filter(isOne).map(({ n }) => n));
}

/** What, value, goal; the value from the medians ("us") or from the fastest samples ("fastest"). */
function goals(records, member) {
  const us = lookup(records, member);
  const million = largestSize(records, "scaling", 1e6);
  const hundred = largestSize(records, "scaling", 1e5);
  const ten = largestSize(records, "scaling", 1e4);
  const family = largestSize(records, "families", 1e5);
  const scaling = (n, op, contender) => us(`scaling random5 ${n} ${op} ${contender}`);
  const against = (n, op, a, b, goal) => [
    `${op} ${n}: ${a} / ${b}`,
    scaling(n, op, a) / scaling(n, op, b),
    goal,
  ];
  const kind = (name, op) => us(`families ${name} ${family} ${op} wasm`);
  const toRandom = (name, op = "build") => [
    `${op} ${name} / random, ${family}`,
    kind(name, op) / kind("random5", op),
  ];
  const drawn = records.find(({ part }) => part === "drawing")?.n;
  const drawing = (name, op, contender = "wasm") =>
    us(`drawing ${name} ${drawn} ${op} ${contender}`);
  const ordered = (name, op) => us(`orders ${name} ${family} ${op} wasm`);
  const crossed = largestSize(records, "windows", 1e6);
  const memory = records.find(({ op }) => op === "memory");
  const churn = records.find(({ op }) => op === "churn");
  const megabytes = (bytes) => bytes / 2 ** 20;
  return [
    against(million, "build", "wasm", "delaunator", most(1.3)),
    against(million, "build", "cgal", "wasm", least(8)),
    against(million, "build", "cgal", "native", least(12)),
    against(hundred, "insert", "cgal", "wasm", least(2.5)),
    against(hundred, "insert", "cgal", "native", least(2.5)),
    against(million, "find", "cgal", "wasm", least(5)),
    against(million, "find", "flatbush", "wasm", least(2.5)),
    against(million, "remove", "cgal", "wasm", least(4)),
    [
      `build ${million}: CGAL in sorted order / wasm`,
      scaling(million, "buildSorted", "cgal") / scaling(million, "build", "wasm"),
      information,
    ],
    [
      `findMany / find in ${million}: wasm`,
      scaling(million, "findMany", "wasm") / scaling(million, "find", "wasm"),
      most(0.5),
    ],
    [
      `build per site ${million} / ${ten}: wasm`,
      scaling(million, "build", "wasm") / scaling(ten, "build", "wasm"),
      most(1.5),
    ],
    [...toRandom("lattice"), most(1.5)],
    [...toRandom("powerlaw"), most(1.5)],
    [...toRandom("collinear"), most(2)],
    [...toRandom("planet"), most(2)],
    [...toRandom("decimal"), most(3)],
    [...toRandom("cocircular"), most(3)],
    [...toRandom("planet", "findNear"), most(3)],
    [...toRandom("planet", "remove"), most(3)],
    ...["line", "parallels", "rows"].map((name) => [
      `one by one, ${name} ${family}: sorted / shuffled`,
      ordered(name, "insert") / ordered(`${name}-shuffled`, "insert"),
      most(5),
    ]),
    ...["line-shuffled", "duplicates", "concentric", "chain"].map((name) => [
      `remove the nearest, ${name} ${family}: / random`,
      ordered(name, "removeNearest") / ordered("random5", "removeNearest"),
      most(5),
    ]),
    [
      `10 nearest, chain ${family}: / random`,
      ordered("chain", "kNearest") / ordered("random5", "kNearest"),
      most(5),
    ],
    [`heap per site, ${memory?.n} sites, bytes`, memory?.bytesPerSite, most(160)],
    [
      "heap growth from 1000 pairs to all, MiB",
      churn && megabytes(churn.bytesAfterAll - churn.bytesAfterThousand),
      most(0),
    ],
    [
      "updateMany of 10000 (0.01 spacings), ms a frame",
      us("moves random5 10000 0.01 spacings updateMany wasm") * 10,
      most(10),
    ],
    ...["wasm", "native"].map((contender) => [
      `updateMany of all, far / build ${hundred}: ${contender}`,
      us(`moves random5 ${hundred} all far updateMany ${contender}`) /
        us(`moves random5 ${hundred} all far build ${contender}`),
      most(1.3),
    ]),
    ...[hundred, million].flatMap((n) =>
      ["wasm", "native"].map((contender) => [
        `build / fromBytes ${n}: ${contender}`,
        us(`snapshots random5 ${n} build ${contender}`) /
          us(`snapshots random5 ${n} fromBytes ${contender}`),
        least(5),
      ]),
    ),
    ...["random0", "random5", "random50"].flatMap((name) => [
      [
        `draw ${name} ${drawn}: wasm / d3-delaunay`,
        drawing(name, "draw") / drawing(name, "draw", "d3-delaunay"),
        most(2),
      ],
      [
        `draw ${name} ${drawn}: wasm / d3-delaunay with known circumcenters`,
        drawing(name, "draw") / drawing(name, "redraw", "d3-delaunay"),
        information,
      ],
      [
        `all areas / build, ${name} ${drawn}`,
        drawing(name, "cellAreas") / drawing(name, "build"),
        most(1),
      ],
    ]),
    ...["cities", "random5"].flatMap((name) => {
      const record = records.find(({ part, family }) => part === "windows" && family === name);
      const areas = (op) => us(`windows ${name} ${record?.n} ${op} wasm`);
      return [
        ["landAreas", most(3)],
        ["landAreasAnew", information],
      ].map(([op, goal]) => [
        `${op} / in bounds, ${name} ${record?.n}`,
        areas(op) / areas("boxAreas"),
        goal,
      ]);
    }),
    [
      `areas in 1000 segments / in bounds, ${crossed}`,
      us(`windows random5 ${crossed} segmentAreas wasm`) /
        us(`windows random5 ${crossed} boxAreas wasm`),
      most(3),
    ],
    [
      "cellCircles / toGeoJSON, 2000",
      us("windows random5 2000 cellCircles wasm") / us("windows random5 2000 toGeoJSON wasm"),
      most(5),
    ],
    [
      "label in a star of 5000 points, ms",
      us("windows star 5000 starLabel wasm") / 1e3,
      information,
    ],
    [
      "labels of a treemap / its layout, 3000",
      us("treemap tree 3000 treemapLabels wasm") / us("treemap tree 3000 treemapMove wasm"),
      most(0.3),
    ],
    [
      "interpolate, 500 x 500 points among 1000 sites, s",
      us("windows random0 1000 interpolate wasm") / 4,
      most(1),
    ],
    ["fitAreas, 1000 sites, s", us("fit random0 1000 fitAreas wasm") / 1e3, most(0.1)],
    ["fitAreas, 10 000 sites, s", us("fit random0 10000 fitAreas wasm") / 1e2, most(3)],
    [
      `issue 2: insert one by one, ${hundred}, wasm, µs`,
      scaling(hundred, "insert", "wasm"),
      most(6),
    ],
    ...[1e4, 1e5].flatMap((n) => {
      const sphere = (op, contender = "wasm") => us(`sphere random5 ${n} ${op} ${contender}`);
      const against = (op) => sphere(op, "d3-geo-voronoi") / sphere(op);
      return [
        [`sphere, build ${n}: d3-geo-voronoi / wasm`, against("sphereBuild"), least(10)],
        [`sphere, find in ${n}: d3-geo-voronoi / wasm`, against("sphereFind"), least(20)],
        [`sphere, polygons of ${n}: d3-geo-voronoi / wasm`, against("spherePolygons"), information],
        [`sphere, build ${n} / plane`, sphere("sphereBuild") / sphere("build"), most(1.3)],
        [`sphere, find in ${n} / plane`, sphere("sphereFind") / sphere("find"), most(1.5)],
      ];
    }),
    ...["flare 220", "tree 1000", "tree 3000"].flatMap((tree) => {
      const other = us(`treemap ${tree} treemapMove d3-voronoi-treemap`);
      const name = `treemap, ${tree}: d3-voronoi-treemap`;
      return [
        [`${name} / sites move`, other / us(`treemap ${tree} treemapMove wasm`), least(1)],
        [`${name} / sites stay`, other / us(`treemap ${tree} treemapStay wasm`), least(5)],
      ];
    }),
    [`issue 2: find in ${hundred}, wasm, µs`, scaling(hundred, "find", "wasm"), most(3)],
    [`issue 2: remove from ${hundred}, wasm, µs`, scaling(hundred, "remove", "wasm"), most(15)],
  ];
}

export function targetsTable(records) {
  const fastest = goals(records, "fastest");
  const rows = goals(records, "us")
    .map(([what, value, goal], k) => [what, value, fastest[k][1], goal])
    .filter(([, value]) => Number.isFinite(value))
    .map(([what, value, best, goal]) => [
      what,
      short(value),
      short(best),
      goal.text,
      { true: "yes", false: "no", null: "" }[goal.isMet(value)],
    ]);
  return rows.length === 0
    ? ""
    : table(["what", "of medians", "of the fastest", "goal", "met"], rows);
}
