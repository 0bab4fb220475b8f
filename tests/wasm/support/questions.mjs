// Every public question that a diagram answers, and the answer of a brute-force model.
import fc from "fast-check";
import { levels, validate } from "../../../build/packed/diagnostics.mjs";
import { fraction, pick, point } from "./arbitraries.mjs";
import { distanceTo, farSide } from "./brute_force.mjs";
import { isInside, Recorder } from "./recorder.mjs";

const circleOf = (diagram, id) => {
  const { x, y, r } = diagram.site(id);
  return [x, y, r];
};

/**
 * name → [arbitraries of the arguments, question to a diagram, its model and the arguments].
 */
export const asking = {
  size: [[], (d, m) => expect(d.size).toBe(m.size)],
  visibleSize: [[], (d, m) => expect(d.visibleSize).toBe(m.visibleCircles.length)],
  hiddenSize: [[], (d, m) => expect(d.hiddenSize).toBe(m.size - m.visibleCircles.length)],
  has: [
    [fraction],
    (d, m, at) => {
      for (const id of [pick(m.ids, at) ?? 0, Math.floor(at * 60), -1, 2 ** 32])
        expect(d.has(id)).toBe(m.circles.has(id));
    },
  ],
  site: [[], (d, m) => m.circles.forEach((c, id) => expect(circleOf(d, id)).toEqual(c))],
  ids: [[], (d, m) => expect([...d.ids()]).toEqual(m.ids)],
  sites: [
    [],
    (d, m) => {
      const { ids, xyr, hidden } = d.sites();
      expect([...ids]).toEqual(m.ids);
      expect([...xyr]).toEqual(m.ids.flatMap((id) => m.circles.get(id)));
      expect([...hidden]).toEqual(m.ids.map((id) => Number(d.isHidden(id))));
    },
  ],
  toJSON: [
    [],
    (d, m) =>
      expect(d.toJSON()).toEqual(
        m.ids.map((id) => ({ id, ...d.site(id), hidden: d.isHidden(id) })),
      ),
  ],
  isHidden: [
    [],
    (d, m) => {
      for (const id of m.ids) {
        const isFirst = m.identicalTo(id)[0] === id;
        expect(d.isHidden(id)).toBe(!m.isCandidate(id) || !isFirst);
      }
    },
  ],
  coverOf: [
    [],
    (d, m) => {
      for (const id of m.ids) {
        const cover = d.coverOf(id);
        expect(cover === -1).toBe(!d.isHidden(id));
        if (cover === -1) continue;
        expect(d.isHidden(cover)).toBe(false);
        const [x, y, r] = m.circles.get(id);
        expect(distanceTo(m.circles.get(cover), x, y)).toBeLessThanOrEqual(-r + 1e-9);
      }
    },
  ],
  find: [
    [point],
    (d, m, [x, y]) => {
      const id = d.find(x, y);
      expect(id === -1 ? undefined : m.circles.get(id)).toEqual(m.sortedAt(x, y)[0]);
      if (id !== -1) expect(d.isHidden(id)).toBe(false);
    },
  ],
  nearest: [
    [point],
    (d, m, [x, y]) => {
      const found = d.nearest(x, y);
      if (m.size === 0) return expect(found).toBeNull();
      expect(m.circles.get(found.id)).toEqual(m.sortedAt(x, y)[0]);
      expect(found.distance).toBeCloseTo(distanceTo(m.sortedAt(x, y)[0], x, y), 9);
    },
  ],
  farthest: [
    [point],
    (d, m, [x, y]) => {
      const found = d.farthest(x, y);
      if (m.size === 0) return expect(found).toBeNull();
      expect(m.circles.get(found.id)).toEqual(m.farthestFrom(x, y));
      expect(found.distance).toBeCloseTo(farSide(m.farthestFrom(x, y), x, y), 9);
      expect(d.isHidden(found.id)).toBe(false);
    },
  ],
  findMany: [
    [fc.array(point, { maxLength: 8 }), fc.constantFrom(-1, 0, 3, Infinity)],
    (d, _, points, maxDistance) => {
      const expected = points.map(([x, y]) => d.find(x, y, { maxDistance }));
      expect([...d.findMany(points.flat(), { maxDistance })]).toEqual(expected);
    },
  ],
  nearestMany: [
    [fc.array(point, { maxLength: 8 }), fc.constantFrom(-1, 0, 3, Infinity)],
    (d, m, points, maxDistance) => {
      const { ids, distances } = d.nearestMany(points.flat(), { maxDistance });
      expect(ids.length).toBe(points.length);
      points.forEach(([x, y], k) => {
        expect(d.find(x, y, { maxDistance })).toBe(ids[k]);
        expect(d.nearest(x, y, { maxDistance })?.distance ?? Infinity).toBe(distances[k]);
        const [nearest] = d.kNearest(x, y, 1, { maxDistance }); // exact, as `within` is
        if (nearest === undefined) return expect([ids[k], distances[k]]).toEqual([-1, Infinity]);
        expect(m.circles.get(ids[k])).toEqual(m.sortedAt(x, y)[0]);
        expect(distances[k]).toBeCloseTo(distanceTo(m.circles.get(ids[k]), x, y), 9);
      });
    },
  ],
  kNearest: [
    [
      point,
      fc.oneof(fc.integer({ min: 0, max: 12 }), fc.constant(Infinity)),
      fc.oneof(fc.integer({ min: -4, max: 9 }), fc.constant(Infinity)),
    ],
    (d, m, [x, y], k, maxDistance) => {
      const ids = [...d.kNearest(x, y, k, { maxDistance })];
      expect(new Set(ids).size).toBe(ids.length);
      expect(ids.map((id) => m.circles.get(id))).toEqual(m.within(x, y, maxDistance).slice(0, k));
    },
  ],
  within: [
    [point, fc.oneof(fc.integer({ min: -4, max: 9 }), fc.constant(Infinity))],
    (d, m, [x, y], distance) => {
      const ids = [...d.within(x, y, distance)];
      expect(new Set(ids).size).toBe(ids.length);
      expect(ids.map((id) => m.circles.get(id))).toEqual(m.within(x, y, distance));
    },
  ],
  kNearestMany: [
    [
      fc.array(point, { maxLength: 8 }),
      fc.oneof(fc.integer({ min: 0, max: 12 }), fc.constant(Infinity)),
      fc.oneof(fc.integer({ min: -4, max: 9 }), fc.constant(Infinity)),
      fc.constantFrom(undefined, (id) => id % 2 === 0),
      fc.boolean(),
    ],
    (d, m, points, k, maxDistance, filter, distances) => {
      const options = { maxDistance, filter, distances };
      listsAlike(m, points, d.kNearestMany(points.flat(), k, options), (x, y) =>
        d.kNearest(x, y, k, { maxDistance, filter }),
      );
    },
  ],
  withinMany: [
    [
      fc.array(point, { maxLength: 8 }),
      fc.oneof(fc.integer({ min: -4, max: 9 }), fc.constant(Infinity)),
      fc.constantFrom(undefined, (id) => id % 2 === 0),
    ],
    (d, m, points, distance, filter) => {
      const options = { filter, distances: true };
      listsAlike(m, points, d.withinMany(points.flat(), distance, options), (x, y) =>
        d.within(x, y, distance, { filter }),
      );
    },
  ],
  pick: [
    [point, fc.constantFrom(0, 3, Infinity), fc.constantFrom("smallest", "last")],
    (d, m, [x, y], maxDistance, top) => {
      expect(d.pick(x, y, { maxDistance, top })).toBe(m.pick(x, y, maxDistance, top));
    },
  ],
  pickMany: [
    [fc.array(point, { maxLength: 20 }), fc.constantFrom(0, 3, Infinity)],
    (d, _, points, maxDistance) => {
      const expected = points.map(([x, y]) => d.pick(x, y, { maxDistance }));
      expect([...d.pickMany(points.flat(), { maxDistance })]).toEqual(expected);
    },
  ],
  search: [
    [point, point, fc.array(fc.integer({ min: 0, max: 3 }), { maxLength: 4 })],
    (d, m, [x, y], [width, height], open) => {
      const box = [x, y, x + Math.abs(width), y + Math.abs(height)];
      for (const side of open) box[side] = side < 2 ? -Infinity : Infinity;
      expect([...d.search(...box)]).toEqual(m.search(...box));
    },
  ],
  neighbors: [
    [],
    (d) => {
      const { sites } = d.edges();
      const pairs = new Set();
      for (let k = 0; k < sites.length; k += 2)
        pairs.add(`${sites[k]} ${sites[k + 1]}`).add(`${sites[k + 1]} ${sites[k]}`);
      const named = [...d.ids()].flatMap((id) =>
        [...d.neighbors(id)].map((other) => `${id} ${other}`),
      );
      expect(named.sort()).toEqual([...pairs].sort());
    },
  ],
  edges: [
    [],
    (d) => {
      const { sites, vertices } = d.edges(),
        { sites: corners } = d.vertices();
      vertices.forEach((row, k) => {
        if (row === -1) return;
        const own = [...corners.slice(3 * row, 3 * row + 3)];
        for (const site of sites.slice(k - (k % 2), k - (k % 2) + 2)) expect(own).toContain(site);
      });
      // Each vertex is an end of three edges.
      const ends = new Array(corners.length / 3).fill(0);
      for (const row of vertices) if (row !== -1) ++ends[row];
      expect(ends.every((count) => count === 3)).toBe(true);
    },
  ],
  vertices: [
    [],
    (d, m) => {
      const { xy, clearance, sites } = d.vertices();
      clearance.forEach((s, k) => {
        const [x, y] = xy.slice(2 * k, 2 * k + 2),
          size = 1e-9 * (Math.abs(x) + Math.abs(y) + Math.abs(s) + 1);
        for (const site of sites.slice(3 * k, 3 * k + 3))
          expect(Math.abs(distanceTo(m.circles.get(site), x, y) - s)).toBeLessThanOrEqual(size);
        for (const c of m.circles.values())
          expect(distanceTo(c, x, y)).toBeGreaterThanOrEqual(s - size);
      });
    },
  ],
  voronoi: [
    [point, fc.integer({ min: 1, max: 20 })],
    (d, m, [x, y], size) => {
      const voronoi = d.voronoi([x - size, y - size, x + size, y + size + 1]);
      const whole = 2 * size * (2 * size + 1);
      if (m.size > 0)
        expect(voronoi.cellAreas().reduce((sum, area) => sum + area, 0) / whole).toBeCloseTo(1, 9);
      for (const id of m.ids) {
        const isNearest =
          !d.isHidden(id) && String(m.circles.get(id)) === String(m.sortedAt(x, y)[0]);
        expect(voronoi.contains(id, x, y)).toBe(isNearest);
      }
      // The owner of a point that is clearly one site's.
      const [px, py] = [x + 0.37, y - 0.29];
      const [first, second] = m.visibleCircles
        .map((c) => distanceTo(c, px, py))
        .sort((a, b) => a - b);
      if (first === undefined || second - first < 0.1 * size) return;
      const cells = [...voronoi.cellPolygons({ flat: true })].filter((cell) =>
        isInside(cell, px, py),
      );
      expect(cells.map((cell) => cell.index)).toEqual([d.find(px, py)]);
    },
  ],
  levels: [
    [],
    (d, m) => {
      const counts = levels(d);
      for (const id of m.ids) expect(counts[id] > 0).toBe(!d.isHidden(id));
      expect(counts.filter((count) => count > 0)).toHaveLength(d.visibleSize);
    },
  ],
  triangulation: [
    [],
    (d, m) => {
      const { points, triangles, halfedges } = d.triangulation();
      for (const [id, [x, y]] of m.circles)
        expect([...points.slice(2 * id, 2 * id + 2)]).toEqual([x, y]);
      expect(triangles).toEqual(d.vertices().sites);
      const end = (e) => triangles[e % 3 === 2 ? e - 2 : e + 1];
      halfedges.forEach((twin, e) => {
        if (twin === -1) return;
        expect(halfedges[twin]).toBe(e);
        expect([end(twin), triangles[twin]]).toEqual([triangles[e], end(e)]);
      });
    },
  ],
  hull: [
    [],
    (d, m) => {
      const ids = [...d.hull()];
      expect(ids.length === 0).toBe(m.size === 0);
      for (const id of ids) expect(d.isHidden(id)).toBe(false);
      for (let k = 0; k < 24 && m.size > 0; ++k) {
        const [ux, uy] = [Math.cos(k * 0.2618), Math.sin(k * 0.2618)];
        const most = Math.max(
          ...ids.map((id) => m.circles.get(id)).map(([x, y, r]) => x * ux + y * uy + r),
        );
        expect(most).toBeCloseTo(m.reach(ux, uy), 9);
      }
    },
  ],
  render: [
    [fc.boolean()],
    (d, _m, withRays) =>
      drawnAlike((context) => d.render(context, withRays ? { bounds: [-9, -9, 9, 9] } : {})),
  ],
  renderSites: [
    [],
    (d, m) => {
      const context = drawnAlike((target) => d.renderSites(target));
      expect(context.count("moveTo")).toBe(
        [...m.circles.values()].filter(([, , r]) => r > 0).length,
      );
    },
  ],
  renderHull: [[], (d) => drawnAlike((context) => d.renderHull(context))],
  smallestEnclosingCircle: [
    [],
    (d, m) => {
      const circle = d.smallestEnclosingCircle();
      if (m.size === 0) return expect(circle).toBeNull();
      const { x, y, r, sites } = circle;
      expect(farSide(m.farthestFrom(x, y), x, y)).toBeCloseTo(r, 9);
      const touching = [...sites].map((id) => m.circles.get(id));
      for (const one of touching) expect(farSide(one, x, y)).toBeCloseTo(r, 9);
      for (const id of sites) expect(d.isHidden(id)).toBe(false);
      // It is the smallest one if no shift of its centre comes closer to all of these.
      for (let k = 0; k < 24; ++k) {
        const [ux, uy] = [Math.cos(k * 0.2618), Math.sin(k * 0.2618)];
        const ahead = touching.map(([cx, cy]) => (cx - x) * ux + (cy - y) * uy);
        expect(Math.min(...ahead)).toBeLessThanOrEqual(1e-9);
      }
    },
  ],
  validate: [[], (d) => expect(validate(d)).toBeNull()],
};

/** Expects one list a point, with the circles of a single call and their distances. */
function listsAlike(m, points, { ids, starts, distances }, one) {
  expect(starts.length).toBe(points.length + 1);
  expect(starts.at(-1)).toBe(ids.length);
  points.forEach(([x, y], k) => {
    const list = [...ids.subarray(starts[k], starts[k + 1])];
    const circles = list.map((id) => m.circles.get(id));
    expect(circles).toEqual([...one(x, y)].map((id) => m.circles.get(id)));
    expect(new Set(list).size).toBe(list.length);
    circles.forEach((circle, at) => {
      if (distances) expect(distances[starts[k] + at]).toBeCloseTo(distanceTo(circle, x, y), 9);
    });
  });
  if (distances) expect(distances.length).toBe(ids.length);
}

/** A path string and a context get the same commands, with finite numbers. */
function drawnAlike(draw) {
  const context = new Recorder();
  draw(context);
  const letters = { moveTo: "M", lineTo: "L", bezierCurveTo: "C", closePath: "Z" };
  expect([...draw(null).matchAll(/[MLCZ]/g)].join("")).toBe(
    context.calls.map(([name]) => letters[name]).join(""),
  );
  expect(context.calls.every(([, ...numbers]) => numbers.every(Number.isFinite))).toBe(true);
  return context;
}
