// With equal weights the cells are those of d3-delaunay, and random diagrams, windows and histories
// keep the laws.
import { Delaunay } from "d3-delaunay";
import fc from "fast-check";
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator } from "./support/random.mjs";
import { ringArea } from "./support/recorder.mjs";

/** Each point of one ring is near the other ring. */
function distanceBetween(ring, other) {
  let worst = 0;
  for (let k = 0; k < ring.length; k += 2) {
    let best = Infinity;
    for (let m = 0; m + 3 < other.length; m += 2) {
      const [ax, ay] = [other[m], other[m + 1]];
      const [dx, dy] = [other[m + 2] - ax, other[m + 3] - ay];
      const length = dx * dx + dy * dy;
      const t =
        length > 0
          ? Math.max(0, Math.min(1, ((ring[k] - ax) * dx + (ring[k + 1] - ay) * dy) / length))
          : 0;
      best = Math.min(best, Math.hypot(ring[k] - ax - t * dx, ring[k + 1] - ay - t * dy));
    }
    worst = Math.max(worst, best);
  }
  return worst;
}

test.each([0, 5])("equal weights %p: the polygons of d3-delaunay", (r) => {
  const random = generator(81);
  const bounds = [0, 0, 960, 500];
  for (const count of [1, 2, 3, 10, 200]) {
    const points = Array.from({ length: count }, () => [
      random() * 1200 - 100,
      random() * 700 - 100,
    ]);
    const theirs = Delaunay.from(points).voronoi(bounds);
    const ours = new Diagram(points.flatMap(([x, y]) => [x, y, r])).voronoi(bounds);
    for (let id = 0; id < count; ++id) {
      const expected = theirs.cellPolygon(id);
      const ring = ours.cellPolygon(id, { flat: true });
      const area = expected ? Math.abs(ringArea(expected.flat())) : 0;
      expect(ours.cellArea(id)).toBeCloseTo(area, 6);
      if (area < 1e-6) continue;
      expect(distanceBetween(ring, expected.flat())).toBeLessThan(1e-8);
      expect(distanceBetween(expected.flat(), ring)).toBeLessThan(1e-8);
      // No more points than corners (a site exactly on a line may add one).
      expect(ring.length / 2).toBeLessThanOrEqual(expected.length + 1);
      if (count > 2) expect(new Set(ours.neighbors(id))).toEqual(new Set(theirs.neighbors(id)));
    }
  }
});

// Where four cells meet, d3-delaunay does not count the edge of length 0 either (except by
// rounding, as of 0.1).
test.each([1, 0.1, 7])("a lattice of unit %p has the neighbors of d3-delaunay", (unit) => {
  const points = Array.from({ length: 25 }, (_, k) => [unit * Math.floor(k / 5), unit * (k % 5)]);
  const bounds = [-0.5 * unit, -0.5 * unit, 4.5 * unit, 4.5 * unit];
  const [xmin, ymin, xmax, ymax] = bounds;
  const octagon = [
    [xmin, ymin],
    [2 * unit, ymin - unit],
    [xmax, ymin],
    [xmax + unit, 2 * unit],
    [xmax, ymax],
    [2 * unit, ymax + unit],
    [xmin, ymax],
    [xmin - unit, 2 * unit],
  ];
  const theirs = Delaunay.from(points).voronoi(bounds);
  const diagram = new Diagram(points.flatMap(([x, y]) => [x, y, 0]));
  for (const [window, options] of [[bounds], [[octagon]], [bounds, { maxDistance: 0.75 * unit }]]) {
    const ours = diagram.voronoi(window, options);
    for (const id of diagram.ids()) {
      const beside = [
        id - 5,
        id + 5,
        ...(id % 5 > 0 ? [id - 1] : []),
        ...(id % 5 < 4 ? [id + 1] : []),
      ];
      const expected = new Set(beside.filter((other) => other >= 0 && other < 25));
      expect(new Set(ours.neighbors(id))).toEqual(expected);
      if (unit !== 0.1) expect(new Set(theirs.neighbors(id))).toEqual(expected);
    }
    expect(ours.edgeCurves().sites).toHaveLength(2 * 40);
    for (const id of diagram.ids())
      expect(ours.cellCurves(id).neighbors.filter((other) => other !== -1)).toHaveLength(
        ours.neighbors(id).length,
      );
  }
  expect(diagram.voronoi(bounds).render().match(/M/g)).toHaveLength(40);
  expect(diagram.voronoi([octagon]).render().match(/M/g)).toHaveLength(40);
});

const coordinate = fc.oneof(
  fc.integer({ min: -6, max: 6 }),
  fc.double({ min: -50, max: 50, noNaN: true }).map((x) => (Math.abs(x) < 1e-90 ? 0 : x)),
);
const radius = fc.oneof(
  fc.integer({ min: 0, max: 4 }),
  fc.double({ min: 0, max: 20, noNaN: true }).map((r) => (r < 1e-90 ? 0 : r)),
);
const circle = fc.tuple(coordinate, coordinate, radius);
const window = fc
  .tuple(coordinate, coordinate, coordinate, coordinate)
  .filter(([a, b, c, d]) => Math.abs(a - c) > 0.01 && Math.abs(b - d) > 0.01)
  .map(([a, b, c, d]) => [Math.min(a, c), Math.min(b, d), Math.max(a, c), Math.max(b, d)]);

/** The cells by their circles, without ids: sorted [x, y, r, area]. */
function areasByCircle(diagram, bounds) {
  const areas = diagram.voronoi(bounds).cellAreas();
  return [...diagram.ids()]
    .filter((id) => !diagram.isHidden(id))
    .map((id) => {
      const { x, y, r } = diagram.site(id);
      return [x, y, r, areas[id]];
    })
    .sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2]);
}

test("any circles and window: cells fill it, polygons follow, histories do not matter", () => {
  fc.assert(
    fc.property(
      fc.array(circle, { minLength: 1, maxLength: 14 }),
      fc.array(circle, { maxLength: 6 }),
      window,
      (kept, passing, bounds) => {
        const whole = (bounds[2] - bounds[0]) * (bounds[3] - bounds[1]);
        const diagram = new Diagram(kept.flat());
        const voronoi = diagram.voronoi(bounds);
        const areas = voronoi.cellAreas();
        expect(Math.abs(areas.reduce((sum, area) => sum + area, 0) / whole - 1)).toBeLessThan(
          1e-12,
        );
        let sum = 0;
        for (const id of diagram.ids()) {
          if (diagram.isHidden(id)) {
            expect(voronoi.cellPolygon(id)).toBeNull();
            continue;
          }
          const measures = voronoi.cellMeasures(id);
          expect(Math.abs(measures.area - areas[id])).toBeLessThanOrEqual(1e-12 * whole);
          const regions = voronoi.cellParts(id, { flat: true }) ?? [];
          for (const [ring] of regions) sum += ringArea(ring);
          if (measures.centroid !== null && measures.area > 1e-6 * whole) {
            expect(measures.centroid[0]).toBeGreaterThanOrEqual(bounds[0]);
            expect(measures.centroid[0]).toBeLessThanOrEqual(bounds[2]);
            expect(measures.centroid[1]).toBeGreaterThanOrEqual(bounds[1]);
            expect(measures.centroid[1]).toBeLessThanOrEqual(bounds[3]);
          }
        }
        expect(Math.abs(sum / whole - 1)).toBeLessThan(0.02);

        // Another history of the same set.
        const other = new Diagram(passing.flat());
        const first = [...other.ids()];
        other.insertMany([...kept].reverse().flat());
        other.removeMany(first);
        const [expected, got] = [areasByCircle(diagram, bounds), areasByCircle(other, bounds)];
        expect(got.map((row) => row.slice(0, 3))).toEqual(expected.map((row) => row.slice(0, 3)));
        got.forEach((row, k) =>
          expect(Math.abs(row[3] - expected[k][3])).toBeLessThanOrEqual(1e-12 * whole),
        );
        diagram.dispose();
        other.dispose();
      },
    ),
    { seed: 82, numRuns: 300 },
  );
});
