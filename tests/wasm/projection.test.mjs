// Maps: `voronoi(window, { project })` takes a window in longitude and latitude, and toGeoJSON
// gives polygons there.
import {
  geoAlbers,
  geoAzimuthalEquidistant,
  geoMercator,
  geoNaturalEarth1,
  geoStereographic,
} from "d3-geo";
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator } from "./support/random.mjs";

const reader = new GeoJSONReader();
const mercator = geoMercator().scale(500).translate([0, 0]);
const conic = geoAlbers().scale(900).translate([480, 250]); // parallels are arcs

function placesIn([west, south, east, north], count, seed) {
  const random = generator(seed);
  return Array.from({ length: count }, () => [
    west + (east - west) * random(),
    south + (north - south) * random(),
  ]);
}

const ringsOf = ({ geometry: { type, coordinates } }) =>
  type === "Polygon" ? coordinates : coordinates.flat();
const areaOf = (ring) =>
  ring.slice(1).reduce((sum, [x, y], k) => sum + ring[k][0] * y - x * ring[k][1], 0) / 2;

describe.each([
  ["Mercator", mercator, [-10, 36, 30, 60]],
  ["Albers", conic, [-120, 28, -75, 47]],
])("%s", (_name, project, bounds) => {
  const places = placesIn(bounds, 40, 5);
  const diagram = Diagram.from(places.map((place, k) => [...project(place), k % 5]));
  const [west, south, east, north] = bounds;
  const size = (east - west) * (north - south);
  const ring = [
    [west, south],
    [east, south],
    [east, north],
    [west, north],
  ];

  test.each([
    ["bounds", bounds],
    ["a ring", ring],
    ["GeoJSON", { type: "Polygon", coordinates: [[...ring, ring[0]]] }],
  ])("polygons fill %s of longitude and latitude, and share their points", (_what, window) => {
    const { features } = diagram.voronoi(window, { project }).toGeoJSON({ tolerance: 0.2 });
    const segments = new Set();
    let sum = 0;
    for (const feature of features) {
      expect(new IsValidOp(reader.read(feature.geometry)).isValid()).toBe(true);
      for (const points of ringsOf(feature)) {
        sum += areaOf(points);
        points.slice(1).forEach((p, k) => {
          expect(segments.has(`${points[k]} ${p}`)).toBe(false);
          segments.add(`${points[k]} ${p}`);
        });
      }
    }
    expect(features.length).toBeGreaterThan(30);
    expect(Math.abs(sum / size - 1)).toBeLessThan(2e-3);
    const open = [...segments].filter((one) => {
      const [a, b] = one.split(" ");
      return !segments.has(`${b} ${a}`);
    });
    for (const one of open) {
      const [a, b] = one.split(" ").map((p) => p.split(",").map(Number));
      const onSide = (k, side) => Math.abs(a[k] - side) < 0.1 && Math.abs(b[k] - side) < 0.1;
      expect(onSide(0, west) || onSide(0, east) || onSide(1, south) || onSide(1, north)).toBe(true);
    }
  });

  test("straight lines of the map are within the tolerance of those of the plane", () => {
    const view = diagram.voronoi(bounds, { project });
    for (const feature of view.toGeoJSON({ tolerance: 0.5 }).features.slice(0, 10)) {
      const [outer] = ringsOf(feature);
      for (let k = 1; k < outer.length; ++k) {
        const [x, y] = project([
          (outer[k - 1][0] + outer[k][0]) / 2,
          (outer[k - 1][1] + outer[k][1]) / 2,
        ]);
        const [a, b] = [project(outer[k - 1]), project(outer[k])];
        expect(Math.hypot(x - (a[0] + b[0]) / 2, y - (a[1] + b[1]) / 2)).toBeLessThan(0.51);
      }
    }
  });

  test("each place is in its cell; winding and properties are as without", () => {
    const view = diagram.voronoi(bounds, { project });
    const plain = view.toGeoJSON({ properties: (id) => ({ name: `p${id}` }) });
    const turned = view.toGeoJSON({ winding: "clockwise" });
    for (const [k, feature] of plain.features.entries()) {
      expect(feature.properties.name).toBe(`p${feature.id}`);
      expect(areaOf(ringsOf(feature)[0])).toBeGreaterThan(0);
      expect(areaOf(ringsOf(turned.features[k])[0])).toBeLessThan(0);
    }
  });
});

// A line through the middle of these maps is an S there: it is right in its own middle.
describe.each([
  ["Mercator", geoMercator],
  ["azimuthal equidistant", geoAzimuthalEquidistant],
  ["Natural Earth", geoNaturalEarth1],
  ["stereographic", geoStereographic],
])("through the middle of a map, %s", (_name, make) => {
  const project = make().scale(100).translate([0, 0]);
  const along = (a, b, part) => a.map((number, k) => number * (1 - part) + b[k] * part);
  const parts = Array.from({ length: 19 }, (_, k) => (k + 1) / 20);

  test("edges keep the tolerance", () => {
    const diagram = new Diagram([-20, 10, 0, 20, -10, 0]); // their edge is y = 2x
    const offEdge = ([x, y]) => Math.abs(y - 2 * x) / Math.sqrt(5);
    const view = diagram.voronoi([-70, -60, 70, 60], { project });
    for (const tolerance of [1, 0.01]) {
      let sides = 0;
      for (const feature of view.toGeoJSON({ tolerance }).features) {
        const [ring] = ringsOf(feature);
        for (let k = 1; k < ring.length; ++k) {
          const ends = [ring[k - 1], ring[k]];
          if (!ends.every((end) => offEdge(project(end)) < 1e-6)) continue;
          ++sides;
          for (const part of parts)
            expect(offEdge(project(along(...ends, part)))).toBeLessThan(1.5 * tolerance);
        }
      }
      expect(sides).toBeGreaterThan(2);
    }
  });

  test("sides of a window are where they are on the map", () => {
    const [from, to] = [
      [-60, -50],
      [60, 50],
    ];
    const diagram = new Diagram([...project([40, -40]), 0]);
    const view = diagram.voronoi([from, [60, -50], to], { project });
    const [x0, y0] = view.window.bounds;
    const diagonal = Math.hypot(view.window.bounds[2] - x0, view.window.bounds[3] - y0);
    // Places beside the side, by a thousandth of the diagonal.
    for (const part of parts) {
      const [lon, lat] = along(from, to, part);
      const [x, y] = project([lon, lat]);
      const [nextX, nextY] = project(along(from, to, part + 1e-6));
      const length = Math.hypot(nextX - x, nextY - y);
      const [nx, ny] = [(nextY - y) / length, (x - nextX) / length].map(
        (n) => (n * diagonal) / 1e3,
      );
      expect(
        [view.window.contains(x + nx, y + ny), view.window.contains(x - nx, y - ny)].sort(),
      ).toEqual([false, true]);
    }
  });
});

test("what is no projection, and places that it does not know, are refused", () => {
  const diagram = new Diagram([0, 0, 1]);
  const refused = (options, window = [-10, -10, 10, 10]) =>
    expect(() => diagram.voronoi(window, options)).toThrow;
  refused({ project: {} })(expect.objectContaining({ code: "bad-option" }));
  refused({ project: (p) => p })(expect.objectContaining({ code: "bad-option" }));
  refused(
    { project: mercator },
    [-10, -90, 10, 10],
  )(expect.objectContaining({ code: "bad-bounds" }));
});
