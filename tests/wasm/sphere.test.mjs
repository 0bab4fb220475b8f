// The diagram of the sphere as users get it: against brute force, against d3-geo-voronoi where all
// weights are equal, and its polygons as d3-geo and JTS read them.
import { geoArea, geoContains, geoDistance } from "d3-geo";
import { geoVoronoi } from "d3-geo-voronoi";
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import IsValidOp from "jsts/org/locationtech/jts/operation/valid/IsValidOp.js";
import { validate } from "../../build/packed/diagnostics.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator } from "./support/random.mjs";

const random = generator(40);
const degrees = 180 / Math.PI;
const point = () => [360 * random() - 180, Math.asin(2 * random() - 1) * degrees];
const sites = (n, heaviest) => Array.from({ length: n }, () => [...point(), heaviest * random()]);
const distance = (lon, lat, [x, y, r]) => geoDistance([lon, lat], [x, y]) - r;

const sets = [
  ["one", sites(1, 0.1)],
  ["two", sites(2, 0.1)],
  ["three", sites(3, 0.1)],
  ["points", sites(120, 0)],
  ["caps", sites(120, 0.1)],
  ["mostly hidden", sites(120, 1)],
  [
    "octahedron",
    [
      [0, 0],
      [90, 0],
      [180, 0],
      [-90, 0],
      [0, 90],
      [0, -90],
    ].map((p) => [...p, 0]),
  ],
  [
    "grid",
    Array.from({ length: 60 }, (_, k) => [-180 + 30 * (k % 12), -60 + 30 * Math.floor(k / 12), 0]),
  ],
  ["towns", sites(100, 0.001).map(([x, y, r], k) => [2 + x / 1000, 48 + y / 1000, k ? r : 0.5])],
];

test.each(sets)("%s: finds what brute force finds", (_, list) => {
  const diagram = new SphericalDiagram(list.flat());
  expect(validate(diagram)).toBeNull();
  const points = Array.from({ length: 200 }, point);
  const { ids: many, distances } = diagram.nearestMany(points.flat());
  expect(diagram.findMany(points.flat())).toEqual(many);
  const lists = diagram.kNearestMany(points.flat(), 5, { distances: true, maxDistance: 1 });
  const odd = { filter: (id) => id % 2 === 1 };
  const oddLists = diagram.withinMany(points.flat(), 0.1, odd);
  const rowOf = ({ ids, starts }, k) => ids.subarray(starts[k], starts[k + 1]);
  const near = { maxDistance: 0.5 };
  const picked = diagram.pickMany(points.flat(), near);
  expect([...picked]).toEqual(points.map(([lon, lat]) => diagram.pick(lon, lat, near)));
  points.forEach(([lon, lat], k) => {
    expect(rowOf(lists, k)).toEqual(diagram.kNearest(lon, lat, 5, { maxDistance: 1 }));
    expect(rowOf(oddLists, k)).toEqual(diagram.within(lon, lat, 0.1, odd));
    if (lists.starts[k] < lists.starts[k + 1])
      expect(lists.distances[lists.starts[k]]).toBe(distances[k]);
    const least = Math.min(...list.map((site) => distance(lon, lat, site)));
    const found = diagram.nearest(lon, lat);
    expect(found.distance).toBeCloseTo(least, 13);
    expect(distances[k]).toBeCloseTo(least, 13);
    expect(diagram.find(lon, lat)).toBe(found.id);
    expect(diagram.voronoi().contains(many[k], lon, lat)).toBe(true);
    const under = list.map((_, id) => id).filter((id) => distance(lon, lat, list[id]) <= 0);
    const top = under.sort((a, b) => list[b][2] - list[a][2] || a - b).at(-1);
    expect(diagram.pick(lon, lat)).toBe(top ?? diagram.kNearest(lon, lat, 1)[0]);
    expect(diagram.pick(lon, lat, { maxDistance: 0 })).toBe(top ?? -1);
    const last = diagram.pick(lon, lat, { maxDistance: 0, top: "last" });
    expect(last).toBe(under.length ? Math.max(...under) : -1);
    const near = diagram.kNearest(lon, lat, 5);
    const sorted = list.map((site) => distance(lon, lat, site)).sort((a, b) => a - b);
    expect(near.length).toBe(Math.min(5, list.length));
    near.forEach((id, m) => {
      expect(distance(lon, lat, list[id])).toBeCloseTo(sorted[m], 12);
    });
    const oddOnes = diagram.kNearest(lon, lat, 2, { ...odd, maxDistance: 2 });
    for (const id of oddOnes) expect(id % 2).toBe(1);
    const within = diagram.within(lon, lat, 0.1);
    expect(within.length).toBe(sorted.filter((d) => d <= 0.1).length);
    expect([...diagram.within(lon, lat, 0.1, { filter: () => true })]).toEqual([...within]);
  });
});

test.each(sets)("%s: areas add up, polygons have them, and contain their sites", (_, list) => {
  const diagram = new SphericalDiagram(list.flat(), { radius: 10 });
  const areas = diagram.voronoi().cellAreas();
  const sum = areas.reduce((a, b) => a + b, 0);
  expect(Math.abs(sum / (400 * Math.PI) - 1)).toBeLessThan(1e-12);
  const { features } = diagram.voronoi().toGeoJSON({ winding: "clockwise", tolerance: 1e-4 });
  expect(features.length).toBe(diagram.visibleSize);
  for (const feature of features) {
    const { id } = feature;
    expect(diagram.voronoi().cellArea(id)).toBe(areas[id]);
    expect(100 * geoArea(feature)).toBeCloseTo(areas[id], 1);
    const { lon, lat } = diagram.site(id);
    if (areas[id] > 0.5) expect(geoContains(feature, [lon, lat])).toBe(true);
    const centroid = diagram.voronoi().cellCentroid(id);
    expect(centroid.every(Number.isFinite)).toBe(true);
  }
  for (const { id, hidden } of diagram) {
    if (!hidden) continue;
    expect(areas[id]).toBe(0);
    expect(diagram.voronoi().cellPolygon(id)).toBeNull();
    expect(diagram.voronoi().cellCentroid(id)).toBeNull();
    expect([...diagram.neighbors(id)]).toEqual([]);
    expect(diagram.isHidden(diagram.coverOf(id))).toBe(false);
  }
});

test.each(sets)("%s: cut polygons are valid and cover the plane once", (_, list) => {
  const diagram = new SphericalDiagram(list.flat(), { radius: 10 });
  const reader = new GeoJSONReader();
  for (const tolerance of [undefined, 1e-4, 0.2]) {
    const segments = new Map();
    let sum = 0;
    for (const feature of diagram.voronoi().toGeoJSON({ tolerance }).features) {
      const { type, coordinates } = feature.geometry;
      if (tolerance !== 1e-4) {
        const validity = new IsValidOp(reader.read(JSON.stringify(feature.geometry)));
        expect([feature.id, String(validity.getValidationError())]).toEqual([feature.id, "null"]);
      }
      for (const ring of (type === "Polygon" ? [coordinates] : coordinates).flat())
        ring.slice(1).forEach(([x, y], k) => {
          const [a, b] = ring[k];
          sum += ((a + 180) * (y + 90) - (x + 180) * (b + 90)) / 2;
          const key = `${a} ${b} ${x} ${y}`;
          if (segments.has(key)) expect(key).toBe("once");
          segments.set(key, [`${x} ${y} ${a} ${b}`, Math.abs(a) === 180 || Math.abs(b) === 90]);
        });
    }
    expect(sum).toBeCloseTo(360 * 180, 6);
    for (const [back, isBorder] of segments.values())
      if (!isBorder && !segments.has(back)) expect(back).toBe("there");
  }
});

// Longitude beside a pole is rounding: chains that followed it had thousands of points, and crossed
// themselves.
test.each([
  ["two of one latitude", [-81, 15, 0, -61, 15, 0]],
  ["half a turn apart, nearly", [-20, 45, 0, 159, 45, 0]],
  ["about the antimeridian", [170, -30, 0.1, -170, -30, 0.1]],
  ["about a meridian", [-20, -20, 0, 20, -20, 0, 20, 20, 0, -20, 20, 0]],
  ["beside a pole", [5, 90 - 1e-9, 0, 40, 90 - 1e-9, 0]],
])("%s: borders through poles have few points, and valid polygons", (_, list) => {
  const reader = new GeoJSONReader();
  const diagram = new SphericalDiagram(list);
  for (const [distance, tolerance] of [[], [undefined, 1e-7], [1.6]]) {
    const options = { tolerance };
    const view = diagram.voronoi({ maxDistance: distance });
    for (const { geometry } of view.toGeoJSON(options).features) {
      expect(new IsValidOp(reader.read(geometry)).isValid()).toBe(true);
      const rings =
        geometry.type === "Polygon" ? geometry.coordinates : geometry.coordinates.flat();
      for (const ring of rings) expect(ring.length).toBeLessThan(300);
    }
    for (const { id, geometry } of view.toGeoJSON({ ...options, winding: "clockwise" }).features)
      expect(Math.abs(geoArea(geometry) - view.cellArea(id))).toBeLessThan(0.01);
  }
});

// Seen from afar, close sites leave the vertex of two mirrored pairs to rounding.
test.each([
  ["far from the poles", [10, 45, 0, 10.1, 45, 0, 10, 89, 0, 10.1, 89, 0]],
  ["on the equator", [0, 0, 0, 0.001, 0, 0, 0, 30, 0, 0.001, 30, 0]],
  ["across the equator", [-75, 80, 0, -74.9, 80, 0, -75, -80, 0, -74.9, -80, 0]],
])("%s: polygons of close pairs that mirror each other are valid", (_, list) => {
  const reader = new GeoJSONReader();
  for (const { geometry } of new SphericalDiagram(list).voronoi().toGeoJSON().features)
    expect(new IsValidOp(reader.read(geometry)).isValid()).toBe(true);
});

// An edge left the reach a rounding away from its end, to which the ring went and came back.
test.each([
  ["antipodal", [-20, 60, 0, 160, 60, 0, -20, -60, 0]],
  ["on the axis", [-25, -90, 0, 155, 90, 0, 105, -55.00809379747418, 0, -75, 55.00809379747418, 0]],
  ["a rectangle", [163, 81.4591, 0, -17, 81.4591, 0, 163, -81.4591, 0, -17, -81.4591, 0]],
])("%s: polygons of cells whose reach ends at vertices are valid", (_, list) => {
  const reader = new GeoJSONReader();
  for (const tolerance of [undefined, 1e-3, 1e-2]) {
    const view = new SphericalDiagram(list).voronoi({ maxDistance: Math.PI / 2 });
    for (const { geometry } of view.toGeoJSON({ tolerance }).features)
      expect(new IsValidOp(reader.read(geometry)).isValid()).toBe(true);
  }
});

test("points without weights have the neighbours and cells of d3-geo-voronoi", () => {
  const points = sites(400, 0);
  const diagram = SphericalDiagram.from(points);
  const theirs = geoVoronoi(points.map(([lon, lat]) => [lon, lat]));
  const { neighbors } = theirs.delaunay;
  for (const id of diagram.ids())
    expect([...diagram.neighbors(id)].sort()).toEqual([...neighbors[id]].sort());
  const polygons = theirs.polygons().features;
  for (const id of diagram.ids())
    expect(diagram.voronoi().cellArea(id)).toBeCloseTo(geoArea(polygons[id]), 8);
  expect(diagram.vertices().clearance.length).toBe(2 * 400 - 4);
  expect(diagram.edges().sites.length / 2).toBe(3 * 400 - 6);
});

test("items are read as objects, arrays, points of GeoJSON, or by accessors", () => {
  const expected = [
    { id: 0, lon: 2, lat: 48, r: 0.1, hidden: false },
    { id: 1, lon: 13, lat: 52, r: 0, hidden: false },
  ];
  const feature = (lon, lat) => ({
    type: "Feature",
    properties: { lon, lat },
    geometry: { type: "Point", coordinates: [lon, lat, 30] },
  });
  const features = [feature(2, 48), feature(13, 52)];
  const without = expected.map((site) => ({ ...site, r: 0 }));
  expect(SphericalDiagram.from(expected).toJSON()).toEqual(expected);
  expect(
    SphericalDiagram.from([
      [2, 48, 0.1],
      [13, 52],
    ]).toJSON(),
  ).toEqual(expected);
  expect(SphericalDiagram.from(features).toJSON()).toEqual(without);
  expect(SphericalDiagram.from({ type: "FeatureCollection", features }).toJSON()).toEqual(without);
  const byAccessors = SphericalDiagram.from(
    features,
    (f) => f.properties.lon,
    (f) => f.properties.lat,
    (_, k) => (k === 0 ? 0.1 : 0),
  );
  expect(byAccessors.toJSON()).toEqual(expected);
  const earth = SphericalDiagram.from(features, undefined, undefined, undefined, { radius: 6371 });
  expect(earth.radius).toBe(6371);
  expect(SphericalDiagram.from(features, { radius: 6371 }).nearest(2, 49).distance).toBeCloseTo(
    (6371 * Math.PI) / 180,
    9,
  );
  expect(SphericalDiagram.from(new Set([[2, 48]])).size).toBe(1);
});

test("histories: sites come, move and go, and the diagram is that of the sites", () => {
  const diagram = new SphericalDiagram();
  const model = new Map();
  const some = () => [...model.keys()][Math.floor(random() * model.size)];
  for (let step = 0; step < 600; ++step) {
    const what = random();
    const [lon, lat, r] = sites(1, what < 0.05 ? 2 : 0.1)[0];
    if (what < 0.5 || model.size === 0) model.set(diagram.insert(lon, lat, r), [lon, lat, r]);
    else if (what < 0.75) {
      const id = some();
      expect(diagram.remove(id)).toBe(true);
      model.delete(id);
    } else if (what < 0.95) {
      const id = some();
      diagram.update(id, lon, lat);
      model.set(id, [lon, lat, model.get(id)[2]]);
    } else {
      const ids = [some(), some(), some()];
      diagram.updateMany(
        ids,
        ids.flatMap(() => [lon, lat, r]),
      );
      for (const id of ids) model.set(id, [lon, lat, r]);
    }
    if (step % 60 !== 0) continue;
    expect(validate(diagram)).toBeNull();
    expect([...diagram].map((site) => [site.id, [site.lon, site.lat, site.r]])).toEqual(
      [...model].sort(([a], [b]) => a - b),
    );
    const copy = SphericalDiagram.fromBytes(diagram.toBytes());
    expect(copy.sites()).toEqual(diagram.sites());
    const added = diagram.insert(1, 2, 0);
    expect(copy.insert(1, 2, 0)).toBe(added);
    model.set(added, [1, 2, 0]);
    const [x, y] = point();
    const least = Math.min(...[...model.values()].map((site) => distance(x, y, site)));
    expect(diagram.nearest(x, y).distance).toBeCloseTo(least, 12);
  }
});

test("a restored diagram shows the same one of identical sites", () => {
  const diagram = new SphericalDiagram([0, 0, 0, 50, 90, 0]);
  diagram.insert(0, 90, 0);
  expect(SphericalDiagram.fromBytes(diagram.toBytes()).toJSON()).toEqual(diagram.toJSON());
});

test.each(sets)("%s: its triangulation is closed, and has the rows of vertices", (_, list) => {
  const diagram = new SphericalDiagram(list.flat());
  const { points, triangles, halfedges, hull } = diagram.triangulation();
  const next = (e) => (e % 3 === 2 ? e - 2 : e + 1);
  expect(triangles).toEqual(diagram.vertices().sites);
  expect(triangles.length).toBe(3 * Math.max(2 * diagram.visibleSize - 4, 0));
  expect(halfedges.length).toBe(triangles.length);
  halfedges.forEach((twin, e) => {
    expect(halfedges[twin]).toBe(e);
    expect([triangles[twin], triangles[next(twin)]]).toEqual([triangles[next(e)], triangles[e]]);
  });
  expect([...points]).toEqual(list.flatMap((one) => one.slice(0, 2)));
  expect(hull).toEqual(new Uint32Array(0));
  // Around each site are its neighbours.
  const around = diagram.ids().reduce((lists, id) => lists.set(id, new Set()), new Map());
  triangles.forEach((id, e) => around.get(id).add(triangles[next(e)]));
  if (diagram.visibleSize > 2)
    for (const [id, others] of around)
      expect([...others].sort()).toEqual([...diagram.neighbors(id)].sort());
});

test("no, one and two visible sites have no triangle", () => {
  const few = new SphericalDiagram();
  for (const size of [0, 1, 2, 3]) {
    // The last one is hidden.
    if (size > 0) few.insert(40 * size, 10, size === 3 ? -1 : 0.1);
    if (size === 3) few.update(2, 40, 10, 0);
    const { points, triangles, halfedges, hull } = few.triangulation();
    expect([triangles.length, halfedges.length, hull.length]).toEqual([0, 0, 0]);
    expect(points.length).toBe(2 * size);
  }
  expect(few.visibleSize).toBe(2);
  few.remove(0);
  expect([...few.triangulation().points]).toEqual([NaN, NaN, 80, 10, 40, 10]);
  few.clear();
  few.insertMany([0, 0, 0, 90, 0, 0, 0, 90, 0]);
  const { triangles, halfedges } = few.triangulation();
  expect(triangles.length).toBe(6);
  expect([...halfedges].sort()).toEqual([0, 1, 2, 3, 4, 5]);
});

test("an empty diagram answers, and one site has the whole sphere", () => {
  const diagram = new SphericalDiagram();
  expect([diagram.find(0, 0), diagram.nearest(0, 0), diagram.size]).toEqual([-1, null, 0]);
  expect([...diagram.findMany([0, 0, 1, 1])]).toEqual([-1, -1]);
  expect(diagram.voronoi().toGeoJSON()).toEqual({ type: "FeatureCollection", features: [] });
  expect(diagram.insert(5, 5)).toBe(0);
  const view = diagram.voronoi();
  for (const ask of [() => view.cellPolygon(0), () => [...view.cellPolygons()]])
    expect(ask).toThrow(
      expect.objectContaining({
        code: "out-of-range",
        message: expect.stringMatching(/whole sphere, which has no ring: cellGeometry\(0\)/),
      }),
    );
  expect(view.cellGeometry(0, { antimeridian: "keep" })).toEqual({ type: "Sphere" });
  expect(view.cellGeometry(0)).toEqual(view.toGeoJSON().features[0].geometry);
  expect(view.cellMesh()).toEqual({ type: "MultiLineString", coordinates: [] });
  expect(diagram.voronoi().toGeoJSON({ winding: "clockwise" }).features[0].geometry).toEqual({
    type: "Sphere",
  });
  const whole = [
    [-180, -90],
    [180, -90],
    [180, 90],
    [-180, 90],
    [-180, -90],
  ];
  expect(diagram.voronoi().toGeoJSON().features[0].geometry).toEqual({
    type: "Polygon",
    coordinates: [whole],
  });
  expect(String(diagram)).toBe("SphericalDiagram { size: 1, hidden: 0 }");
  expect(diagram.clear().size).toBe(0);
});
