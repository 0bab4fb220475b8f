// Polygons and GeoJSON in the shapes that other tools want.
import { Diagram } from "../../build/packed/consumer.mjs";
import { randomCircles } from "./support/random.mjs";

const diagram = new Diagram(randomCircles(60, 61));
const voronoi = diagram.voronoi([0, 0, 1000, 1000]);
const corners = new Diagram([-50, 50, 0, 150, 50, 40, 50, 300, 10]).voronoi([0, 0, 100, 100]);
/** Twice the signed area: above 0 if counter-clockwise. */
const turn = (ring) =>
  ring.slice(1).reduce((sum, [x, y], k) => sum + ring[k][0] * y - ring[k][1] * x, 0);

test("nested polygons are the flat ones, pair by pair", () => {
  for (const view of [voronoi, corners]) {
    const nested = [...view.cellPolygons({ nested: true, tolerance: 0.5 })];
    const flat = [...view.cellPolygons({ nested: false, tolerance: 0.5 })];
    expect(nested.length).toBeGreaterThan(1);
    expect(nested.map(({ index }) => index)).toEqual(flat.map(({ index }) => index));
    nested.forEach((ring, k) => {
      expect(Array.isArray(ring)).toBe(true);
      expect(ring.flat()).toEqual([...flat[k]]);
      const { index } = ring;
      expect([...view.cellPolygon(index, { nested: true, tolerance: 0.5 })]).toEqual([...ring]);
    });
  }
  const hidden = new Diagram([0, 0, 5, 0, 0, 1]).voronoi();
  expect(hidden.cellPolygon(1, { nested: true })).toBeNull();
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
