// Service areas, empty circles and interpolation on the sphere, as users get them: against d3-geo,
// JTS and brute force.
import { geoArea, geoDistance } from "d3-geo";
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator } from "./support/random.mjs";

const random = generator(41);
const degrees = 180 / Math.PI;
const point = () => [360 * random() - 180, Math.asin(2 * random() - 1) * degrees];
const sites = (n, heaviest) => Array.from({ length: n }, () => [...point(), heaviest * random()]);
const distance = (lon, lat, [x, y, r]) => geoDistance([lon, lat], [x, y]) - r;
const least = (list, lon, lat) => Math.min(...list.map((site) => distance(lon, lat, site)));

const sets = [
  ["one", [[20, 30, 0.1]]],
  ["two", sites(2, 0.1)],
  [
    "two opposite",
    [
      [20, 30, 0],
      [-160, -30, 0],
    ],
  ],
  [
    "three, of which two are farthest from a place",
    [
      [0, 80, 0],
      [0, -80, 0],
      [0, 0, 0],
    ],
  ],
  ["points", sites(60, 0)],
  ["caps", sites(60, 0.2)],
  ["in a corner", sites(20, 0.01).map(([x, y, r]) => [x / 20, y / 20, r])],
  ["all covered", sites(30, 2.5)],
];

describe.each(sets)("%s", (_, list) => {
  const diagram = new SphericalDiagram(list.flat(), { radius: 10 });
  const inUnits = list.map(([lon, lat, r]) => [lon, lat, 10 * r]);
  diagram.updateMany(diagram.ids(), inUnits.flat());

  test("cells end at a distance: valid polygons with their areas", () => {
    const by = Object.fromEntries(
      list.map((_, id) => [id, id % 3 === 2 ? Infinity : 3 * random()]),
    );
    for (const reach of [-0.2, 0.5, 4, 20, by]) {
      const options = { tolerance: 1e-3 };
      const view = diagram.voronoi({ maxDistance: reach });
      const areas = view.cellAreas();
      const perimeters = view.cellPerimeters();
      const { features } = view.toGeoJSON({ ...options, winding: "clockwise" });
      const shown = new Set(features.map(({ id }) => id));
      for (const feature of features) {
        const { id } = feature;
        expect(geoArea(feature)).toBeCloseTo(areas[id] / 100, 2);
        expect(view.cellArea(id)).toBe(areas[id]);
        expect(view.cellPerimeter(id)).toBe(perimeters[id]);
        const centroid = view.cellCentroid(id);
        expect(centroid.every(Number.isFinite)).toBe(true);
      }
      for (const id of diagram.ids()) if (!shown.has(id)) expect(areas[id]).toBeCloseTo(0, 12);
      const cut = view.toGeoJSON(options);
      expect(cut.features.map(({ id }) => id)).toEqual([...shown]);
      for (const { geometry } of cut.features)
        expect(new IsValidOp(new GeoJSONReader().read(geometry)).isValid()).toBe(true);
      const rings = [...view.cellPolygons(options)];
      expect(rings.map(({ index }) => index)).toEqual([...shown]);
      if (typeof reach === "number")
        for (const ring of rings) expect(view.cellPolygon(ring.index, options)).toEqual([...ring]);
      for (let k = 0; k < 100; ++k) {
        const [lon, lat] = point();
        const found = diagram.nearest(lon, lat);
        const most = typeof reach === "number" ? reach : reach[found.id];
        const isServed = found.distance <= most;
        expect(view.contains(found.id, lon, lat)).toBe(isServed);
      }
    }
  });

  test("the largest empty circle is the farthest place of all", () => {
    const circle = diagram.voronoi().largestEmptyCircle();
    expect(circle.r).toBeCloseTo(10 * least(list, circle.lon, circle.lat), 10);
    expect(circle.r).toBeCloseTo(10 * distance(circle.lon, circle.lat, list[circle.site]), 10);
    for (let k = 0; k < 4000; ++k) {
      const z = 1 - (2 * k + 1) / 4000;
      const lon = ((k * 137.50776405003785 + 180) % 360) - 180;
      expect(10 * least(list, lon, Math.asin(z) * degrees)).toBeLessThan(circle.r + 1e-9);
    }
  });

  test("empty circles are apart, the largest first", () => {
    const circles = diagram.voronoi().emptyCircles(8);
    for (const [k, circle] of circles.entries()) {
      expect(circle.r).toBeCloseTo(10 * least(list, circle.lon, circle.lat), 10);
      for (const one of circles.slice(0, k)) {
        expect(one.r).toBeGreaterThanOrEqual(circle.r);
        const away = 10 * geoDistance([one.lon, one.lat], [circle.lon, circle.lat]);
        expect(away).toBeGreaterThan(Math.max(one.r, 0) - 1e-12);
      }
    }
    expect(diagram.voronoi().emptyCircles(0)).toEqual([]);
  });

  test("interpolation is the sum of weights and values, whichever way they come", () => {
    const values = Float64Array.from(list, random);
    const points = Array.from({ length: 50 }, point);
    const found = diagram.voronoi().interpolate(values, points.flat(), { r: 0.1 });
    const sums = points.map(([lon, lat]) => {
      const { ids, weights } = diagram.voronoi().naturalWeights(lon, lat, { r: 0.1 });
      expect(weights.reduce((a, b) => a + b)).toBeCloseTo(1, 13);
      return weights.reduce((sum, weight, k) => sum + weight * values[ids[k]], 0);
    });
    for (const [k, sum] of sums.entries()) expect(found[k]).toBeCloseTo(sum, 12);
    const map = new Map(values.entries());
    expect(diagram.voronoi().interpolate(map, points.flat(), { r: 0.1 })).toEqual(found);
  });
});

test("of very many sites, too", () => {
  const many = new SphericalDiagram(sites(100_000, 0).flat());
  const { lon, lat, r, site } = many.voronoi().largestEmptyCircle();
  expect(many.nearest(lon, lat).distance).toBeCloseTo(r, 12);
  const { lon: x, lat: y } = many.site(site);
  expect(geoDistance([lon, lat], [x, y])).toBeCloseTo(r, 12);
  const values = new Float64Array(100_000).fill(2);
  for (const value of many.voronoi().interpolate(values, [10, 20, lon, lat]))
    expect(value).toBeCloseTo(2, 12);
});

test("without sites there is nothing", () => {
  const empty = new SphericalDiagram();
  expect(empty.voronoi().largestEmptyCircle()).toBeNull();
  expect(empty.voronoi().emptyCircles(3)).toEqual([]);
  expect(empty.voronoi().naturalWeights(1, 2)).toBeNull();
  expect([...empty.voronoi().interpolate([], [1, 2, 3, 4])]).toEqual([NaN, NaN]);
  expect(empty.voronoi({ maxDistance: 1 }).cellAreas()).toEqual(new Float64Array());
  expect(empty.voronoi({ maxDistance: 1 }).toGeoJSON().features).toEqual([]);
});

test("a hidden site has no area and no perimeter, as on the plane", () => {
  const pair = new SphericalDiagram([10, 20, 0.5, 10, 21, 0.1]);
  expect(pair.isHidden(1)).toBe(true);
  for (const maxDistance of [undefined, 1, [1, 2]]) {
    const view = pair.voronoi({ maxDistance });
    expect(view.cellMeasures(1)).toEqual({ area: 0, centroid: null, perimeter: 0 });
    expect([view.cellArea(1), view.cellPerimeter(1), view.cellCentroid(1)]).toEqual([0, 0, null]);
    expect([view.cellAreas()[1], view.cellPerimeters()[1]]).toEqual([0, 0]);
    expect([...view.cellCentroids().subarray(2)]).toEqual([NaN, NaN]);
    expect([view.cellPolygon(1), view.cellGeometry(1)]).toEqual([null, null]);
    expect(view.neighbors(1)).toHaveLength(0);
    expect(view.contains(1, 10, 21)).toBe(false);
  }
});

test("a distance as far as the opposite point cuts nothing off, one below the centre all", () => {
  const one = new SphericalDiagram([10, 20, 0.5]);
  const all = one.voronoi({ maxDistance: 3 });
  expect(all.cellArea(0)).toBe(4 * Math.PI);
  expect(all.cellPerimeter(0)).toBe(0);
  expect(() => all.cellPolygon(0)).toThrow(expect.objectContaining({ code: "out-of-range" }));
  expect(all.cellGeometry(0, { winding: "clockwise" })).toEqual({ type: "Sphere" });
  const none = one.voronoi({ maxDistance: -0.5 });
  expect([none.cellPolygon(0), none.cellGeometry(0), none.cellCentroid(0)]).toEqual(
    Array(3).fill(null),
  );
  const { features } = all.toGeoJSON({ antimeridian: "keep" });
  expect(features[0].geometry).toEqual({ type: "Sphere" });
});
