// Polygons and GeoJSON in the shapes that other tools want.
import { Diagram } from "../../build/packed/consumer.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const diagram = new Diagram(randomCircles(60, 61));
const voronoi = diagram.voronoi([0, 0, 1000, 1000]);
const corners = new Diagram([-50, 50, 0, 150, 50, 40, 50, 300, 10]).voronoi([0, 0, 100, 100]);
const square = (x, y, r) => [
  [x - r, y - r],
  [x + r, y - r],
  [x + r, y + r],
  [x - r, y + r],
];
/** A cell with a hole, and cells in a window with one. */
const framed = new Diagram([0, 0, 5]).voronoi([square(0, 0, 50), square(10, 0, 20)]);
const star = Array.from({ length: 10 }, (_, k) => [
  (k % 2 ? 400 : 900) * Math.cos(0.1 + (k * Math.PI) / 5),
  (k % 2 ? 400 : 900) * Math.sin(0.1 + (k * Math.PI) / 5),
]);
const starry = new Diagram(randomCircles(300, 62, 90)).voronoi([star, square(30, -40, 150)]);
const perimeter = (ring) =>
  ring.reduce(
    (sum, [x, y], k) => sum + Math.hypot(x - ring.at(k - 1)[0], y - ring.at(k - 1)[1]),
    0,
  );
const views = [
  ["many", voronoi, 4000],
  ["in parts", corners, 400],
  ["with a hole", framed, 400 + 160],
  ["in a star with a hole", starry, perimeter(star) + 1200],
];
/** Twice the signed area: above 0 if counter-clockwise. */
const turn = (ring) =>
  ring.slice(1).reduce((sum, [x, y], k) => sum + ring[k][0] * y - ring[k][1] * x, 0);

test("nested polygons are the flat ones, pair by pair", () => {
  for (const view of [voronoi, corners]) {
    const nested = [...view.cellPolygons({ tolerance: 0.5 })];
    const flat = [...view.cellPolygons({ flat: true, tolerance: 0.5 })];
    expect(nested.length).toBeGreaterThan(1);
    expect(nested.map(({ index }) => index)).toEqual(flat.map(({ index }) => index));
    nested.forEach((ring, k) => {
      expect(Array.isArray(ring)).toBe(true);
      expect(ring.flat()).toEqual([...flat[k]]);
      const { index } = ring;
      expect([...view.cellPolygon(index, { flat: false, tolerance: 0.5 })]).toEqual([...ring]);
    });
  }
  const hidden = new Diagram([0, 0, 5, 0, 0, 1]).voronoi();
  expect(hidden.cellPolygon(1)).toBeNull();
});

test("polygons of all cells are those of each, in batches of any size", () => {
  const view = new Diagram(randomCircles(3000, 64, 5)).voronoi([100, 100, 800, 900]);
  const all = [...view.cellPolygons()];
  expect(all.length).toBeGreaterThan(400);
  for (const ring of all) expect([...ring]).toEqual(view.cellPolygon(ring.index));
  expect(all.map(({ index }) => index)).toEqual(
    [...view.diagram.ids()].filter((id) => view.cellPolygon(id) !== null),
  );
});

test("while cells are visited, the diagram may change", () => {
  const changing = new Diagram(randomCircles(600, 65));
  const view = changing.voronoi([0, 0, 1000, 1000]);
  const [visited, removed] = [[], new Set()];
  for (const { index, ...ring } of view.cellPolygons()) {
    expect(removed).not.toContain(index);
    expect(Object.values(ring)).toEqual(view.cellPolygon(index));
    visited.push(index);
    if (visited.length % 20 !== 0 || !changing.has(index + 1)) continue;
    changing.remove(index + 1);
    removed.add(index + 1);
  }
  expect(removed.size).toBeGreaterThan(5);
  expect(visited).toEqual([...new Set(visited)].sort((a, b) => a - b));
});

test("regions, too: nested ones are the flat ones, with their holes, pair by pair", () => {
  for (const [, view] of views) {
    for (const id of view.diagram.ids()) {
      const nested = view.cellParts(id, { tolerance: 0.5 });
      const flat = view.cellParts(id, { flat: true, tolerance: 0.5 });
      expect(view.cellParts(id, { flat: false, tolerance: 0.5 })).toEqual(nested);
      if (flat === null) {
        expect(nested).toBeNull();
        continue;
      }
      expect(nested.length).toBe(flat.length);
      nested.forEach((rings, k) => {
        expect(rings.map((ring) => ring.flat())).toEqual(flat[k].map((ring) => [...ring]));
        for (const ring of flat[k]) expect(ring).toBeInstanceOf(Float64Array);
        for (const ring of rings) expect(ring.at(-1)).toEqual(ring[0]);
        const [outer, ...holes] = rings;
        expect(turn(outer)).toBeGreaterThan(0);
        for (const hole of holes) expect(turn(hole)).toBeLessThan(0);
      });
      // Plain: nothing hangs on the arrays.
      expect(JSON.parse(JSON.stringify(nested))).toEqual(nested);
      expect(structuredClone(flat)).toEqual(flat);
      for (const array of [nested, ...nested, ...nested.flat()])
        expect(Object.keys(array).length).toBe(array.length);
    }
  }
  expect(framed.cellParts(0)[0].length).toBe(2);
  expect(corners.cellParts(0).length).toBeGreaterThan(0);
});

test("rings are the caller's: none is another's, or the heap's", () => {
  const [first, second] = [1, 2].map(() => framed.cellParts(0, { flat: true })[0]);
  const before = structuredClone(second);
  for (const ring of first) ring.fill(7);
  expect(second).toEqual(before);
  expect(framed.cellParts(0, { flat: true })[0]).toEqual(second);
  const ring = framed.cellPolygon(0);
  ring[0][0] = 7;
  expect(ring.at(-1)[0]).not.toBe(7); // the repeated point is another one
});

test.each([
  [{ nested: true }, "options.nested is unknown, expected { tolerance, flat }"],
  [{ nested: false }, "options.nested is unknown, expected { tolerance, flat }"],
  [{ flat: 1 }, "options.flat is 1, expected false or true"],
  [{ flat: null }, "options.flat is null, expected false or true"],
  [{ flat: "true" }, 'options.flat is the string "true", expected false or true'],
])("polygons with %j are refused", (options, message) => {
  for (const call of [
    () => voronoi.cellPolygon(0, options),
    () => voronoi.cellParts(0, options),
    () => [...voronoi.cellPolygons(options)],
  ])
    expectRefusal(call, "bad-option", message);
});

/** The polygons of a feature, each a list of rings. */
const polygonsOf = ({ geometry: { type, coordinates } }) =>
  type === "Polygon" ? [coordinates] : coordinates;

test.each(
  views,
)("GeoJSON: cells tile the window, each segment once there and back: %s", (_, view, border) => {
  for (const tolerance of [undefined, 20, 0.01]) {
    const segments = new Map();
    for (const feature of view.toGeoJSON({ tolerance }).features)
      for (const ring of polygonsOf(feature).flat())
        for (let k = 0; k + 1 < ring.length; ++k) {
          const key = `${ring[k]} ${ring[k + 1]}`;
          expect(segments.has(key)).toBe(false);
          segments.set(key, { id: feature.id, from: ring[k], to: ring[k + 1] });
        }
    let length = 0; // total of segments with no cell beside them
    for (const { id, from, to } of segments.values()) {
      const beside = segments.get(`${to} ${from}`);
      if (beside === undefined) length += Math.hypot(to[0] - from[0], to[1] - from[1]);
      else expect(beside.id).not.toBe(id);
    }
    expect(length / border).toBeCloseTo(1, 9);
  }
});

test.each(views)("GeoJSON: the polygons of a cell are its regions: %s", (_, view) => {
  const tolerance = 0.01;
  const areas = (polygons) =>
    polygons
      .map((polygon) => polygon.reduce((sum, ring) => sum + turn(ring) / 2, 0))
      .sort((a, b) => a - b);
  const { features } = view.toGeoJSON({ tolerance });
  expect(features.map(({ id }) => id)).toEqual(
    [...view.cellPolygons({ tolerance })].map(({ index }) => index),
  );
  for (const feature of features) {
    const regions = view.cellParts(feature.id, { tolerance });
    const expected = areas(regions);
    const found = areas(polygonsOf(feature));
    expect(found.length).toBe(expected.length);
    const most = 2 * tolerance * view.cellPerimeter(feature.id);
    found.forEach((area, k) => void expect(Math.abs(area - expected[k])).toBeLessThan(most));
  }
});

test("GeoJSON: properties are what the callback gives for each id", () => {
  const asked = [];
  const { features } = voronoi.toGeoJSON({
    properties(id) {
      asked.push(id);
      return { r: diagram.site(id).r };
    },
  });
  expect(features.map(({ id }) => id)).toEqual(asked);
  expect(features.map(({ properties }) => properties)).toEqual(
    asked.map((id) => ({ r: diagram.site(id).r })),
  );
  expect(voronoi.toGeoJSON().features[0].properties).toEqual({ site: features[0].id });
  const error = new Error("no name");
  expect(() =>
    voronoi.toGeoJSON({
      properties() {
        throw error;
      },
    }),
  ).toThrow(error);
});

test("GeoJSON: winding, of holes the other way round", () => {
  const frame = [
    [
      [0, 0],
      [900, 0],
      [900, 900],
      [0, 900],
      [0, 0],
    ],
    [
      [300, 300],
      [300, 600],
      [600, 600],
      [600, 300],
      [300, 300],
    ],
  ];
  const one = new Diagram([450, 100, 10]).voronoi({ type: "Polygon", coordinates: frame });
  for (const [view, holes] of [
    [voronoi, 0],
    [one, 1],
  ]) {
    const rings = (options) =>
      view
        .toGeoJSON(options)
        .features.flatMap(({ geometry: { type, coordinates } }) =>
          type === "Polygon" ? [coordinates] : coordinates,
        );
    const [usual, turned] = [rings({}), rings({ winding: "clockwise" })];
    expect(usual.flatMap((polygon) => polygon.slice(1)).length).toBe(holes);
    for (const [outer, ...inner] of usual) {
      expect(turn(outer)).toBeGreaterThan(0);
      for (const hole of inner) expect(turn(hole)).toBeLessThan(0);
    }
    expect(turned).toEqual(usual.map((polygon) => polygon.map((ring) => [...ring].reverse())));
    expect(rings({ winding: "counter-clockwise" })).toEqual(usual);
  }
});
