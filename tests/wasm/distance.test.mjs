// Cells that end at a distance from their circles, `voronoi(window, { maxDistance })`: against
// sampled points, and as other tools take them.
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
    const view = diagram.voronoi(window, { maxDistance: run % 2 === 0 ? 7 : distances });
    const expected = sampled(diagram, distances, holds, 0.25);
    const areas = view.cellAreas();
    const centroids = view.cellCentroids();
    const perimeters = view.cellPerimeters();
    for (const id of diagram.ids()) {
      expect(Math.abs(areas[id] - expected[id])).toBeLessThan(12);
      const measures = view.cellMeasures(id);
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
  const view = new Diagram([500, 300, 0, 520, 300, 0]).voronoi([0, 0, 1000, 600], {
    maxDistance: distance,
  });
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
      const view = Diagram.from(circles).voronoi(window, { maxDistance: distance });
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
  const view = new Diagram([50, 30, 4]).voronoi(box, { maxDistance: 6 });
  expect(view.cellArea(0)).toBeCloseTo(100 * Math.PI, 9);
  expect(view.cellPerimeter(0)).toBeCloseTo(20 * Math.PI, 9);
  expect([...view.cellCurves(0).neighbors]).toEqual([-1, -1, -1, -1]);
  expect(view.renderCell(0)).toMatch(/^M60,30C.*Z$/);
  expect(view.render()).toMatch(/^M60,30C/);
  expect(view.edgeCurves().sites).toHaveLength(0);
  expect(view.contains(0, 59.9, 30)).toBe(true);
  expect(view.contains(0, 60.1, 30)).toBe(false);
  expect(new Diagram([50, 30, 4]).voronoi(box, { maxDistance: -4 }).cellArea(0)).toBe(0);
  expect(new Diagram([50, 30, 4]).voronoi(box, { maxDistance: -4 }).cellPolygon(0)).toBe(null);
});

test("a distance of Infinity is none", () => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9, 50, 10, 1]);
  const plain = diagram.voronoi(box);
  for (const distance of [Infinity, undefined, [Infinity, Infinity, Infinity]]) {
    const view = diagram.voronoi(box, { maxDistance: distance });
    expect([...view.cellAreas()].map((area) => area.toFixed(9))).toEqual(
      [...plain.cellAreas()].map((area) => area.toFixed(9)),
    );
    expect(view.toGeoJSON()).toEqual(plain.toGeoJSON());
  }
});

test("distances by id are an array, a Map or an object, read when a call asks", () => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9]);
  const area = (id, by) => Math.PI * ([4, 9, 1][id] + by) ** 2;
  const typed = new Float32Array([1, 2]);
  const map = new Map([
    [0, 1],
    [1, 2],
    [77, 5], // not asked for
  ]);
  for (const maxDistance of [[1, 2], typed, map, { 0: 1, 1: 2 }]) {
    const view = diagram.voronoi(box, { maxDistance });
    expect(view.cellArea(0)).toBeCloseTo(area(0, 1), 9);
    expect([...view.cellAreas()]).toEqual([0, 1].map((id) => expect.closeTo(area(id, 1 + id), 9)));
    if (maxDistance === map) map.set(0, 3);
    else maxDistance[0] = 3;
    expect(view.cellArea(0)).toBeCloseTo(area(0, 3), 9);
    expect(view.cellAreas()[0]).toBeCloseTo(area(0, 3), 9);
  }
  // A site that came later needs one, of calls that ask for it.
  const list = [1, 2];
  const view = diagram.voronoi(box, { maxDistance: list });
  expect(diagram.insert(5, 5, 1)).toBe(2);
  expect(view.cellArea(0)).toBeCloseTo(area(0, 1), 9);
  const message = expect.stringMatching(
    /options\.maxDistance is an array of 2 that has none for site 2: add/,
  );
  for (const ask of [
    () => view.cellAreas(),
    () => view.cellArea(2),
    () => view.contains(2, 5, 5),
    () => view.render(),
    () => [...view.cellPolygons()],
    () => view.interpolate([1, 2, 3], [5, 5]),
  ])
    expect(ask).toThrow(expect.objectContaining({ code: "bad-option", message }));
  expect(view.contains(0, 5, 5)).toBe(false);
  list.push(1);
  expect(view.cellArea(2)).toBeCloseTo(area(2, 1), 9);
});

test("a function is asked for one site by calls about one cell, for all by others", async () => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9, 50, 10, 1, 50, 10, 0.5]);
  const list = [6, 2, Infinity, 3];
  let asked = [];
  const maxDistance = (id) => {
    asked.push(id);
    return list[id];
  };
  const view = diagram.voronoi(box, { maxDistance });
  expect(asked).toEqual([]);
  const same = diagram.voronoi(box, { maxDistance: list });
  const values = [1, 2, 3, 4];
  const points = [22, 30, 0, 59, 70, 40];
  const all = [0, 1, 2, 3];
  const calls = [
    [(v) => v.cellArea(1), [1]],
    [(v) => v.cellArea(3), [3]],
    [(v) => v.cellCentroid(0), [0]],
    [(v) => v.cellPerimeter(0), [0]],
    [(v) => v.cellMeasures(0), [0]],
    [(v) => v.renderCell(0), [0]],
    [(v) => v.cellPolygon(0), [0]],
    [(v) => v.cellParts(0), [0]],
    [(v) => v.cellGeometry(0), [0]],
    [(v) => v.cellCircle(0), [0]],
    [(v) => v.contains(0, 22, 30), [0]],
    [(v) => v.contains(0, 70, 40), []], // not the nearest
    [(v) => v.contains(1, 70, 40), [1]],
    [(v) => v.naturalWeights(70, 40), [1]],
    [(v) => v.neighbors(0), [0, 1, 2]],
    [(v) => v.cellCurves(0), [0, 1, 2]],
    [(v) => v.edgeCurves(), all],
    [(v) => v.cellAreas(), all],
    [(v) => v.cellCentroids(), all],
    [(v) => v.cellPerimeters(), all],
    [(v) => v.cellCircles(), all],
    [(v) => v.render(), all],
    [(v) => v.renderCells(), all],
    [(v) => v.cellMesh(), all],
    [(v) => v.toGeoJSON(), all],
    [(v) => [...v.cellPolygons()], all],
    [(v) => v.interpolate(values, points), all],
    [(v) => v.renderBounds(), []],
    [(v) => v.largestEmptyCircle(), []],
  ];
  for (const [call, expected] of calls) {
    asked = [];
    const answer = call(view);
    expect(asked).toEqual(expected);
    expect(answer).toEqual(call(same));
    expect(call(same)).toEqual(
      call(diagram.voronoi(box, { maxDistance: new Map(list.entries()) })),
    );
  }
  asked = [];
  expect(await view.interpolateAsync(values, points)).toEqual(view.interpolate(values, points));
  expect(asked).toEqual([...all, ...all]);
  // Loops keep the distances that they had at the start.
  asked = [];
  const rings = view.cellPolygons();
  rings.next();
  diagram.insert(90, 50, 0);
  list[2] = 0;
  expect(asked).toEqual(all);
  expect([...rings].map((ring) => ring.index)).toEqual([1, 2]);
  expect(asked).toEqual(all);
});

test("a function may not change the diagram, and its errors are the caller's", () => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9]);
  const busy = expect.objectContaining({ code: "busy" });
  const before = diagram.sites();
  for (const change of [
    () => diagram.insert(1, 1, 1),
    () => diagram.remove(0),
    () => diagram.dispose(),
    () => diagram.voronoi(box).fitAreas([1, 1]),
  ]) {
    const view = diagram.voronoi(box, { maxDistance: change });
    for (const ask of [
      () => view.cellArea(0),
      () => view.cellAreas(),
      () => view.contains(0, 9, 9),
    ])
      expect(ask).toThrow(busy);
  }
  const own = new Error("mine");
  const failing = diagram.voronoi(box, {
    maxDistance: () => {
      throw own;
    },
  });
  expect(() => failing.cellAreas()).toThrow(own);
  expect(diagram.sites()).toEqual(before);
  expect(diagram.insert(50, 50, 0)).toBe(2); // no longer busy
});

test("a view disposed of by the function says so", () => {
  const view = new Diagram([20, 30, 4, 70, 40, 9]).voronoi(box, {
    maxDistance: () => {
      view.dispose();
      return 3;
    },
  });
  expect(() => view.cellAreas()).toThrow(expect.objectContaining({ code: "disposed" }));
});

test.each([
  [NaN, "not-finite", /maxDistance is NaN/],
  ["3", "not-finite", /maxDistance is the string "3"/],
  [null, "not-finite", /maxDistance is null/],
  [-Infinity, "not-finite", /maxDistance is -Infinity/],
  [1e200, "out-of-range", /maxDistance is 1e\+200/],
])("a maxDistance of %p is refused at once", (maxDistance, code, message) => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9]);
  expect(() => diagram.voronoi(box, { maxDistance })).toThrow(
    expect.objectContaining({ code, message: expect.stringMatching(message) }),
  );
});

test.each([
  [[1], "bad-option", /an array of 1 that has none for site 1: add it there, or give a function/],
  [[1, NaN], "not-finite", /maxDistance of site 1 is NaN/],
  [[1, "2"], "not-finite", /maxDistance of site 1 is the string "2"/],
  [{ 0: 1 }, "bad-option", /an object that has none for site 1/],
  [new Map(), "bad-option", /none for site 0/],
  [() => undefined, "not-finite", /maxDistance of site 0 is undefined/],
  [(id) => -id * 1e200, "out-of-range", /maxDistance of site 1 is -1e\+200/],
])("a maxDistance of %p is refused when it is read", (maxDistance, code, message) => {
  const diagram = new Diagram([20, 30, 4, 70, 40, 9]);
  const view = diagram.voronoi(box, { maxDistance });
  expect(() => view.cellAreas()).toThrow(
    expect.objectContaining({ code, message: expect.stringMatching(message) }),
  );
  expect(diagram.size).toBe(2);
});

// Inclusive and exact, where the rounded distance may be either.
test("a point at the limit is in the cell; what is contained is what is found within it", () => {
  const diagram = new Diagram([0, 0, 1, 100, 0, 1]);
  const view = diagram.voronoi([-10, -10, 110, 10], { maxDistance: 4 });
  expect([view.contains(0, 3, 4), view.contains(0, 5, 0)]).toEqual([true, true]);
  expect(view.contains(0, 5.000000000000001, 0)).toBe(false);
  const random = generator(33);
  for (let run = 0; run < 300; ++run) {
    const [x, y] = [random() * 6, random() * 6];
    const { distance } = diagram.nearest(x, y);
    const exactly = diagram.voronoi([-10, -10, 110, 10], { maxDistance: distance });
    expect(exactly.contains(0, x, y)).toBe(diagram.within(x, y, distance).length > 0);
  }
});

test("values and weights end where the cells do", () => {
  const random = generator(34);
  const circles = someCircles(random, 15);
  const diagram = Diagram.from(circles);
  const limits = circles.map(() => 8 * random());
  const values = circles.map(() => random());
  const whole = diagram.voronoi(box);
  for (const maxDistance of [5, limits, (id) => limits[id]]) {
    const view = diagram.voronoi(box, { maxDistance });
    const points = Array.from({ length: 400 }, (_, k) => (k % 2 ? 60 : 100) * random());
    const field = view.interpolate(values, points);
    const expected = whole.interpolate(values, points);
    for (let k = 0; k < field.length; ++k) {
      const [x, y] = [points[2 * k], points[2 * k + 1]];
      const { id, distance } = diagram.nearest(x, y);
      const isWithin = distance <= (maxDistance === 5 ? 5 : limits[id]);
      expect(field[k]).toBe(isWithin ? expected[k] : NaN);
      expect(view.naturalWeights(x, y)).toEqual(isWithin ? whole.naturalWeights(x, y) : null);
      expect(view.contains(id, x, y)).toBe(isWithin);
    }
    expect(field.some(Number.isNaN) && !field.every(Number.isNaN)).toBe(true);
  }
});

test("areas cannot be prescribed then; a view can be disposed of", async () => {
  const view = new Diagram([20, 30, 4, 70, 40, 9]).voronoi(box, { maxDistance: 3 });
  expect(() => view.fitAreas([1, 1])).toThrow(expect.objectContaining({ code: "bad-option" }));
  await expect(view.fitAreasAsync([1, 1])).rejects.toMatchObject({ code: "bad-option" });
  view.dispose();
  expect(() => view.cellAreas()).toThrow(expect.objectContaining({ code: "disposed" }));
});
