// Shapes as other tools take them: JTS, which PostGIS, QGIS and many others follow, judges each
// feature; all together they tile the window, whatever the tolerance.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { feature } from "topojson-client";
import { Diagram } from "../../build/packed/consumer.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator } from "./support/random.mjs";

const reader = new GeoJSONReader();
const tolerances = [undefined, 1e-6, 0.5, 100];

const polygonsOf = ({ geometry: { type, coordinates } }) =>
  type === "Polygon" ? [coordinates] : coordinates;

function areaOf(ring) {
  const [x0, y0] = ring[0];
  return (
    ring
      .slice(1)
      .reduce(
        (sum, [x, y], k) => sum + (ring[k][0] - x0) * (y - y0) - (x - x0) * (ring[k][1] - y0),
        0,
      ) / 2
  );
}

/** Is a segment on a side of these rings, up to rounding? */
function onBorderOf(rings) {
  const sides = rings.flatMap((ring) => ring.map((p, k) => [p, ring[(k + 1) % ring.length]]));
  const rounding = 1e-11 * Math.max(...rings.flat(2).map(Math.abs));
  return (...ends) =>
    sides.some(([[ax, ay], [bx, by]]) => {
      const length = Math.hypot(bx - ax, by - ay);
      const off = ([x, y]) => Math.abs((x - ax) * (by - ay) - (y - ay) * (bx - ax)) / length;
      return length > 0 && ends.every((p) => off(p) <= rounding);
    });
}

/** Says what is wrong with features that are to tile a window of these rings. */
function faultsIn({ features }, rings) {
  const faults = [];
  const isOnBorder = onBorderOf(rings);
  const segments = new Map();
  for (const { id, geometry } of features) {
    const validity = new IsValidOp(reader.read(geometry));
    if (!validity.isValid()) faults.push(`${id}: ${validity.getValidationError()}`);
    for (const ring of polygonsOf({ geometry }).flat()) {
      for (let k = 1; k < ring.length; ++k) {
        const key = `${ring[k - 1]} ${ring[k]}`;
        if (segments.has(key)) faults.push(`twice: ${key}`);
        segments.set(key, [ring[k - 1], ring[k]]);
      }
    }
  }
  for (const [key, [p, q]] of segments)
    if (!segments.has(`${q} ${p}`) && !isOnBorder(p, q)) faults.push(`open: ${key}`);
  return faults;
}

const sumOf = ({ features }) =>
  features.flatMap((one) => polygonsOf(one).flat()).reduce((sum, ring) => sum + areaOf(ring), 0);

const box = [
  [0, 0],
  [100, 0],
  [100, 60],
  [0, 60],
];
const star = (x, y, r, points) =>
  Array.from({ length: 2 * points }, (_, k) => {
    const [angle, reach] = [(Math.PI * k) / points, k % 2 === 0 ? r : r / 2];
    return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)];
  });
const windows = {
  "a box": [box],
  "a star with a hole": [star(50, 30, 29, 7), star(50, 30, 9, 5)],
  "a hole that touches the border": [
    box,
    [
      [0, 30],
      [20, 50],
      [60, 50],
      [60, 10],
    ],
  ],
};

const random = generator(38);
const below = (n) => Math.floor(n * random());
const sets = {
  "any numbers": () => [100 * random(), 60 * random(), 20 * random() ** 3],
  "one decimal place": () => [below(1000) / 10, below(600) / 10, below(30) / 10],
  "large integers": () => [below(100), below(60), below(45)],
  "a lattice": () => [10 * below(10), 10 * below(6), below(4)],
};

describe.each(Object.entries(windows))("in %s", (_, rings) => {
  const whole = rings.reduce((sum, ring) => sum - Math.abs(areaOf([...ring, ring[0]])), 0);
  const expected = 2 * Math.abs(areaOf([...rings[0], rings[0][0]])) + whole;

  test.each(Object.entries(sets))("%s", (_, circle) => {
    for (const n of isThorough ? [1, 2, 3, 5, 20, 80] : [1, 2, 3, 30]) {
      const diagram = new Diagram(Array.from({ length: n }, circle).flat());
      for (const tolerance of tolerances) {
        const collection = diagram.voronoi(rings).toGeoJSON({ tolerance });
        expect(faultsIn(collection, rings)).toEqual([]);
        expect(Math.abs(sumOf(collection) / expected - 1)).toBeLessThan(1e-9);
      }
      diagram.dispose();
    }
  });

  test("many on one circle, where rounding makes a knot of vertices", () => {
    const xyr = Array.from({ length: 30 }, (_, k) => [
      50 + 25 * Math.cos((2 * Math.PI * k) / 30),
      30 + 25 * Math.sin((2 * Math.PI * k) / 30),
      0.5,
    ]);
    const voronoi = new Diagram(xyr.flat()).voronoi(rings);
    for (const tolerance of tolerances)
      expect(faultsIn(voronoi.toGeoJSON({ tolerance }), rings)).toEqual([]);
    for (const index of voronoi.diagram.ids()) {
      const parts = voronoi.cellParts(index) ?? [];
      const geometry = {
        type: "MultiPolygon",
        coordinates: parts,
      };
      expect(new IsValidOp(reader.read(geometry)).isValid()).toBe(true);
    }
  });
});

test("countries", () => {
  const atlas = JSON.parse(
    readFileSync(createRequire(import.meta.url).resolve("world-atlas/countries-110m.json"), "utf8"),
  );
  const { features } = feature(atlas, atlas.objects.countries);
  for (const country of features.filter((_, k) => isThorough || k % 8 === 0)) {
    const rings = polygonsOf(country).flat();
    const [xs, ys] = [0, 1].map((k) => rings.flat().map((p) => p[k]));
    const [left, bottom] = [Math.min(...xs), Math.min(...ys)];
    const [width, height] = [Math.max(...xs) - left, Math.max(...ys) - bottom];
    const xyr = Array.from({ length: 12 }, () => [
      left + width * random(),
      bottom + height * random(),
      0.1 * width * random(),
    ]);
    const voronoi = new Diagram(xyr.flat()).voronoi(country);
    for (const tolerance of [undefined, 1])
      expect([
        country.properties.name,
        ...faultsIn(voronoi.toGeoJSON({ tolerance }), rings),
      ]).toEqual([country.properties.name]);
  }
});

test("what was refused before", () => {
  const cases = [
    [
      [4.93, 9.33, 5.79, 9.91, 3.51, 2.84],
      [
        [15.42, 11.98, 12.1, 13.95, 7.4, 15.94, 7.02, 11.27],
        [1.52, 7.15, 5.84, 1.63, 10.77, 6.81, 15.83, 8.53],
      ],
    ],
    [[7, 19.5, 2, 8, 2, 1.5, 10.5, 2, 2], [[0, 0, 20, 0, 20, 20, 0, 20]], [[7, 18, 9, 2, 7, 4]]],
    [[8, 11, 39, 48, 30, 1, 17, 8, 39], [[0, 0, 100, 0, 100, 60, 0, 60]]],
  ];
  const pairs = (flat) =>
    Array.from({ length: flat.length / 2 }, (_, k) => flat.slice(2 * k, 2 * k + 2));
  for (const [xyr, ...given] of cases) {
    const rings = given.map((ring) => pairs(ring.flat()));
    for (const tolerance of tolerances)
      expect(faultsIn(new Diagram(xyr).voronoi(rings).toGeoJSON({ tolerance }), rings)).toEqual([]);
  }
});

test("what is returned is a window: its holes stay holes", () => {
  const frame = [box, star(50, 30, 20, 4)];
  const voronoi = new Diagram([50, 30, 5]).voronoi(frame);
  const inner = new Diagram([10, 10, 1, 80, 40, 2]);
  const areaIn = (window) =>
    inner
      .voronoi(window)
      .cellAreas()
      .reduce((a, b) => a + b);
  const expected = voronoi.cellArea(0);
  expect(expected).toBeLessThan(6000);
  for (const window of [
    voronoi.cellParts(0),
    voronoi.cellParts(0, { flat: true }),
    voronoi.toGeoJSON(),
    voronoi.toGeoJSON().features[0],
    voronoi.cellPolygon(0),
    voronoi.cellPolygon(0, { flat: true }),
  ])
    expect(areaIn(window)).toBeCloseTo(expected, 6);
});
