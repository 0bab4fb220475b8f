// Sequences of calls by their names, every public one of Diagram among them, on several diagrams,
// against a brute-force model. With APOLLONIUS_THOROUGH=1 twenty times as many.
import fc from "fast-check";
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { isThorough } from "../support/effort.mjs";
import { circle, circles, fraction, fractions, pick } from "./support/arbitraries.mjs";
import { BruteForce } from "./support/brute_force.mjs";
import { diagnosticsCalls, diagramCalls } from "./support/calls.mjs";
import { graph, snapshot } from "./support/graph.mjs";
import { asking } from "./support/questions.mjs";

const runs = isThorough ? 6000 : 100;
const MOST_DIAGRAMS = 3;

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
 * name → [arbitraries of the arguments, function of a diagram, its model and the arguments].
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
  /** A refused call changes nothing. */
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
        ["unknown-site", (d) => d.remove(0.5)],
        ["unknown-site", (d) => d.removeMany([...d.ids(), null])],
        ["unknown-site", (d) => d.has("0")],
        ["not-finite", (d) => d.within(0, 0, -Infinity)],
        ["bad-bounds", (d) => d.search(0, 0, 1, -Infinity)],
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

/**
 * Calls that make diagrams, or dispose of them: name → [arguments, function of all diagrams and the
 * number of one].
 */
const making = {
  constructor: [
    [circles(0, 12), fc.constantFrom(undefined, -1, 0, 2)],
    (all, _, given, r) => {
      const pairs = given.flatMap((circle) => circle.slice(0, 2));
      const numbers = r === undefined ? given.flat() : pairs;
      const circles = given.map(([x, y, own]) => [x, y, r ?? own]);
      begin(all, new Diagram(numbers, { r }), circles);
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
      for (const [name, { use }] of Object.entries({ ...diagramCalls, ...diagnosticsCalls })) {
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
    expect(validate(all[at].d)).toBeNull();
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
  const missing = Object.keys({ ...diagramCalls, ...diagnosticsCalls }).filter(
    (name) => !names.includes(name),
  );
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
