// docs/D3_DELAUNAY.md tells users of d3-geo-voronoi: with equal weights the results are its own,
// and where they differ it is as the table says.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { geoArea, geoContains, geoDistance } from "d3-geo";
import { geoVoronoi } from "d3-geo-voronoi";
import { root } from "../../tools/toolchain/folders.mjs";
import { packed } from "./support/install_packed.mjs";
import { generator } from "./support/random.mjs";

const require = createRequire(path.join(packed, "package.json"));
const { SphericalDiagram } = require("apollonius-diagram/sphere");

const random = generator(72);
const anywhere = () => [random() * 360 - 180, (Math.asin(2 * random() - 1) * 180) / Math.PI];
const count = 300;
const points = Array.from({ length: count }, anywhere);
const voronoi = geoVoronoi(points);
const { delaunay } = voronoi;
const key = (ids) => [...ids].sort((a, b) => a - b).join(" ");
const rowsOf = (array, width) =>
  Array.from({ length: array.length / width }, (_, k) => array.slice(width * k, width * (k + 1)));
const doc = readFileSync(path.join(root, "docs/D3_DELAUNAY.md"), "utf8");
const table = doc.slice(doc.indexOf("# From d3-geo-voronoi"));
/** The code that asks for the triangulation. */
const codeOf = (text) => /```js\n([^`]*triangulation\(\)[^`]*)```/.exec(text)[1];
/** Positive where three points are counter-clockwise as seen from outside. */
function orientation(ids) {
  const [a, b, c] = [...ids].map((id) => {
    const [lon, lat] = points[id].map((angle) => (angle * Math.PI) / 180);
    return [Math.cos(lat) * Math.cos(lon), Math.cos(lat) * Math.sin(lon), Math.sin(lat)];
  });
  const minor = (i, k) => b[i] * c[k] - b[k] * c[i];
  return a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
}

describe.each([0, 0.3, -0.2])("all weights %d", (r) => {
  const diagram = SphericalDiagram.from(
    points,
    (p) => p[0],
    (p) => p[1],
    () => r,
  );

  test("find, also within a distance", () => {
    for (let k = 0; k < 3000; ++k) {
      const [lon, lat] = anywhere();
      expect(diagram.find(lon, lat)).toBe(voronoi.find(lon, lat));
      const found = voronoi.find(lon, lat, 0.05);
      const ours = diagram.kNearest(lon, lat, 1, { maxDistance: 0.05 - r });
      expect([...ours]).toEqual(found === undefined ? [] : [found]);
    }
  });

  test("neighbors and edges", () => {
    for (let id = 0; id < count; ++id)
      expect(key(diagram.neighbors(id))).toBe(key(delaunay.neighbors[id]));
    const ours = rowsOf(diagram.edges().sites, 2).map(key);
    expect(ours.sort()).toEqual(delaunay.edges.map(key).sort());
    expect(voronoi.links().features.length).toBe(ours.length);
    expect(delaunay.mesh.length).toBe(ours.length);
  });

  test("triangles, the other way round, and centers", () => {
    const { sites, lonLat } = diagram.vertices();
    const triples = rowsOf(sites, 3);
    const centers = new Map(delaunay.triangles.map((ids, k) => [key(ids), delaunay.centers[k]]));
    expect(centers.size).toBe(triples.length);
    triples.forEach((ids, k) => {
      const center = [lonLat[2 * k], lonLat[2 * k + 1]];
      expect(geoDistance(center, centers.get(key(ids)))).toBeLessThan(1e-9);
    });
    expect(triples.every((ids) => orientation(ids) > 0)).toBe(true);
    expect(delaunay.triangles.every((ids) => orientation(ids) < 0)).toBe(true);
  });

  test("triples, links and the Urquhart graph, as the migration notes have them", () => {
    const run = new Function(
      "diagram",
      "geoDistance",
      `${codeOf(table)}; return Object.freeze({
      triples, links, urquhart: urquhart.map((e) => [triangles[e], triangles[next(e)]]) });`,
    );
    const { triples, links, urquhart } = run(diagram, geoDistance);
    expect(triples.map(key).sort()).toEqual(delaunay.triangles.map(key).sort());
    expect(links.map(key).sort()).toEqual(delaunay.edges.map(key).sort());
    const lengths = delaunay.edges.map(([a, b]) => geoDistance(points[a], points[b]));
    const theirs = delaunay.urquhart(lengths);
    const expected = delaunay.edges.filter((_, k) => theirs[k]).map(key);
    expect(urquhart.map(key).sort()).toEqual(expected.sort());
    expect(expected.length).toBeLessThan(links.length - 100);
  });

  test("polygons", () => {
    const { features } = diagram.voronoi().toGeoJSON({ winding: "clockwise" });
    expect(features.length).toBe(count);
    voronoi.polygons().features.forEach((theirs, id) => {
      expect(geoArea(features[id])).toBeCloseTo(geoArea(theirs), 9);
      expect(geoContains(features[id], points[id])).toBe(true);
    });
  });
});

test("what differs: NaN, GeoJSON that is no point, equal points, grids, a hemisphere", () => {
  const odd = [
    [0, 0],
    [Number.NaN, 0],
    [10, 10],
    [20, 5],
  ];
  expect(geoVoronoi(odd).valid.length).toBe(3);
  expect(() => SphericalDiagram.from(odd)).toThrow(/lon of item 1 is NaN/);

  const ring = [
    [0, 0],
    [1, 1],
    [2, 0],
    [0, 0],
  ];
  const polygon = {
    type: "Feature",
    properties: {},
    geometry: { type: "Polygon", coordinates: [ring] },
  };
  const collection = { type: "FeatureCollection", features: [polygon] };
  expect(geoVoronoi(collection).points.length).toBe(1);
  expect(() => SphericalDiagram.from(collection)).toThrow(/GeoJSON point/);

  const twice = [...points.slice(0, 20), points[0]];
  expect(geoVoronoi(twice).polygons().features.length).toBe(20);
  expect(SphericalDiagram.from(twice).hiddenSize).toBe(1);

  const grid = Array.from({ length: 36 * 17 }, (_, k) => [
    10 * (k % 36) - 180,
    10 * Math.floor(k / 36) - 80,
  ]);
  const spheres = (areas) => areas.reduce((sum, area) => sum + area, 0) / (4 * Math.PI);
  const theirs = geoVoronoi(grid)
    .polygons()
    .features.map(({ geometry }) => geoArea(geometry));
  expect(spheres(theirs)).toBeCloseTo(3, 9);
  expect(spheres([...SphericalDiagram.from(grid).voronoi().cellAreas()])).toBeCloseTo(1, 12);

  const half = points.filter((point) => geoDistance(point, [0, 0]) < 1);
  const fewer = geoVoronoi(half);
  expect(fewer.hull().coordinates[0].length).toBeGreaterThan(3);
  expect(voronoi.hull()).toBe(null);
  const here = SphericalDiagram.from(half);
  expect(here.vertices().clearance.length).toBe(fewer.delaunay.triangles.length);
  expect(fewer.triangles().features.length).toBeLessThan(fewer.delaunay.triangles.length);
  expect(fewer.links().features.length).toBeLessThan(here.edges().sites.length / 2);
});

test("one and two points: the sphere, and no triangle", () => {
  for (const n of [1, 2]) {
    const diagram = SphericalDiagram.from(points.slice(0, n));
    const theirs = geoVoronoi(points.slice(0, n));
    const types = ({ features }) => features.map(({ geometry }) => geometry.type);
    expect(types(diagram.voronoi().toGeoJSON({ winding: "clockwise" }))).toEqual(
      types(theirs.polygons()),
    );
    expect(diagram.vertices().clearance.length).toBe(theirs.delaunay.triangles.length);
  }
});

test("the table has every public name, and names calls that are there", () => {
  const names = (object) => Object.keys(object).filter((name) => !name.startsWith("_"));
  const missing = [
    ...names(voronoi)
      .filter((name) => name !== "type")
      .map((name) => `voronoi.${name}`),
    ...names(delaunay).map((name) => `delaunay.${name}`),
    "geoVoronoi(",
    "geoDelaunay(",
    "geoContour(",
  ].filter((name) => !table.includes(`\`${name}`));
  expect(missing).toEqual([]);
  const diagram = new SphericalDiagram();
  const ours = [...table.matchAll(/`diagram\.(\w+)/g)].map((match) => match[1]);
  expect(ours.length).toBeGreaterThan(8);
  expect(ours.filter((name) => !(name in diagram))).toEqual([]);
});
