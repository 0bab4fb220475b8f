// Groups of cells as GeoJSON, against the segments of their cells: exactly those remain that no
// other cell of the group has in the other direction.
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator, randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const reader = new GeoJSONReader();
const isValid = (geometry) => IsValidOp.isValid(reader.read(geometry));

const star = Array.from({ length: 10 }, (_, k) => [
  (k % 2 ? 400 : 900) * Math.cos(0.1 + (k * Math.PI) / 5),
  (k % 2 ? 400 : 900) * Math.sin(0.1 + (k * Math.PI) / 5),
]);
const lake = [
  [-100, -120],
  [150, -90],
  [20, 160],
];
const lattice = Array.from({ length: 144 }, (_, k) => [
  -550 + 100 * (k % 12),
  -550 + 100 * Math.floor(k / 12),
  0,
]).flat();
const clusters = (() => {
  const random = generator(5);
  const near = (c) => c + 1e-3 * random();
  return Array.from({ length: 80 }, (_, k) => [near(90 * (k % 9)), near(-70 * (k % 7)), random()]);
})().flat();

const scenes = { circles: randomCircles(400, 71, 60), lattice, clusters };
const windows = {
  "a box": [[-700, -700, 700, 700]],
  "a star with a hole": [[star, lake]],
  "a star, within a distance": [[star, lake], { maxDistance: 60 }],
};
const groups = {
  "five in turn": (id) => id % 5,
  "two in turn, like a chessboard": (id) => (id + Math.floor(id / 12)) % 2 === 0,
  "one around another": (id) => (id % 12 > 2 && id % 12 < 8 && id > 30 && id < 100 ? "in" : "out"),
  "each its own": (id) => `site ${id}`,
  "all in one": () => null,
  "some in none": (id) => (id % 3 === 0 ? undefined : id % 2),
};

/** The rings of a geometry, one after the other. */
const ringsOf = ({ type, coordinates }) => (type === "Polygon" ? coordinates : coordinates.flat());
/** The segments of a geometry, as text. */
const segmentsOf = (geometry) =>
  ringsOf(geometry).flatMap((ring) => ring.slice(1).map((to, k) => `${ring[k]} ${to}`));
const reversed = (segment) => segment.split(" ").reverse().join(" ");
const areaOf = (geometry) =>
  ringsOf(geometry).reduce(
    (sum, ring) =>
      sum + ring.slice(1).reduce((all, [x, y], k) => all + ring[k][0] * y - ring[k][1] * x, 0) / 2,
    0,
  );

const cases = Object.keys(scenes).flatMap((scene) =>
  Object.keys(windows).flatMap((window) =>
    Object.keys(groups).map((name) => [scene, window, name]),
  ),
);
test.each(cases)("%s in %s: %s", (scene, window, name) => {
  const view = new Diagram(scenes[scene]).voronoi(...windows[window]);
  const group = groups[name];
  const expected = new Map(); // segments and area by key, in the order of the first sites
  for (const { id, geometry } of view.toGeoJSON().features) {
    const key = group(id);
    if (key === undefined) continue;
    const before = expected.get(key) ?? { segments: [], area: 0 };
    before.segments.push(...segmentsOf(geometry));
    before.area += areaOf(geometry);
    expected.set(key, before);
  }
  const { features } = view.toGeoJSON({ group });
  expect(new Set(features.map(({ properties }) => properties.group))).toEqual(
    new Set(expected.keys()),
  );
  expect(features.length).toBe(expected.size);
  for (const { geometry, properties } of features) {
    const { segments, area } = expected.get(properties.group);
    const all = new Set(segments);
    const border = segments.filter((segment) => !all.has(reversed(segment)));
    expect(segmentsOf(geometry).sort()).toEqual(border.sort());
    expect(Math.abs(areaOf(geometry) - area)).toBeLessThanOrEqual(1e-9 * 1400 ** 2);
    expect(isValid(geometry)).toBe(true);
  }
});

test("a key is the id, if it can; features in the order of first sites; properties by key", () => {
  const view = new Diagram(lattice).voronoi([-600, -600, 600, 600]);
  const teams = [{ name: "odd" }, { name: "even" }];
  const { features } = view.toGeoJSON({
    group: (id) => teams[id % 2],
    properties: ({ name }) => ({ team: name }),
  });
  expect(features.map(({ properties }) => properties)).toEqual([{ team: "odd" }, { team: "even" }]);
  expect(features.some((feature) => "id" in feature)).toBe(false);
  for (const key of [Number.NaN, Infinity, null, true, 1n]) {
    const [feature] = view.toGeoJSON({ group: () => key }).features;
    expect("id" in feature).toBe(false);
    expect(feature.properties).toEqual({ group: key });
  }
  const named = view.toGeoJSON({ group: (id) => (id < 70 ? "west" : 7), winding: "clockwise" });
  expect(named.features.map(({ id }) => id)).toEqual(["west", 7]);
  expect(areaOf(named.features[0].geometry)).toBeLessThan(0);
});

test("groups of hidden sites, of none, and on a map", () => {
  const hidden = new Diagram([0, 0, 5, 0, 0, 1, 20, 0, 1]).voronoi([-50, -50, 50, 50]);
  expect(hidden.toGeoJSON({ group: (id) => id }).features.map(({ id }) => id)).toEqual([0, 2]);
  expect(hidden.toGeoJSON({ group: () => undefined }).features).toEqual([]);
  expect(new Diagram().voronoi().toGeoJSON({ group: () => 1 }).features).toEqual([]);
  const project = ([x, y]) => [x, y + x * x];
  project.invert = ([x, y]) => [x, y - x * x];
  const map = new Diagram([0.1, 0, 0, 0.9, 0.8, 0, 0.5, 0.3, 0]).voronoi([0, 0, 1, 1], { project });
  const [one] = map.toGeoJSON({ group: () => "all" }).features;
  expect(areaOf(one.geometry)).toBeCloseTo(
    map.toGeoJSON().features.reduce((sum, { geometry }) => sum + areaOf(geometry), 0),
    12,
  );
});

test("what is no function is refused, and what a function throws comes through", () => {
  const view = new Diagram([0, 0, 5]).voronoi();
  expectRefusal(
    () => view.toGeoJSON({ group: "name" }),
    "bad-option",
    'options.group is the string "name"',
  );
  const group = () => 1;
  expectRefusal(() => view.toGeoJSON({ group, properties: {} }), "bad-option", "of a key");
  const thrown = new Error("mine");
  expect(() =>
    view.toGeoJSON({
      group() {
        throw thrown;
      },
    }),
  ).toThrow(thrown);
});
