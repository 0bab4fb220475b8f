// Scenes of small whole numbers that are moved and scaled exactly: all that a view says follows.
// Rounding depends on where a scene is, so this finds thresholds that are measured by coordinates
// instead of by the scene.
import { Diagram } from "../../build/packed/consumer.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator } from "./support/random.mjs";
import { Recorder } from "./support/recorder.mjs";

/** A seeded generator of whole numbers below a limit, and of numbers in [0, 1). */
function randomOf(seed) {
  const unit = generator(seed);
  return { unit, below: (limit) => Math.floor(limit * unit()) };
}

const [kWidth, kHeight] = [96, 64];
const kRectangle = [0, 0, kWidth, kHeight];
/** An L with a slope and a hole, and an island in the notch: with a corner at the origin. */
const kPolygon = [
  [
    [
      [0, 0],
      [96, 0],
      [96, 24],
      [48, 24],
      [32, 64],
      [0, 64],
    ],
    [
      [8, 8],
      [8, 16],
      [24, 16],
      [24, 8],
    ],
  ],
  [
    [
      [64, 40],
      [96, 40],
      [96, 64],
    ],
  ],
];

const kTriples = [
  [3, 4, 5],
  [5, 12, 13],
  [8, 15, 17],
  [7, 24, 25],
  [4, 3, 5],
  [12, 5, 13],
  [1, 0, 1],
  [0, 1, 1],
];

/** Sites [x, y, r] of a family, about the corner at the origin. */
const families = {
  "random whole numbers": (random) =>
    Array.from({ length: 3 + random.below(12) }, () => [
      random.below(120) - 12,
      random.below(90) - 12,
      random.below(9),
    ]),
  "tangent to one circle about the origin": (random) =>
    Array.from({ length: 2 + random.below(8) }, () => {
      const [x, y, z] = kTriples[random.below(8)];
      const k = 1 + random.below(6);
      return [
        x * k * (random.unit() < 0.35 ? -1 : 1),
        y * k * (random.unit() < 0.35 ? -1 : 1),
        z * k - 3,
      ];
    }),
  "mirrored at sides and corner": (random) =>
    Array.from({ length: 1 + random.below(5) }, () => [
      1 + random.below(40),
      1 + random.below(30),
      random.below(6),
    ]).flatMap(([x, y, r]) => [
      [x, y, r],
      [-x, y, r],
      [x, -y, r],
      [-x, -y, r],
    ]),
  "a lattice": (random) => {
    const [step, r] = [8 * (1 + random.below(3)), random.below(4)];
    const columns = 96 / step + 1;
    return Array.from({ length: columns ** 2 }, (_, k) => [
      step * (k % columns),
      step * Math.floor(k / columns),
      r,
    ]).filter(() => random.unit() < 0.8);
  },
  // These are scaled only: moving them would round.
  decimals: (random) =>
    Array.from({ length: 3 + random.below(12) }, () => [
      random.below(960) / 10,
      random.below(640) / 10,
      random.below(50) / 10,
    ]),
};

const kMoves = [
  [256, 512, 1],
  [-96, -64, 1],
  [0, 0, 2 ** -10],
  [-48, -32, 2 ** 40],
  [2 ** 20, -(2 ** 20), 1],
];
const kScalings = [
  [0, 0, 2 ** -10],
  [0, 0, 2 ** 40],
];

const areaOfRing = (ring) => {
  let sum = 0;
  for (let k = 0; k + 1 < ring.length; ++k)
    sum +=
      (ring[k][0] - ring[0][0]) * (ring[k + 1][1] - ring[0][1]) -
      (ring[k + 1][0] - ring[0][0]) * (ring[k][1] - ring[0][1]);
  return sum / 2;
};
const ringsOf = ({ type, coordinates }) =>
  (type === "Polygon" ? [coordinates] : coordinates).flat();
const sumOf = (numbers) => numbers.reduce((sum, value) => sum + value, 0);

/** Points of seven numbers P0, P1, w, P2: a conic, or a segment if w is 0. */
function pointsOf(curves, first) {
  const [x0, y0, x1, y1, w, x2, y2] = curves.subarray(first, first + 7);
  const steps = w === 0 ? 1 : 32;
  return Array.from({ length: steps + 1 }, (_, k) => {
    const t = k / steps;
    const [a, b, c] = w === 0 ? [1 - t, 0, t] : [(1 - t) ** 2, 2 * w * t * (1 - t), t ** 2];
    const sum = a + b + c;
    return [(a * x0 + b * x1 + c * x2) / sum, (a * y0 + b * y1 + c * y2) / sum];
  });
}
function lengthOfCurves(curves) {
  let length = 0;
  for (let first = 0; first < curves.length; first += 7) {
    const points = pointsOf(curves, first);
    for (let k = 1; k < points.length; ++k)
      length += Math.hypot(points[k][0] - points[k - 1][0], points[k][1] - points[k - 1][1]);
  }
  return length;
}
function areaOfCurves({ curves, starts }) {
  let area = 0;
  for (let ring = 0; ring + 1 < starts.length; ++ring) {
    const points = [];
    for (let k = starts[ring]; k < starts[ring + 1]; ++k) points.push(...pointsOf(curves, 7 * k));
    area += areaOfRing([...points, points[0]]);
  }
  return area;
}

/** The area inside of a cell as it is drawn, by sampling its curves. */
function areaDrawn(view, id, tolerance) {
  const recorder = new Recorder();
  view.renderCell(id, recorder, { tolerance });
  let [area, ring] = [0, []];
  for (const [name, ...xy] of recorder.calls) {
    if (name === "closePath") {
      area += areaOfRing([...ring, ring[0]]);
      ring = [];
    } else if (name === "bezierCurveTo") {
      const [x0, y0] = ring.at(-1);
      for (let s = 1; s <= 32; ++s) {
        const t = s / 32;
        const [a, b, c, d] = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
        ring.push([
          a * x0 + b * xy[0] + c * xy[2] + d * xy[4],
          a * y0 + b * xy[1] + c * xy[3] + d * xy[5],
        ]);
      }
    } else {
      ring.push(xy);
    }
  }
  return area;
}

/** All facts of a view, in the scene's own coordinates; some of them must agree with each other. */
function factsOf(sites, { polygon, distance }, [x, y, scale], isFitted) {
  const there = ([a, b]) => [(a + x) * scale, (b + y) * scale];
  const xyr = sites.flatMap(([a, b, r]) => [...there([a, b]), r * scale]);
  const window = polygon
    ? { type: "MultiPolygon", coordinates: kPolygon.map((part) => part.map((r) => r.map(there))) }
    : [...there(kRectangle), ...there(kRectangle.slice(2))];
  const diagram = new Diagram(xyr);
  const options = distance === undefined ? undefined : { maxDistance: distance * scale };
  const view = diagram.voronoi(window, options);
  const [length, area] = [(value) => value / scale, (value) => value / scale ** 2];
  const ids = [...diagram.ids()];
  const areas = [...view.cellAreas()].map(area);
  const centroids = view.cellCentroids();
  const tolerance = scale / 64;
  const features = view.toGeoJSON({ tolerance }).features;
  const { curves, sites: beside } = view.edgeCurves();
  const probes = [
    [0, 0],
    [1, 1],
    [48, 20],
    [12, 12],
    [95, 63],
    [30, 63],
  ];
  const facts = {
    window: area(view.window.area),
    areas,
    moments: ids.flatMap((id) => {
      const centre = [centroids[2 * id] / scale - x, centroids[2 * id + 1] / scale - y];
      return areas[id] > 0 ? centre.map((c) => c * areas[id]) : [0, 0];
    }),
    perimeters: [...view.cellPerimeters()].map(length),
    cellAreas: ids.map((id) => area(view.cellArea(id) ?? 0)),
    curvesOfCells: ids.map((id) => {
      const cell = view.cellCurves(id);
      return cell === null ? 0 : area(areaOfCurves(cell));
    }),
    polygons: area(sumOf(features.flatMap(({ geometry }) => ringsOf(geometry).map(areaOfRing)))),
    parts: ids.map((id) =>
      area(
        sumOf((view.cellParts(id, { tolerance }) ?? []).flatMap((part) => part.map(areaOfRing))),
      ),
    ),
    drawn: ids.map((id) => area(areaDrawn(view, id, tolerance))),
    edges: length(lengthOfCurves(curves)),
    largest: length(view.largestEmptyCircle()?.r ?? 0),
    empties: view.emptyCircles(4).map(({ r }) => length(r)),
    natural: probes.flatMap((probe) => {
      const found = view.naturalWeights(...there(probe));
      const weights = new Array(ids.length).fill(0);
      found?.ids.forEach((id, k) => (weights[id] = found.weights[k]));
      return weights;
    }),
    contained: probes.map((probe) => ids.filter((id) => view.contains(id, ...there(probe)))),
    neighbors: neighborsOf(view, ids, curves, beside, scale),
  };
  if (isFitted) facts.fitted = fittedOf(view, facts, scale);
  return facts;
}

/** Returns, by site, those with which it has an edge longer than rounding can make it. */
function neighborsOf(view, ids, curves, beside, scale) {
  const lengths = ids.map(() => new Map());
  beside.forEach((id, k) => {
    const other = beside[k ^ 1];
    const length = lengthOfCurves(curves.subarray(7 * (k >> 1), 7 * (k >> 1) + 7)) / scale;
    lengths[id].set(other, (lengths[id].get(other) ?? 0) + length);
  });
  return ids.map((id) =>
    [...view.neighbors(id)].filter((other) => lengths[id].get(other) > 0.05).sort((a, b) => a - b),
  );
}

/** The areas with weights for equal ones. */
function fittedOf(view, { areas }, scale) {
  const places = new Set();
  for (const { x, y } of view.diagram) if (view.window.contains(x, y)) places.add(`${x} ${y}`);
  if (places.size < areas.length) return []; // not every site can have a cell
  const targets = areas.map(() => 1);
  const { weights } = view.fitAreas(targets);
  const xyr = view.diagram
    .sites()
    .xyr.map((value, k) => (k % 3 === 2 ? weights[(k - 2) / 3] : value));
  const fitted = new Diagram(xyr).voronoi([view.xmin, view.ymin, view.xmax, view.ymax]);
  return [...fitted.cellAreas()].map((area) => area / scale ** 2);
}

/**
 * How far numbers may be off. Where an edge is tangent to a side, the part between them may be
 * there or not, as long as the root of a rounding.
 */
const kClose = { areas: 1e-8, perimeters: 3e-4, edges: 3e-4, natural: 1e-7 };

function complaintOf(facts, expected, isCut, [x, y]) {
  for (const [name, value] of Object.entries(facts)) {
    const [got, wanted] = [value, expected[name]].map((list) => [list].flat(2));
    if (got.length !== wanted.length) return `${name}: ${got.length} for ${wanted.length}`;
    // Flattened curves: the same shapes, within the tolerance.
    const isFlattened =
      ["parts", "drawn", "curvesOfCells"].includes(name) || (name === "polygons" && isCut);
    const limit = isFlattened ? 6 : (kClose[name] ?? 1e-6) * (1 + Math.hypot(x, y) / 1e5);
    for (let k = 0; k < got.length; ++k)
      if (!(Math.abs(got[k] - wanted[k]) <= limit)) return `${name}[${k}]: ${got[k]}, ${wanted[k]}`;
  }
  return null;
}

/** Returns a contradiction within one view, or none. */
function contradictionOf({ window, areas, polygons, cellAreas, parts, drawn, curvesOfCells }, cut) {
  const sum = sumOf(areas);
  if (!cut && Math.abs(sum - window) > 1e-8 * window) return `areas: ${sum} of ${window}`;
  if (Math.abs(polygons - sum) > (cut ? 40 : 1e-8 * window))
    return `polygons: ${polygons} of ${sum}`;
  for (let k = 0; k < areas.length; ++k) {
    if (Math.abs(cellAreas[k] - areas[k]) > 1e-8) return `cellArea(${k}): ${cellAreas[k]}`;
    for (const [name, list] of Object.entries({ parts, drawn, curvesOfCells }))
      if (Math.abs(list[k] - areas[k]) > 6) return `${name}[${k}]: ${list[k]} of ${areas[k]}`;
  }
  return null;
}

describe.each(Object.entries(families))("%s", (name, family) => {
  test.each([
    ["a rectangle", {}],
    ["a polygon", { polygon: true }],
    ["a rectangle, cells cut at a distance", { distance: 11 }],
    ["a polygon, cells cut at a distance", { polygon: true, distance: 11 }],
  ])(
    "%s: all that a view says follows",
    (_, kind) => {
      const random = randomOf(71);
      for (let run = 0; run < (isThorough ? 400 : 12); ++run) {
        const sites = family(random);
        const isFitted = run % 6 === 0 && kind.distance === undefined && !kind.polygon;
        const first = factsOf(sites, kind, [0, 0, 1], isFitted);
        const say = (what, move) => `${what} at ${move}, run ${run}: ${JSON.stringify(sites)}`;
        const wrong = contradictionOf(first, kind.distance !== undefined);
        expect(wrong === null ? "" : say(wrong, [0, 0, 1])).toBe("");
        for (const move of name === "decimals" ? kScalings : kMoves) {
          const facts = factsOf(sites, kind, move, isFitted);
          const what = complaintOf(facts, first, kind.distance !== undefined, move);
          expect(what === null ? "" : say(what, move)).toBe("");
          const own = contradictionOf(facts, kind.distance !== undefined);
          expect(own === null ? "" : say(own, move)).toBe("");
        }
      }
    },
    1_000_000,
  );
});
