// Sequences of calls by their names, every public one of Diagram among them, on several diagrams,
// against a brute-force model. With APOLLONIUS_THOROUGH=1 twenty times as many.
import fc from "fast-check";
import { Diagram } from "../../build/packed/consumer.mjs";
import { circle, circles, fraction, fractions, point } from "./support/arbitraries.mjs";
import { BruteForce, distanceTo } from "./support/brute_force.mjs";
import { diagramCalls } from "./support/calls.mjs";
import { graph, snapshot } from "./support/graph.mjs";
import { isInside, Recorder } from "./support/recorder.mjs";

const runs = process.env.APOLLONIUS_THOROUGH ? 6000 : 300;
const MOST_DIAGRAMS = 3;

const pick = (items, at) => items[Math.floor(at * items.length)];

const circleOf = (diagram, id) => {
  const { x, y, r } = diagram.site(id);
  return [x, y, r];
};
const refused = (code, call) => {
  let thrown = null;
  try {
    call();
  } catch (error) {
    thrown = error;
  }
  expect(thrown?.code).toBe(code);
};

/**
 * name → [arbitraries of the arguments, what is done with a diagram, its model and the arguments].
 */
const changing = {
  insert: [
    [circle, fc.boolean()],
    (d, m, [x, y, r], isPoint) => {
      const id = isPoint ? d.insert(x, y) : d.insert(x, y, r);
      expect(m.circles.has(id)).toBe(false);
      m.circles.set(id, [x, y, isPoint ? 0 : r]);
    },
  ],
  insertMany: [
    [circles(0, 10), fc.boolean()],
    (d, m, added, isTyped) => {
      const ids = d.insertMany(isTyped ? Float64Array.from(added.flat()) : added.flat());
      expect(ids.length).toBe(added.length);
      ids.forEach((id, k) => {
        expect(m.circles.has(id)).toBe(false);
        m.circles.set(id, added[k]);
      });
    },
  ],
  remove: [
    [fraction],
    (d, m, at) => {
      const id = pick(m.ids, at);
      expect(d.remove(id ?? 1000)).toBe(m.circles.delete(id));
    },
  ],
  removeMany: [
    [fractions(6), fc.boolean()],
    (d, m, chosen, withOthers) => {
      const ids = chosen.map((at) => pick(m.ids, at) ?? 1000);
      if (withOthers) ids.push(2000, ids[0] ?? 3000);
      const count = ids.filter((id) => m.circles.delete(id)).length;
      expect(d.removeMany(ids)).toBe(count);
    },
  ],
  update: [
    [fraction, circle, fc.boolean()],
    (d, m, at, [x, y, r], keepsRadius) => {
      const id = pick(m.ids, at);
      if (id === undefined) return refused("unknown-site", () => d.update(0, x, y, r));
      expect(keepsRadius ? d.update(id, x, y) : d.update(id, x, y, r)).toBe(d);
      m.circles.set(id, [x, y, keepsRadius ? m.circles.get(id)[2] : r]);
    },
  ],
  updateMany: [
    [fractions(6), circles(6, 6)],
    (d, m, chosen, next) => {
      const ids = [
        ...new Set(chosen.map((at) => pick(m.ids, at)).filter((id) => id !== undefined)),
      ];
      expect(d.updateMany(ids, next.slice(0, ids.length).flat())).toBe(d);
      ids.forEach((id, k) => m.circles.set(id, next[k]));
    },
  ],
  /** All at once: grown, shrunk, moved, turned, or mirrored. */
  "updateMany of all": [
    [
      fc.constantFrom(
        ([x, y, r]) => [x, y, r + 2],
        ([x, y, r]) => [x, y, Math.max(0, r - 2)],
        ([x, y, r]) => [x + 3, y - 1, r],
        ([x, y, r]) => [-y, x, r],
        ([x, y, r]) => [x, -y, r],
        ([x, y]) => [x, y, 1],
        ([, , r]) => [0, 0, r],
        ([x, y, r]) => [2 * x, 2 * y, r],
        ([x, y, r]) => [Math.trunc(x / 2), Math.trunc(y / 2), r],
      ),
    ],
    (d, m, move) => {
      const far = [...m.circles.values()].some((c) => c.some((value) => Math.abs(value) > 100));
      if (far) return;
      for (const [id, c] of m.circles)
        m.circles.set(
          id,
          move(c).map((value) => value + 0),
        );
      d.updateMany(
        m.ids,
        m.ids.flatMap((id) => m.circles.get(id)),
      );
    },
  ],
  clear: [
    [],
    (d, m) => {
      expect(d.clear()).toBe(d);
      m.circles.clear();
    },
  ],
  /** What is refused changes nothing. */
  "a refused call": [
    [
      fc.constantFrom(
        ["not-finite", (d) => d.insert(1, NaN, 2)],
        ["out-of-range", (d) => d.insert(1, 1e200)],
        ["bad-length", (d) => d.insertMany([1, 2, 3, 4])],
        ["not-finite", (d) => d.insertMany([1, 2, 3, 4, "5", 6])],
        ["unknown-site", (d) => d.update(5000, 1, 2, 3)],
        ["bad-length", (d) => d.removeMany(5)],
        [
          "unknown-site",
          (d) => d.updateMany([...d.ids(), 5000], new Array(3 * d.size + 3).fill(1)),
        ],
        ["bad-length", (d) => d.updateMany(d.ids(), [1])],
        ["not-finite", (d) => d.findMany([1, undefined])],
        ["unknown-site", (d) => d.neighbors(-1)],
        ["unknown-site", (d) => d.site(0.5)],
        ["unknown-site", (d) => d.isHidden(NaN)],
        ["unknown-site", (d) => d.coverOf("0")],
        ["bad-bounds", (d) => d.voronoi([0, 0, 0, 1])],
        ["out-of-range", (d) => d.kNearest(0, 0, -1)],
        ["not-finite", (d) => d.within(0, 0, Infinity)],
        ["out-of-range", (d) => d.render(null, { digits: 99 })],
      ),
    ],
    (d, _m, [code, call]) => {
      const before = snapshot(d);
      refused(code, () => call(d));
      expect(snapshot(d)).toBe(before);
    },
  ],
};

const asking = {
  size: [[], (d, m) => expect(d.size).toBe(m.size)],
  visibleSize: [[], (d, m) => expect(d.visibleSize).toBe(m.visibleCircles.length)],
  hiddenSize: [[], (d, m) => expect(d.hiddenSize).toBe(m.size - m.visibleCircles.length)],
  has: [
    [fraction],
    (d, m, at) => {
      for (const id of [pick(m.ids, at) ?? 0, Math.floor(at * 60), -1, 0.5])
        expect(d.has(id)).toBe(m.circles.has(id));
    },
  ],
  site: [[], (d, m) => m.circles.forEach((c, id) => expect(circleOf(d, id)).toEqual(c))],
  ids: [[], (d, m) => expect([...d.ids()]).toEqual(m.ids)],
  isHidden: [
    [],
    (d, m) => {
      for (const id of m.ids) {
        if (!m.isCandidate(id)) expect(d.isHidden(id)).toBe(true);
        else expect(m.identicalTo(id).filter((same) => !d.isHidden(same)).length).toBe(1);
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
  findMany: [
    [fc.array(point, { maxLength: 8 }), fc.boolean()],
    (d, m, points, withDistances) => {
      const distances = new Float64Array(points.length);
      const ids = withDistances ? d.findMany(points.flat(), distances) : d.findMany(points.flat());
      expect(ids.length).toBe(points.length);
      points.forEach(([x, y], k) => {
        const nearest = m.sortedAt(x, y)[0];
        expect(m.circles.get(ids[k])).toEqual(nearest);
        if (withDistances && nearest)
          expect(distances[k]).toBeCloseTo(distanceTo(nearest, x, y), 9);
        if (withDistances && !nearest) expect(distances[k]).toBe(Infinity);
      });
    },
  ],
  kNearest: [
    [point, fc.oneof(fc.integer({ min: 0, max: 12 }), fc.constant(Infinity))],
    (d, m, [x, y], k) => {
      const ids = [...d.kNearest(x, y, k)];
      expect(new Set(ids).size).toBe(ids.length);
      expect(ids.map((id) => m.circles.get(id))).toEqual(m.sortedAt(x, y).slice(0, k));
    },
  ],
  within: [
    [point, fc.integer({ min: -4, max: 9 })],
    (d, m, [x, y], distance) => {
      const ids = [...d.within(x, y, distance)];
      expect(new Set(ids).size).toBe(ids.length);
      expect(ids.map((id) => m.circles.get(id))).toEqual(m.within(x, y, distance));
    },
  ],
  pick: [
    [point, fc.constantFrom(0, 3, Infinity), fc.constantFrom("smallest", "last")],
    (d, m, [x, y], farthest, top) => {
      const [id, expected] = [d.pick(x, y, farthest, { top }), m.pick(x, y, farthest, top)];
      if (m.circles.get(expected) !== m.circles.get(id)) expect(id).toBe(expected);
    },
  ],
  search: [
    [point, point],
    (d, m, [x, y], [width, height]) => {
      const box = [x, y, x + Math.abs(width), y + Math.abs(height)];
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
      const { coordinates, clearance, sites } = d.vertices();
      clearance.forEach((s, k) => {
        const [x, y] = coordinates.slice(2 * k, 2 * k + 2),
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
      const cells = [...voronoi.cellPolygons()].filter((cell) => isInside(cell, px, py));
      expect(cells.map((cell) => cell.index)).toEqual([d.find(px, py)]);
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
  validate: [[], (d) => expect(d.validate()).toBeNull()],
};

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

/**
 * Calls that make diagrams, or end them: name → [arguments, what is done with all diagrams, the
 * number of one].
 */
const making = {
  constructor: [
    [circles(0, 12), fc.constantFrom("hierarchy", "walk")],
    (all, _, given, location) => {
      begin(all, new Diagram(given.flat(), { location }), given);
    },
  ],
  from: [
    [circles(0, 8), fc.boolean()],
    (all, _, given, areObjects) => {
      begin(
        all,
        areObjects
          ? Diagram.from(given.map(([x, y, r]) => ({ x, y, r })))
          : Diagram.from(
              given,
              (c) => c[0],
              (c) => c[1],
              (c) => c[2],
            ),
        given,
      );
    },
  ],
  /** The old one goes on beside its copy, or goes. */
  "fromBytes and toBytes": [
    [fc.boolean(), fc.boolean()],
    (all, at, trusted, goesOn) => {
      const { d, m } = all[at],
        bytes = d.toBytes();
      const copy = Diagram.fromBytes(bytes, { trusted });
      if (!trusted) expect(copy.toBytes()).toEqual(bytes);
      if (goesOn && all.length < MOST_DIAGRAMS) return all.push({ d: copy, m: m.copy() });
      d.dispose();
      all[at] = { d: copy, m };
    },
  ],
  dispose: [
    [fc.boolean()],
    (all, at, bySymbol) => {
      const { d } = all[at];
      for (let time = 0; time < 2; ++time) {
        if (bySymbol && Symbol.dispose) d[Symbol.dispose]();
        else d.dispose();
      }
      for (const [name, { use }] of Object.entries(diagramCalls)) {
        if (!["constructor", "from"].includes(name)) refused("disposed", () => use(d));
      }
      all.splice(at, 1);
      if (all.length === 0) begin(all, new Diagram(), []);
    },
  ],
};

function begin(all, diagram, given) {
  const made = { d: diagram, m: new BruteForce(new Map(given.map((c, id) => [id, c]))) };
  if (all.length < MOST_DIAGRAMS) return all.push(made);
  all[0].d.dispose();
  all[0] = made;
}

class Call {
  constructor(name, which, values, run) {
    Object.assign(this, { name, which, values, run_: run });
  }
  check() {
    return true;
  }
  /** Each diagram has its model beside it. */
  run(_, all) {
    this.run_(all, Math.floor(this.which * all.length), this.values);
  }
  toString() {
    const values = this.values.map((value) => fc.stringify(value)).join(", ");
    return `${this.name}(diagram ${this.which.toFixed(2)}: ${values})`;
  }
}

const commandsOf = (calls, run) =>
  Object.entries(calls).map(([name, [arbitraries, action]]) =>
    fc
      .tuple(fraction, ...arbitraries)
      .map(([which, ...values]) => new Call(name, which, values, run(action))),
  );

const commands = [
  ...commandsOf(changing, (action) => (all, at, values) => {
    action(all[at].d, all[at].m, ...values);
    expect(all[at].d.validate()).toBeNull();
  }),
  ...commandsOf(
    asking,
    (action) => (all, at, values) => void action(all[at].d, all[at].m, ...values),
  ),
  ...commandsOf(making, (action) => (all, at, values) => void action(all, at, ...values)),
];

test("every public call of Diagram is among them", () => {
  const names = Object.keys({ ...changing, ...asking, ...making }).flatMap((name) =>
    name.split(" "),
  );
  const missing = Object.keys(diagramCalls).filter((name) => !names.includes(name));
  expect(missing).toEqual([]);
});

test("any sequence of calls is answered as brute force answers it", () => {
  fc.assert(
    fc.property(
      circles(0, 10),
      fc.commands(commands, { maxCommands: 100, size: "max" }),
      (first, sequence) => {
        const all = [];
        try {
          fc.modelRun(() => {
            begin(all, new Diagram(first.flat()), first);
            return { model: {}, real: all };
          }, sequence);
          for (const { d, m } of all) {
            for (const [, [arbitraries, action]] of Object.entries(asking))
              if (arbitraries.length === 0) action(d, m);
            const fresh = new Diagram([...m.circles.values()].flat());
            expect(graph(d)).toEqual(graph(fresh));
            fresh.dispose();
          }
        } finally {
          for (const { d } of all) d.dispose();
        }
      },
    ),
    { numRuns: runs, seed: 20261122 },
  );
}, 3_600_000);
