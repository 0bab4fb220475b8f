// A caller's own code runs in the middle of a call, and its arrays pretend to be others: afterwards
// the diagram is sound, as it was or as that code left it; what is thrown is that code's own or
// typed, never a trap; and nothing was read from a heap that has moved.
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { graph, snapshot } from "./support/graph.mjs";
import { randomCircles } from "./support/random.mjs";
import { Recorder } from "./support/recorder.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const built = () => new Diagram(randomCircles(50, 71));
const expected = snapshot(built());
const own = new Error("the caller's own");
const throwOwn = () => {
  throw own;
};

// --- Wrong lengths -------------------------------------------------------------------------------

const withLength = (array, length) => Object.defineProperty(array, "length", { value: length });
function changing(array, ...lengths) {
  return Object.defineProperty(array, "length", {
    get: () => (lengths.length > 1 ? lengths.shift() : lengths[0]),
  });
}
const pretending = (array, tag) => Object.defineProperty(array, Symbol.toStringTag, { value: tag });
class Longer extends Float64Array {
  get length() {
    return 3000;
  }
}

test.each([
  ["shorter", (bytes) => withLength(bytes, 8)],
  ["longer", (bytes) => withLength(bytes, 1 << 20)],
  ["now and then", (bytes) => changing(bytes, 0, 8, 1 << 20)],
])("bytes that say they are %s do not reach beyond their place in the heap", (_, change) => {
  const neighbours = Array.from({ length: 5 }, built);
  expect(graph(Diagram.fromBytes(change(built().toBytes())))).toEqual(graph(built()));
  for (const diagram of neighbours) {
    expect(validate(diagram)).toBeNull();
    expect(snapshot(diagram)).toBe(expected);
  }
});

test.each([
  ["shorter", withLength(randomCircles(10, 72), 3)],
  ["longer", withLength(randomCircles(10, 72), 3000)],
  ["now and then", changing(randomCircles(10, 72), 3, 0, 1 << 20)],
  ["by their class", new Longer(randomCircles(10, 72))],
  ["of another kind", pretending(randomCircles(10, 72), "Uint8Array")],
])("typed arrays with a wrong length or kind are taken as what they are: %s", (_, xyr) => {
  const diagram = new Diagram(xyr);
  expect(snapshot(diagram)).toBe(snapshot(new Diagram(randomCircles(10, 72))));
  expect(diagram.insertMany(xyr).length).toBe(10);
  expect(diagram.findMany(xyr).length).toBe(15);
  expect(validate(diagram)).toBeNull();
});

test("ids with a wrong length", () => {
  const diagram = built();
  expect(diagram.removeMany(withLength(new Uint32Array([1, 2]), 100_000))).toBe(2);
  expect(diagram.removeMany(withLength(new Uint32Array([3, 4]), 1))).toBe(2);
  const posing = (...ids) => Object.setPrototypeOf(new Float64Array(ids), Uint32Array.prototype);
  expect(diagram.removeMany(posing(5, 2 ** 32 + 6))).toBe(1);
  expectRefusal(() => diagram.removeMany(posing(7, 6.5)), "unknown-site", "ids[1]: site 6.5");
  expectRefusal(
    () => diagram.updateMany(withLength(new Uint32Array(100_000), 1), [1, 2, 3]),
    "bad-length",
    "expected 300000 values",
  );
  expect(validate(diagram)).toBeNull();
});

test.each([
  -1,
  NaN,
  1.5,
  Infinity,
  "3",
  null,
  {},
  { valueOf: () => 3 },
  3n,
  Symbol("3"),
])("array-likes of length %p are refused", (length) => {
  const diagram = built();
  const values = { length, 0: 1, 1: 2, 2: 3 };
  for (const call of [
    () => diagram.insertMany(values),
    () => diagram.removeMany(values),
    () => diagram.findMany(values),
    () => Diagram.from(values),
  ]) {
    expectRefusal(call, "bad-length", "");
  }
  expect(snapshot(diagram)).toBe(expected);
});

test("proxies whose length changes, and whose elements are not there", () => {
  const diagram = built();
  const proxy = (...lengths) =>
    new Proxy([1, 2, 3], {
      get: (target, key) =>
        key === "length" ? (lengths.length > 1 ? lengths.shift() : lengths[0]) : target[key],
    });
  for (const lengths of [
    [3, 6],
    [6, 3],
    [3, 3e9],
    [3, NaN],
    [0, 3],
  ]) {
    try {
      diagram.insertMany(proxy(...lengths));
    } catch (error) {
      expect(error).toBeInstanceOf(ApolloniusError);
    }
    expect(validate(diagram)).toBeNull();
  }
});

test("a list that grows or shrinks while accessors read it", () => {
  const growing = [[1, 2, 3]],
    shrinking = [
      [1, 2, 3],
      [4, 5, 6],
    ];
  expect(
    Diagram.from(growing, ([x]) => {
      growing.push([x, 0, 0]);
      return x;
    }).size,
  ).toBe(1);
  expectRefusal(
    () =>
      Diagram.from(shrinking, (item) => {
        shrinking.length = 1;
        return item ? 1 : undefined;
      }),
    "not-finite",
    "item 1 is undefined",
  );
});

// --- Buffers that go away while other arguments are read -----------------------------------------

const detach = (array) => {
  structuredClone(array, { transfer: [array.buffer] });
};
test.each([
  [
    "constructor",
    (_, away) => {
      const xyr = new Float64Array(6);
      return new Diagram(xyr, {
        get r() {
          away(xyr);
          return undefined;
        },
      });
    },
  ],
  [
    "fromBytes",
    (d, away) => {
      const bytes = d.toBytes();
      return Diagram.fromBytes(bytes, {
        get trusted() {
          away(bytes);
          return false;
        },
      });
    },
  ],
  [
    "updateMany",
    (d, away) => {
      const ids = new Uint32Array(2);
      return d.updateMany(ids, {
        length: 6,
        ...[1, 1, 1, 2, 2],
        get 5() {
          away(ids);
          return 1;
        },
      });
    },
  ],
  [
    "updateMany, xyr",
    (d, away) => {
      const xyr = new Float64Array(6);
      return d.updateMany(
        {
          length: 2,
          get 0() {
            away(xyr);
            return 0;
          },
          1: 1,
        },
        xyr,
      );
    },
  ],
])("detached in the middle: %s", (_, call) => {
  const diagram = built();
  expectRefusal(() => call(diagram, detach), "bad-length", "");
  expect(snapshot(diagram)).toBe(expected);
});

test("what is checked is what is used: getters that say something else the second time", () => {
  const diagram = built();
  const turning = (length, values, others) => {
    const seen = new Set();
    return new Proxy(
      {},
      {
        get: (_, key) =>
          key === "length" ? length : seen.has(key) ? others : seen.add(key) && values[key],
      },
    );
  };
  const bomb = {
    valueOf: () => {
      diagram.dispose();
      return 0;
    },
  };
  expect(diagram.voronoi(turning(4, [0, 0, 10, 10], bomb)).xmin).toBe(0);
  expect(diagram.removeMany(turning(2, [0, 1], 1.5))).toBe(2);
  expect([...diagram.insertMany(turning(3, [1, 2, 3], bomb))]).toEqual([1]);
  expect(diagram.findMany(turning(2, [1, 2], bomb)).length).toBe(1);
  for (const name of ["tolerance", "digits"])
    expect(diagram.render(null, turning(0, { [name]: 1 }, bomb))).toMatch(/^M/);
  expect(validate(diagram)).toBeNull();
});

// --- Callbacks that use the diagram --------------------------------------------------------------

const large = randomCircles(100_000, 73);
/** Actions in the middle of a call: [name, action, whether the diagram can be used afterwards]. */
const deeds = [
  ["inserts", (d) => d.insert(1, 2, 3)],
  ["inserts 100 000", (d) => d.insertMany(large)],
  ["removes", (d) => d.removeMany(d.ids().subarray(0, 20))],
  ["removes all", (d) => d.removeMany(d.ids())],
  ["clears", (d) => d.clear()],
  ["updates", (d) => d.updateMany([0, 1], [9, 9, 1, 8, 8, 1])],
  ["draws", (d) => d.render()],
  ["saves", (d) => d.toBytes()],
  ["lists", (d) => [d.edges(), d.vertices(), d.voronoi().cellAreas()]],
  [
    "is refused",
    (d) => {
      try {
        d.insertMany([1, NaN, 3]);
      } catch {}
    },
  ],
  ["disposes", (d) => d.dispose(), false],
];
/** Calls that run the caller's code in their middle. */
const once = (deed, value) => {
  let isDone = false;
  return () => {
    if (!isDone) {
      isDone = true;
      deed();
    }
    return value;
  };
};
const context = (deed) => {
  const act = once(deed);
  return { moveTo: act, lineTo: act, bezierCurveTo: act, closePath: act };
};
const array = (deed, ...values) =>
  Object.defineProperty(Object.assign({}, values, { length: values.length }), 1, {
    get: once(deed, values[1]),
  });
const option = (deed, name, value) => Object.defineProperty({}, name, { get: once(deed, value) });
const callers = [
  ["insertMany", (d, deed) => d.insertMany(array(deed, 1, 2, 3))],
  ["removeMany", (d, deed) => d.removeMany(array(deed, 0, 1))],
  ["updateMany, ids", (d, deed) => d.updateMany(array(deed, 2, 3), [1, 2, 3, 4, 5, 6])],
  ["updateMany, xyr", (d, deed) => d.updateMany([2], array(deed, 1, 2, 3))],
  ["findMany", (d, deed) => d.findMany(array(deed, 1, 2))],
  [
    "from",
    (_d, deed) =>
      Diagram.from(
        [
          [1, 2, 3],
          [4, 5, 6],
        ],
        once(deed, 1),
      ).dispose(),
  ],
  [
    "from, iterator",
    (_d, deed) =>
      Diagram.from({
        *[Symbol.iterator]() {
          yield [1, 2, 3];
          deed();
          yield [4, 5, 6];
        },
      }).dispose(),
  ],
  ["voronoi, bounds", (d, deed) => d.voronoi(array(deed, 0, 0, 10, 10)).cellAreas()],
  ...["render", "renderSites", "renderHull"].flatMap((name) => [
    [`${name}, context`, (d, deed) => d[name](context(deed))],
    [`${name}, tolerance`, (d, deed) => d[name](null, option(deed, "tolerance", 1))],
    [`${name}, digits`, (d, deed) => d[name](null, option(deed, "digits", 1))],
  ]),
  ["render, bounds", (d, deed) => d.render(null, option(deed, "bounds", [0, 0, 100, 100]))],
  [
    "voronoi().render, context",
    (d, deed) => d.voronoi([-1e3, -1e3, 1e3, 1e3]).render(context(deed)),
  ],
  [
    "voronoi().render, tolerance",
    (d, deed) => d.voronoi().render(null, option(deed, "tolerance", 1)),
  ],
  [
    "renderCell, context",
    (d, deed) => d.voronoi([-1e3, -1e3, 1e3, 1e3]).renderCell(4, context(deed)),
  ],
  [
    "renderCell, tolerance",
    (d, deed) => d.voronoi().renderCell(4, null, option(deed, "tolerance", 1)),
  ],
  ["cellPolygon, tolerance", (d, deed) => d.voronoi().cellPolygon(4, option(deed, "tolerance", 1))],
  ["cellPolygon, flat", (d, deed) => d.voronoi().cellPolygon(4, option(deed, "flat", true))],
  ["toGeoJSON, tolerance", (d, deed) => d.voronoi().toGeoJSON(option(deed, "tolerance", 1))],
  [
    "toGeoJSON, properties",
    (d, deed) =>
      d.voronoi().toGeoJSON({
        properties: (id) => {
          deed();
          return { id };
        },
      }),
  ],
  [
    "cellPolygons, between",
    (d, deed) => {
      for (const _ of d.voronoi([-1e3, -1e3, 1e3, 1e3]).cellPolygons()) deed();
    },
  ],
];

test.each(
  callers.flatMap(([name, call]) =>
    deeds.map(([what, deed, isUsable = true]) => [name, what, call, deed, isUsable]),
  ),
)("%s, while the caller's code %s", (_, what, call, deed, isUsable) => {
  const diagram = built(),
    other = built();
  let count = 0;
  try {
    call(diagram, () => {
      if (count++ === 0) deed(diagram);
    });
  } catch (error) {
    expect(error).toBeInstanceOf(ApolloniusError);
    // of a site, or a diagram, that is gone
    expect(["unknown-site", "disposed"]).toContain(error.code);
  }
  expect(count).toBeGreaterThan(0);
  expect(snapshot(other)).toBe(expected);
  if (!isUsable) expectRefusal(() => diagram.size, "disposed", "");
  else
    expect(what === "inserts 100 000" ? diagram.size >= 100_000 : validate(diagram) === null).toBe(
      true,
    );
  diagram.dispose();
});

test.each(callers)("%s, when the caller's code throws", (_, call) => {
  const diagram = built();
  expect(() => call(diagram, throwOwn)).toThrow(own);
  expect(snapshot(diagram)).toBe(expected);
  expect(validate(diagram)).toBeNull();
});

const ones = new Array(50).fill(1);
test.each(
  [
    ["targets", (fitTo, act) => fitTo(array(act, ...ones))],
    [
      "targets by id",
      (fitTo, act) => fitTo(Object.defineProperty({ ...ones }, 1, { get: once(act, 1) })),
    ],
    [
      "a Map of targets",
      (fitTo, act) =>
        fitTo(
          Object.assign(new Map(), {
            *[Symbol.iterator]() {
              yield* ones.entries();
              act();
            },
          }),
        ),
    ],
    ["start", (fitTo, act) => fitTo(ones, { start: array(act, ...ones) })],
    ["onIteration", (fitTo, act) => fitTo(ones, { onIteration: once(act) })],
  ].flatMap(([name, call]) =>
    deeds.map(([what, deed, isUsable = true]) => [name, what, call, deed, isUsable]),
  ),
)("fitAreas, %s, while the caller's code %s", (_, what, call, deed, isUsable) => {
  const diagram = built();
  const voronoi = diagram.voronoi([-1e3, -1e3, 1e3, 1e3]);
  let count = 0;
  try {
    call(
      (...values) => voronoi.fitAreas(...values),
      () => {
        if (count++ === 0) deed(diagram);
      },
    );
  } catch (error) {
    expect(error).toBeInstanceOf(ApolloniusError);
    const codes = ["unknown-site", "bad-length", "busy", "disposed"];
    expect(codes).toContain(error.code);
  }
  expect(count).toBe(1);
  if (!isUsable) expectRefusal(() => diagram.size, "disposed", "");
  else
    expect(what === "inserts 100 000" ? diagram.size >= 100_000 : validate(diagram) === null).toBe(
      true,
    );
  diagram.dispose();
});

test("a drawing goes on while the memory grows: what was asked for before is drawn", () => {
  const small = built(),
    recorder = new Recorder(),
    plain = new Recorder();
  small.renderSites(plain);
  let isDone = false;
  small.renderSites(
    Object.assign(Object.create(recorder), {
      moveTo(...xy) {
        if (!isDone) small.insertMany(large);
        isDone = true;
        recorder.moveTo(...xy);
      },
    }),
  );
  expect(recorder.calls).toEqual(plain.calls); // all in one portion
});
