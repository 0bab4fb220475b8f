// Cells that end at a distance from their circles: `voronoi(window, { distance })`, against sampled
// points, and as other tools take them.
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { Diagram } from "../../build/packed/consumer.mjs";
import { isThorough } from "../support/effort.mjs";
import { box, windows, withHole } from "./support/box_with_hole.mjs";
import { generator } from "./support/random.mjs";

const reader = new GeoJSONReader();
function someCircles(random, count) {
  return Array.from({ length: count }, () => [100 * random(), 60 * random(), 6 * random() ** 2]);
}

/** The area of each cell, by a grid of points. */
function sampled(diagram, distances, holds, step) {
  const areas = new Float64Array(distances.length);
  for (let x = step / 2; x < 100; x += step)
    for (let y = step / 2; y < 60; y += step) {
      const { id, distance } = diagram.nearest(x, y);
      if (distance <= distances[id] && holds(x, y)) areas[id] += step * step;
    }
  return areas;
}

test.each(windows)("measures in %s are those of sampled points", (_name, window, holds) => {
  const random = generator(31);
  for (let run = 0; run < 6; ++run) {
    const circles = someCircles(random, 12);
    const diagram = Diagram.from(circles);
    const distances = circles.map(() => (run % 2 === 0 ? 7 : 15 * random()));
    const view = diagram.voronoi(window, { distance: run % 2 === 0 ? 7 : distances });
    const expected = sampled(diagram, distances, holds, 0.25);
    const areas = view.cellAreas();
    const centroids = view.cellCentroids();
    const perimeters = view.cellPerimeters();
    for (const id of diagram.ids()) {
      expect(Math.abs(areas[id] - expected[id])).toBeLessThan(12);
      const measures = view.cellMeasures(id);
      if (measures === null) continue;
      expect(measures.area).toBeCloseTo(areas[id], 8);
      expect(measures.perimeter).toBeCloseTo(perimeters[id], 8);
      if (measures.centroid === null) continue;
      expect(measures.centroid[0]).toBeCloseTo(centroids[2 * id], 6);
      expect(measures.centroid[1]).toBeCloseTo(centroids[2 * id + 1], 6);
    }
  }
});

const areaOf = (ring) =>
  ring.slice(1).reduce((sum, [x, y], k) => sum + ring[k][0] * y - x * ring[k][1], 0) / 2;

// The tolerance was a share of the window: small cells were octagons.
test.each([
  0.01, 0.1, 1, 5, 20, 80,
])("at distance %p, polygons have their cells' areas by default", (distance) => {
  const view = new Diagram([500, 300, 0, 520, 300, 0]).voronoi([0, 0, 1000, 600], { distance });
  const isNear = (area, id) => expect(Math.abs(area / view.cellArea(id) - 1)).toBeLessThan(0.005);
  for (const { id, geometry } of view.toGeoJSON().features)
    isNear(areaOf(geometry.coordinates[0]), id);
  for (const ring of view.cellPolygons()) isNear(areaOf(ring), ring.index);
  for (const id of [0, 1]) {
    isNear(areaOf(view.cellPolygon(id)), id);
    expect(view.cellPolygon(id).length).toBeLessThan(100);
    expect(view.renderCell(id)).toMatch(/C/);
    // A tolerance that is given is kept.
    expect(view.cellPolygon(id, { tolerance: 1000 }).length).toBeLessThan(12);
  }
});

test("polygons are valid, share their points, and have the areas of the cells", () => {
  const random = generator(32);
  for (let run = 0; run < (isThorough ? 8 : 2); ++run) {
    const circles = someCircles(random, 20);
    const distance = run % 2 === 0 ? 5 : circles.map(() => 12 * random());
    for (const window of [box, withHole]) {
      const view = Diagram.from(circles).voronoi(window, { distance });
      for (const tolerance of [1e-4, 1, 50]) {
        const segments = new Map();
        const twice = [];
        let sum = 0;
        for (const { id, geometry } of view.toGeoJSON({ tolerance }).features) {
          expect(new IsValidOp(reader.read(geometry)).isValid()).toBe(true);
          const polygons =
            geometry.type === "Polygon" ? [geometry.coordinates] : geometry.coordinates;
          for (const ring of polygons.flat()) {
            sum += areaOf(ring);
            ring.slice(1).forEach((p, k) => {
              const key = `${ring[k]} ${p}`;
              if (segments.has(key)) twice.push(`${key}, of ${segments.get(key)} and ${id}`);
              segments.set(key, id);
            });
          }
        }
        expect(twice).toEqual([]);
        if (tolerance < 1) {
          const total = view.cellAreas().reduce((a, b) => a + b);
          expect(Math.abs(sum - total)).toBeLessThan(0.1);
          for (const id of view.diagram.ids())
            for (const neighbor of view.neighbors(id))
              expect([...view.neighbors(neighbor)]).toContain(id);
        }
      }
    }
  }
});

test("one circle alone becomes a larger circle, drawn as such", () => {
  const view = new Diagram([50, 30, 4]).voronoi(box, { distance: 6 });
  expect(view.cellArea(0)).toBeCloseTo(100 * Math.PI, 9);
  expect(view.cellPerimeter(0)).toBeCloseTo(20 * Math.PI, 9);
  expect([...view.cellCurves(0).neighbors]).toEqual([-1, -1, -1, -1]);
  expect(view.renderCell(0)).toMatch(/^M60,30C.*Z$/);
  expect(view.render()).toMatch(/^M60,30C/);
  expect(view.edgeCurves().sites).toHaveLength(0);
  expect(view.contains(0, 59.9, 30)).toBe(true);
  expect(view.contains(0, 60.1, 30)).toBe(false);
  expect(new Diagram([50, 30, 4]).voronoi(box, { distance: -4 }).cellArea(0)).toBe(0);
  expect(new Diagram([50, 30, 4]).voronoi(box, { distance: -4 }).cellPolygon(0)).toBe(null);
});

test("a distance of Infinity is none", () => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9, 50, 10, 1]);
  const plain = diagram.voronoi(box);
  for (const distance of [Infinity, undefined, [Infinity, Infinity, Infinity]]) {
    const view = diagram.voronoi(box, { distance });
    expect([...view.cellAreas()].map((area) => area.toFixed(9))).toEqual(
      [...plain.cellAreas()].map((area) => area.toFixed(9)),
    );
    expect(view.toGeoJSON()).toEqual(plain.toGeoJSON());
  }
});

test("distances by id are an array, a Map or an object, and belong to the ids of that time", () => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9]);
  const areas = [1, 2].map((r, k) => Math.PI * ([4, 9][k] + r) ** 2);
  for (const distance of [
    [1, 2],
    new Float32Array([1, 2]),
    new Map([
      [0, 1],
      [1, 2],
    ]),
    { 0: 1, 1: 2 },
  ]) {
    const view = diagram.voronoi(box, { distance });
    expect(view.cellArea(0)).toBeCloseTo(areas[0], 9);
    expect(view.cellArea(1)).toBeCloseTo(areas[1], 9);
  }
  const view = diagram.voronoi(box, { distance: [1, 2] });
  diagram.insert(1, 1, 1);
  expect(() => view.cellAreas()).toThrow(expect.objectContaining({ code: "bad-length" }));
  expect(() => view.contains(2, 1, 1)).toThrow(expect.objectContaining({ code: "bad-length" }));
});

test.each([
  [NaN, "not-finite", /distance is NaN/],
  ["3", "not-finite", /distance is the string "3"/],
  [-Infinity, "not-finite", /distance is -Infinity/],
  [1e200, "out-of-range", /distance is 1e\+200/],
  [[1], "bad-length", /distance has 1 elements, expected 2/],
  [[1, NaN], "not-finite", /distance\[1\] is NaN/],
  [{ 0: 1 }, "bad-option", /none for site 1/],
  [{ 7: 1 }, "unknown-site", /7/],
])("a distance of %p is refused", (distance, code, message) => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9]);
  expect(() => diagram.voronoi(box, { distance })).toThrow(
    expect.objectContaining({ code, message: expect.stringMatching(message) }),
  );
  expect(diagram.size).toBe(2);
});

test("areas cannot be prescribed then; a view can be disposed of", async () => {
  const view = new Diagram([20, 30, 4, 70, 40, 9]).voronoi(box, { distance: 3 });
  expect(() => view.fitAreas([1, 1])).toThrow(expect.objectContaining({ code: "bad-option" }));
  await expect(view.fitAreasAsync([1, 1])).rejects.toMatchObject({ code: "bad-option" });
  view.dispose();
  expect(() => view.cellAreas()).toThrow(expect.objectContaining({ code: "disposed" }));
});
