// Cells in a window: shapes, measures, bad input. The geometry itself is tested in tests/geometry
// (natively and as WebAssembly).
import {
  ApolloniusError,
  curvePoint,
  curveTangent,
  Diagram,
} from "../../build/packed/consumer.mjs";
import { randomCircles } from "./support/random.mjs";
import { isInside, ringArea } from "./support/recorder.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const bounds = [-900, -700, 1000, 800];
const whole = 1900 * 1500;
const xyr = randomCircles(300, 61, 90);
const diagram = new Diagram(xyr);
const voronoi = diagram.voronoi(bounds);
const codeOf = (call) => {
  try {
    call();
  } catch (error) {
    expect(error).toBeInstanceOf(ApolloniusError);
    return error.code;
  }
  return "none";
};

test("the default window is d3-delaunay's", () => {
  const { xmin, ymin, xmax, ymax } = diagram.voronoi();
  expect([xmin, ymin, xmax, ymax]).toEqual([0, 0, 960, 500]);
  expect(diagram.voronoi().diagram).toBe(diagram);
});

test("areas are the shares of random points that are nearest to each circle", () => {
  const points = 400_000,
    xy = new Float64Array(2 * points);
  let state = 7;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  for (let k = 0; k < points; ++k) {
    xy[2 * k] = -900 + 1900 * random();
    xy[2 * k + 1] = -700 + 1500 * random();
  }
  const counts = new Float64Array(300);
  for (const id of diagram.findMany(xy)) ++counts[id];
  const areas = voronoi.cellAreas();
  for (let id = 0; id < 300; ++id) {
    const share = (diagram.isHidden(id) ? 0 : areas[id]) / whole;
    expect(Math.abs(counts[id] - points * share)).toBeLessThanOrEqual(
      6 * Math.sqrt(points * share * (1 - share)),
    ); // six sigma
  }
});

test("areas add up to the window, one by one and all at once", () => {
  const areas = voronoi.cellAreas();
  expect(areas).toBeInstanceOf(Float64Array);
  expect(areas.length).toBe(300);
  expect(areas.reduce((sum, area) => sum + area, 0) / whole).toBeCloseTo(1, 12);
  for (const id of diagram.ids()) {
    const area = voronoi.cellArea(id);
    if (diagram.isHidden(id)) expect(area).toBe(0);
    expect(area / whole).toBeCloseTo(areas[id] / whole, 13);
  }
});

test("polygons are closed, counter-clockwise, and as large as the cells", () => {
  let sum = 0;
  for (const ring of voronoi.cellPolygons({ tolerance: 0.01, flat: true })) {
    expect(ring.slice(-2)).toEqual(ring.slice(0, 2));
    const area = ringArea(ring);
    expect(area).toBeGreaterThan(0);
    expect(Math.abs(area - voronoi.cellArea(ring.index))).toBeLessThan(
      0.011 * voronoi.cellPerimeter(ring.index),
    );
    sum += area;
  }
  expect(sum / whole).toBeCloseTo(1, 4);
});

test("a smaller tolerance takes more points", () => {
  const length = (tolerance) =>
    [...voronoi.cellPolygons({ tolerance, flat: true })].reduce(
      (sum, ring) => sum + ring.length,
      0,
    );
  expect(length(0.001)).toBeGreaterThan(1.5 * length(1));
});

test("the true nearest site's polygon holds a point, and no other does", () => {
  const rings = [...voronoi.cellPolygons({ tolerance: 1e-3, flat: true })];
  for (let k = 0; k < 400; ++k) {
    const [x, y] = [
      bounds[0] + 1900 * ((k * 0.6180339887) % 1),
      bounds[1] + 1500 * ((k * 0.7548776662) % 1),
    ];
    const holders = rings.filter((ring) => isInside(ring, x, y)).map((ring) => ring.index);
    const distance = (id) => Math.hypot(x - xyr[3 * id], y - xyr[3 * id + 1]) - xyr[3 * id + 2];
    const sorted = [...diagram.ids()].map(distance).sort((a, b) => a - b);
    if (sorted[1] - sorted[0] < 0.01) continue;
    expect(holders).toEqual([diagram.find(x, y)]);
    expect(voronoi.contains(holders[0], x, y)).toBe(true);
    expect(voronoi.contains((holders[0] + 1) % 300, x, y)).toBe(false);
  }
});

test("curves of cells and of edges are the same, equally far from both sites", () => {
  const edges = voronoi.edgeCurves();
  const keys = new Set();
  for (let k = 0; k < edges.sites.length / 2; ++k) {
    const [x0, y0, x1, y1, w, x2, y2] = edges.curves.subarray(7 * k, 7 * k + 7);
    const [a, b] = edges.sites.subarray(2 * k, 2 * k + 2);
    keys.add([a, b, x0, y0, x2, y2].join());
    keys.add([b, a, x2, y2, x0, y0].join());
    const sum = 2 + 2 * w; // at t = 1/2
    const [x, y] = [(x0 + 2 * w * x1 + x2) / sum, (y0 + 2 * w * y1 + y2) / sum];
    const distance = (id) => Math.hypot(x - xyr[3 * id], y - xyr[3 * id + 1]) - xyr[3 * id + 2];
    expect(Math.abs(distance(a) - distance(b))).toBeLessThan(1e-7);
  }
  let inner = 0;
  for (const id of diagram.ids()) {
    const cell = voronoi.cellCurves(id);
    if (cell === null) continue;
    expect(cell.starts[0]).toBe(0);
    expect(cell.starts.at(-1)).toBe(cell.neighbors.length);
    cell.neighbors.forEach((other, k) => {
      if (other === -1) return;
      const [x0, y0, , , , x2, y2] = cell.curves.subarray(7 * k, 7 * k + 7);
      expect(keys.has([id, other, x0, y0, x2, y2].join())).toBe(true);
      ++inner;
    });
  }
  expect(inner).toBe(edges.sites.length);
});

test("curves are equally far from both sites, at equal angles to the ways from them", () => {
  const { curves, sites } = voronoi.edgeCurves();
  for (let k = 0; k < sites.length / 2; ++k) {
    expect(curvePoint(curves, k, 0)).toEqual([...curves.subarray(7 * k, 7 * k + 2)]);
    expect(curvePoint(curves, k, 1)).toEqual([...curves.subarray(7 * k + 5, 7 * k + 7)]);
    for (const t of [0.1, 0.5, 0.8]) {
      const [x, y] = curvePoint(curves, k, t);
      const [tx, ty] = curveTangent(curves, k, t);
      const [a, b] = [...sites.subarray(2 * k, 2 * k + 2)].map((id) => {
        const [dx, dy] = [x - xyr[3 * id], y - xyr[3 * id + 1]];
        const length = Math.hypot(dx, dy);
        return {
          distance: length - xyr[3 * id + 2],
          along: (dx * tx + dy * ty) / length,
          left: (dx * ty - dy * tx) / length,
        };
      });
      expect(Math.abs(a.distance - b.distance)).toBeLessThan(1e-7);
      if (
        Math.hypot(curves[7 * k + 5] - curves[7 * k], curves[7 * k + 6] - curves[7 * k + 1]) < 1e-3
      )
        continue;
      expect(Math.abs(a.along - b.along)).toBeLessThan(1e-5);
      expect(a.left).toBeGreaterThan(0); // the first site is on the left
      expect(b.left).toBeLessThan(0);
    }
  }
});

test("a curve that is not there is an error", () => {
  const { curves } = voronoi.edgeCurves();
  const count = curves.length / 7;
  const few = curves.slice(0, 20); // two, and some numbers more
  for (const at of [curvePoint, curveTangent]) {
    expect(at(curves, count - 1, 0.5)).toEqual([expect.any(Number), expect.any(Number)]);
    expect(at([...few], 1, 0.5)).toEqual(at(curves, 1, 0.5));
    for (const k of [-1, count, 0.5, NaN, Infinity, 2 ** 32, "0", 0n, null, undefined, [0]])
      expectRefusal(() => at(curves, k, 0.5), "out-of-range", `one of ${count} curves`);
    expectRefusal(() => at(few, 2, 0.5), "out-of-range", "k is 2, expected the number of one of 2");
    expectRefusal(() => at([], 0, 0.5), "out-of-range", "k is 0, expected the number of one of 0");
  }
});

test("neighbors in the window are neighbors", () => {
  for (const id of diagram.ids()) {
    const all = new Set(diagram.neighbors(id));
    for (const other of voronoi.neighbors(id)) {
      expect(all).toContain(other);
      expect([...voronoi.neighbors(other)]).toContain(id);
    }
  }
});

test("a view shows the diagram as it is now", () => {
  const changing = new Diagram([100, 100, 5]);
  const view = changing.voronoi([0, 0, 200, 200]);
  expect(view.cellArea(0)).toBe(40000);
  const id = changing.insert(0, 100, 5);
  expect(view.cellArea(id)).toBe(10000);
  changing.remove(id);
  expect(view.cellArea(0)).toBe(40000);
});

test("one site has the window, several regions are several rings", () => {
  const corners = new Diagram([-60, 50, 58, 50, 50, 0]).voronoi([30, 0, 100, 100]);
  const regions = corners.cellParts(0, { flat: true });
  expect(regions.length).toBe(2);
  const joined = corners.cellPolygon(0, { flat: true });
  expect(ringArea(joined)).toBeCloseTo(ringArea(regions[0][0]) + ringArea(regions[1][0]), 9);
  expect(joined.slice(-2)).toEqual(joined.slice(0, 2));
  expect(corners.cellCentroid(0)[1]).toBeCloseTo(50, 9);
  expect(corners.toGeoJSON().features.map((feature) => feature.geometry.type)).toEqual([
    "MultiPolygon",
    "Polygon",
  ]);
  expect([
    ...new Diagram([7, 7, 1]).voronoi([0, 0, 10, 10]).cellPolygon(0, { flat: true }),
  ]).toEqual([0, 0, 10, 0, 10, 10, 0, 10, 0, 0]);
});

test("GeoJSON: closed rings, right-handed, one feature a cell", () => {
  const { type, features } = voronoi.toGeoJSON();
  expect(type).toBe("FeatureCollection");
  expect(features.map((feature) => feature.id)).toEqual(
    [...voronoi.cellPolygons()].map((ring) => ring.index),
  );
  for (const { geometry } of features) {
    const [ring] = geometry.type === "Polygon" ? geometry.coordinates : geometry.coordinates[0];
    expect(ring.length).toBeGreaterThan(3);
    expect(ring.at(-1)).toEqual(ring[0]);
    expect(ringArea(ring.flat())).toBeGreaterThan(0);
  }
});

// The most that a site can cover: all within a radius of its centre.
test("within a radius", () => {
  const pair = new Diagram([0, 0, 1, 10, 0, 4]);
  const within = (radius) =>
    pair.voronoi([-100, -100, 100, 100], { maxDistance: (id) => radius - pair.site(id).r });
  expect(within(3).cellMeasures(0).area).toBeCloseTo(9 * Math.PI, 12);
  expect(within(3).cellPerimeter(0)).toBeCloseTo(6 * Math.PI, 12);
  expect(within(3).cellArea(1)).toBeCloseTo(9 * Math.PI, 12);
  expect(within(0).cellMeasures(0)).toEqual({ area: 0, centroid: null, perimeter: 0 });
});

test("bad bounds", () => {
  const bad = [
    [0, 0, 0, 1],
    [0, 0, 1, 0],
    [1, 0, 0, 1],
    [0, 1, 1, 0],
    [NaN, 0, 1, 1],
    [0, 0, Infinity, 1],
    [0, -Infinity, 1, 1],
    [0, 0, 1],
    [0, 0, 1, 1, 1],
    [0, 0, "1", 1],
    [0, 0, 1e101, 1],
    [0, 0, 1e-101, 1],
    null,
    "window",
    7,
  ];
  for (const value of bad) {
    expect(codeOf(() => diagram.voronoi(value))).toBe("bad-bounds");
    if (value !== null && value !== undefined)
      expect(codeOf(() => diagram.render(null, { bounds: value }))).toBe("bad-bounds");
  }
});

test("bad tolerances and digits", () => {
  const uses = [
    (options) => voronoi.cellPolygon(0, options),
    (options) => voronoi.cellParts(0, options),
    (options) => [...voronoi.cellPolygons(options)],
    (options) => voronoi.render(null, options),
    (options) => voronoi.renderCell(0, null, options),
    (options) => voronoi.toGeoJSON(options),
    (options) => diagram.render(null, options),
    (options) => diagram.renderSites(null, options),
    (options) => diagram.renderHull(null, options),
  ];
  for (const use of uses) {
    for (const tolerance of [0, -1, -0])
      expect(codeOf(() => use({ tolerance }))).toBe("out-of-range");
    for (const tolerance of [NaN, Infinity, "1", null])
      expect(codeOf(() => use({ tolerance }))).toBe("not-finite");
  }
  for (const digits of [-1, 16, 1.5, NaN, "2"])
    expect(codeOf(() => voronoi.render(null, { digits }))).toBe("out-of-range");
});

test("hidden sites have nothing, unknown ones are errors, everywhere the same way", () => {
  // 1 is hidden, 2 has no part of the window
  const few = new Diagram([100, 100, 50, 110, 100, 5, 5000, 100, 50]);
  const view = few.voronoi([0, 0, 200, 200]);
  const uses = {
    renderCell: (id) => view.renderCell(id),
    cellPolygon: (id) => view.cellPolygon(id),
    cellParts: (id) => view.cellParts(id),
    cellCurves: (id) => view.cellCurves(id),
    cellMeasures: (id) => view.cellMeasures(id),
    cellArea: (id) => view.cellArea(id),
    cellCentroid: (id) => view.cellCentroid(id),
    cellPerimeter: (id) => view.cellPerimeter(id),
    cellGeometry: (id) => view.cellGeometry(id),
    contains: (id) => view.contains(id, 110, 100),
    neighbors: (id) => [...view.neighbors(id)],
  };
  const hidden = Object.fromEntries(Object.entries(uses).map(([name, use]) => [name, use(1)]));
  expect(hidden).toEqual({
    renderCell: "",
    cellPolygon: null,
    cellParts: null,
    cellCurves: null,
    cellMeasures: { area: 0, centroid: null, perimeter: 0 },
    cellArea: 0,
    cellCentroid: null,
    cellPerimeter: 0,
    cellGeometry: null,
    contains: false,
    neighbors: [],
  });
  expect(Object.fromEntries(Object.entries(uses).map(([name, use]) => [name, use(2)]))).toEqual(
    hidden,
  );
  // Numbers agree with the lists, also within a distance.
  for (const maxDistance of [Infinity, 3, -60, () => -60]) {
    const cells = few.voronoi([0, 0, 200, 200], { maxDistance });
    const [areas, perimeters] = [cells.cellAreas(), cells.cellPerimeters()];
    for (const id of few.ids()) {
      expect(areas[id]).toBeCloseTo(cells.cellArea(id), 9);
      expect(perimeters[id]).toBeCloseTo(cells.cellPerimeter(id), 9);
      expect(cells.cellMeasures(id).area).toBe(cells.cellArea(id));
      expect(Number.isNaN(cells.cellCentroids()[2 * id])).toBe(cells.cellCentroid(id) === null);
    }
  }
  for (const use of Object.values(uses)) {
    for (const id of [3, -1, 1.5, NaN, "0", null, undefined, 0xffffffff])
      expect(codeOf(() => use(id))).toBe("unknown-site");
  }
  few.dispose();
  for (const use of [
    ...Object.values(uses),
    () => view.render(),
    () => view.renderBounds(),
    () => view.cellAreas(),
    () => view.edgeCurves(),
    () => view.toGeoJSON(),
    () => [...view.cellPolygons()],
  ]) {
    expect(codeOf(() => use(0))).toBe("disposed");
  }
});
