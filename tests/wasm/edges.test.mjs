// Edges of diagrams, of views and of the sphere with their clearances, and the vertices of views:
// their arrays, and by all sites. tests/geometry/edge_graph_test.cpp searches along the curves.
import { Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const xyr = randomCircles(200, 681, 90);
const diagram = new Diagram(xyr);
const bounds = [-300, -200, 700, 500];
const lake = [
  [-300, -200, 700, -200, 700, 500, -300, 500],
  [100, 100, 300, 120, 200, 260],
];
/** The distance from the nearest site. */
const clearanceAt = (x, y) => diagram.nearest(x, y).distance;
const site = (id) => diagram.site(id);
const pairsOf = (array) =>
  Array.from({ length: array.length / 2 }, (_, k) => [array[2 * k], array[2 * k + 1]]);

const views = [
  ["a rectangle", diagram.voronoi(bounds)],
  ["a region", diagram.voronoi(lake)],
  ["a rectangle up to a distance", diagram.voronoi(bounds, { maxDistance: 15 })],
  ["a region up to a distance", diagram.voronoi(lake, { maxDistance: 15 })],
];

describe.each(views)("in %s", (name, view) => {
  const { curves, sites: beside } = view.edgeCurves();
  const { sites, vertices } = view.edges();
  const { xy, clearance, sites: around } = view.vertices();

  test("edges are the curves, between rows of vertices", () => {
    expect(sites).toEqual(beside);
    expect(sites.length).toBeGreaterThan(50);
    expect(vertices).toBeInstanceOf(Int32Array);
    expect(around).toBeInstanceOf(Int32Array);
    expect(Math.min(...vertices)).toBe(0);
    expect(new Set(vertices).size).toBe(clearance.length);
    const ends = pairsOf(vertices).map((rows) => rows.map((row) => [xy[2 * row], xy[2 * row + 1]]));
    const starts = Array.from(clearance, (_, k) => around.subarray(3 * k, 3 * k + 3));
    ends.forEach(([from, to], k) => {
      expect(from).toEqual([...curves.subarray(7 * k, 7 * k + 2)]);
      expect(to).toEqual([...curves.subarray(7 * k + 5, 7 * k + 7)]);
      for (const row of vertices.subarray(2 * k, 2 * k + 2))
        expect([...starts[row]]).toEqual(
          expect.arrayContaining([...sites.subarray(2 * k, 2 * k + 2)]),
        );
    });
  });

  test("vertices have two sites where an edge is cut, and three elsewhere", () => {
    const degrees = new Uint8Array(clearance.length);
    for (const row of vertices) ++degrees[row];
    clearance.forEach((value, row) => {
      const [x, y] = xy.subarray(2 * row, 2 * row + 2);
      const ids = around.subarray(3 * row, 3 * row + 3);
      const isCut = ids[2] === -1;
      expect(degrees[row]).toBe(isCut ? 1 : 3);
      expect(Math.abs(clearanceAt(x, y) - value)).toBeLessThan(1e-9);
      const onBorder =
        view.window.contains(x, y) !== view.window.contains(x + 1e-9, y + 2e-9) ||
        view.window.contains(x, y) !== view.window.contains(x - 2e-9, y - 1e-9) ||
        view.window.contains(x - 2e-9, y + 1e-9) !== view.window.contains(x + 1e-9, y - 2e-9);
      const atDistance = name.endsWith("distance") && Math.abs(value - 15) < 1e-9;
      expect(isCut).toBe(onBorder || atDistance);
    });
    // All those of the diagram that are inside, and near enough.
    const all = diagram.vertices();
    const inside = pairsOf(all.xy).filter(
      ([x, y], k) =>
        view.window.contains(x, y) && (!name.endsWith("distance") || all.clearance[k] <= 15),
    );
    const whole = Array.from(clearance.keys()).filter((row) => around[3 * row + 2] !== -1);
    expect(whole.length).toBe(inside.length);
  });

  test("the smallest clearance is between the circles, or at an end", () => {
    const found = view.edges({ clearance: true });
    expect([found.sites, found.vertices]).toEqual([sites, vertices]);
    expectNarrowest(found, clearance);
    const rows = [...found.clearance.keys()];
    expect(rows.filter((k) => isBetween(found, k)).length).toBeGreaterThan(20);
  });
});

/** Is the place on the segment of the centres? */
function isBetween({ sites, clearance }, k) {
  const [a, b] = [site(sites[2 * k]), site(sites[2 * k + 1])];
  const gap = Math.hypot(a.x - b.x, a.y - b.y) - a.r - b.r;
  return Math.abs(2 * clearance[k] - gap) < 1e-9;
}

function expectNarrowest(found, clearanceOfVertices) {
  const { sites, vertices, clearance, xy } = found;
  expect(clearance.length).toBe(sites.length / 2);
  expect(xy.length).toBe(sites.length);
  clearance.forEach((least, k) => {
    const [x, y] = xy.subarray(2 * k, 2 * k + 2);
    expect(Math.abs(clearanceAt(x, y) - least)).toBeLessThan(1e-7);
    const ends = [...vertices.subarray(2 * k, 2 * k + 2)]
      .filter((row) => row !== -1)
      .map((row) => clearanceOfVertices[row]);
    expect(least).toBeLessThanOrEqual(Math.min(...ends));
    if (!isBetween(found, k)) expect(least).toBe(Math.min(...ends));
  });
}

test("and of a whole diagram", () => {
  const plain = diagram.edges();
  expect(Object.keys(plain).sort()).toEqual(["sites", "vertices"]);
  expect(diagram.edges({})).toEqual(plain);
  expect(diagram.edges({ clearance: false })).toEqual(plain);
  const found = diagram.edges({ clearance: true });
  expect({ sites: found.sites, vertices: found.vertices }).toEqual(plain);
  expectNarrowest(found, diagram.vertices().clearance);
  for (const edges of [
    (options) => diagram.edges(options),
    (options) => views[0][1].edges(options),
    (options) => new SphericalDiagram().edges(options),
  ]) {
    expectRefusal(() => edges({ clearance: 1 }), "bad-option", "options.clearance is 1");
    expectRefusal(() => edges({ distance: 1 }), "bad-option", "options.distance is unknown");
    expectRefusal(() => edges(true), "bad-option", "options is true");
  }
});

test("a lattice of points has one vertex where four cells meet", () => {
  for (const far of [0, -1e7]) {
    const points = Array.from({ length: 16 }, (_, k) => [far + (k % 4), k >> 2, 0]);
    const view = Diagram.from(points).voronoi([far - 0.5, -0.5, far + 3.5, 3.5]);
    expect(view.edges().sites.length / 2).toBe(24);
    const { sites } = view.vertices();
    expect(sites.filter((id) => id === -1).length).toBe(12);
    expect(sites.length / 3).toBe(12 + 9);
    expect([...view.edges({ clearance: true }).clearance]).toEqual(new Array(24).fill(0.5));
  }
});

test("without sites, of one, and of two", () => {
  const few = new Diagram();
  const view = few.voronoi([0, 0, 10, 10]);
  for (let size = 0; size < 2; ++size) {
    expect(view.edges({ clearance: true })).toEqual({
      sites: new Uint32Array(),
      vertices: new Int32Array(),
      clearance: new Float64Array(),
      xy: new Float64Array(),
    });
    expect(view.vertices().sites).toEqual(new Int32Array());
    expect(few.edges({ clearance: true }).xy).toEqual(new Float64Array());
    few.insert(2, 5, 1);
  }
  few.insert(8, 5, 1);
  const { vertices, clearance, xy } = view.edges({ clearance: true });
  expect([[...vertices], [...clearance], [...xy]]).toEqual([[0, 1], [2], [5, 5]]);
  expect([...view.vertices().xy].sort()).toEqual([0, 10, 5, 5]);
  expect(few.edges({ clearance: true })).toMatchObject({
    vertices: Int32Array.of(-1, -1),
    clearance: Float64Array.of(2),
    xy: Float64Array.of(5, 5),
  });
});

test("on the sphere: half of the gap, or an end", () => {
  const globe = SphericalDiagram.from(
    Array.from({ length: 80 }, (_, k) => [137.5 * k, Math.sin(k * k) * 80, (k % 7) * 30]),
    { radius: 6371 },
  );
  const { sites, vertices, clearance, lonLat } = globe.edges({ clearance: true });
  expect({ sites, vertices }).toEqual(globe.edges());
  const ends = globe.vertices().clearance;
  let between = 0;
  clearance.forEach((least, k) => {
    const [lon, lat] = lonLat.subarray(2 * k, 2 * k + 2);
    expect(Math.abs(globe.nearest(lon, lat).distance - least)).toBeLessThan(1e-5);
    const nearer = Math.min(ends[vertices[2 * k]], ends[vertices[2 * k + 1]]);
    expect(least).toBeLessThanOrEqual(nearer);
    if (least === nearer) return;
    ++between;
    const [a, b] = [globe.site(sites[2 * k]), globe.site(sites[2 * k + 1])];
    const pair = SphericalDiagram.from([a, b], { radius: 6371 });
    const [middle] = pair.edges({ clearance: true }).clearance;
    expect(Math.abs(middle - least)).toBeLessThan(1e-8);
    const way = globe.radius === 6371 ? pair.nearest(b.lon, b.lat).distance : NaN;
    expect(way).toBeLessThanOrEqual(-b.r + 1e-9);
  });
  expect(between).toBeGreaterThan(100);
});
