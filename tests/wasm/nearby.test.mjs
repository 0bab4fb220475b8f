// kNearest, within, pick and search by example, and with filters. (Against brute force:
// every_call.test.mjs; against the oracle: tests/diagram/queries_test.cpp.)
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { calls } from "./support/calls.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal, expectRejection } from "./support/refusal.mjs";

const xyr = randomCircles(1000, 41, 120); // about a third hidden
const diagram = new Diagram(xyr);

function distance(id, x, y) {
  return Math.hypot(xyr[3 * id] - x, xyr[3 * id + 1] - y) - xyr[3 * id + 2];
}

function sorted(x, y) {
  return [...diagram.ids()].sort((a, b) => distance(a, x, y) - distance(b, x, y));
}

test("within 0 is every circle under the pointer, with the rim", () => {
  const circles = new Diagram([0, 0, 5, 3, 0, 1, 10, 0, 5, 10, 0, 2]);
  // 2 inside the first, 1 inside the second: the deeper one first
  expect([...circles.within(3, 0, 0)]).toEqual([0, 1]);
  // on two rims: ties go to the larger r, then x
  expect([...circles.within(5, 0, 0)]).toEqual([2, 0]);
  expect([...circles.within(10, 0, 0)]).toEqual([2, 3]); // hidden, but under the pointer
  expect([...circles.within(100, 0, 0)]).toEqual([]);
});

test("ties go to the larger r, then x, then y", () => {
  const circles = new Diagram([-2, 0, 0, 0, -2, 0, 0, 2, 0, 2, 0, 0, 3, 0, 1]);
  expect([...circles.kNearest(0, 0, 5)]).toEqual([4, 3, 2, 1, 0]);
});

test("kNearest and within with a filter, which is asked no more than needed", () => {
  const [x, y] = [-120, 80];
  const expected = sorted(x, y);
  const asked = [];
  const odd = (id) => {
    asked.push(id);
    return id % 2;
  };
  const found = diagram.kNearest(x, y, 5, { filter: odd });
  expect(found).toBeInstanceOf(Uint32Array);
  expect([...found]).toEqual(expected.filter((id) => id % 2).slice(0, 5));
  expect(asked).toEqual(expected.slice(0, asked.length));
  expect(asked.at(-1)).toBe(found.at(-1));
  const near = expected.filter((id) => distance(id, x, y) <= 200);
  expect([...diagram.kNearest(x, y, Infinity, { maxDistance: 200 })]).toEqual(near);
  expect([...diagram.kNearest(x, y, 3, { maxDistance: 200 })]).toEqual(near.slice(0, 3));
  expect([...diagram.within(x, y, 200, { filter: odd })]).toEqual(near.filter((id) => id % 2));
  expect([...diagram.kNearest(x, y, 3, { filter: () => false })]).toEqual([]);
  expect([...diagram.kNearest(x, y, 3, { filter: undefined, maxDistance: undefined })]).toEqual(
    expected.slice(0, 3),
  );
});

test("a filter may throw, ask the diagram, and make others, but not change this one", () => {
  const circles = new Diagram(xyr);
  const error = new Error("own");
  const failing = () => {
    throw error;
  };
  expect(() => circles.kNearest(0, 0, 3, { filter: failing })).toThrow(error);
  expect(() => circles.within(0, 0, 300, { filter: failing })).toThrow(error);
  const inner = (id) =>
    circles.kNearest(xyr[3 * id], xyr[3 * id + 1], 1, { filter: () => true })[0];
  expect([...circles.kNearest(0, 0, 9, { filter: (id) => inner(id) === id })]).toEqual(
    sorted(0, 0)
      .filter((id) => inner(id) === id)
      .slice(0, 9),
  );
  const changes = [
    (id) => circles.remove(id),
    (id) => circles.removeMany([id]),
    () => circles.insert(0, 0, 1),
    () => circles.insertMany([0, 0, 1]),
    (id) => circles.update(id, 0, 0, 1),
    (id) => circles.updateMany([id], [0, 0, 1]),
    () => circles.clear(),
    () => circles.dispose(),
    () => circles[Symbol.dispose](),
    () => circles.voronoi([-1e4, -1e4, 1e4, 1e4]).fitAreas(new Array(1000).fill(1)),
  ];
  for (const change of changes)
    expectRefusal(() => circles.within(0, 0, 300, { filter: change }), "busy", "a filter may not");
  for (const change of changes)
    expectRefusal(() => circles.kNearest(0, 0, 3, { filter: change }), "busy", "a filter may not");
  circles.within(0, 0, 300, { filter: () => new Diagram(xyr).clear().dispose() });
  expect(validate(circles)).toBeNull();
  expect(circles.size).toBe(1000);
  circles.remove(0); // not busy any more
  circles.dispose();
});

// There is no list of the calls that change a diagram: the test finds them by their effect.
test.each(calls)("in a filter, %s is busy if it would change the diagram", async (_, call) => {
  const make = () => new Diagram([0, 0, 5, 3, 0, 1, 20, 0, 5, 40, 9, 2]);
  const stateOf = (one) => {
    try {
      return one.toBytes();
    } catch (error) {
      return error.code;
    }
  };
  const attempt = (one) => {
    try {
      return call.use(one);
    } catch (error) {
      return Promise.reject(error);
    }
  };
  const free = make();
  await Promise.allSettled([attempt(free)]);
  const changes = String(stateOf(free)) !== String(stateOf(make()));

  const asking = make();
  const results = [];
  asking.within(0, 0, 1, { filter: () => results.push(attempt(asking)) });
  const [outcome] = await Promise.allSettled(results);
  expect(String(stateOf(asking))).toBe(String(stateOf(make())));
  expect(outcome.reason?.code === "busy").toBe(changes);
});

test("pick: the smallest under the pointer, else the nearest", () => {
  const circles = new Diagram([0, 0, 5, 3, 0, 1, 20, 0, 5, 3, 0, 2]);
  expect(circles.pick(3, 0)).toBe(1);
  expect(circles.pick(3, 0, { maxDistance: 0, top: "last" })).toBe(3);
  expect(circles.pick(0, 4)).toBe(0);
  expect(circles.pick(11, 0)).toBe(2); // 4 away, the other one 6
  expect(circles.pick(11, 0, { maxDistance: 4 })).toBe(2);
  expect(circles.pick(11, 0, { maxDistance: 3.9 })).toBe(-1);
  expect(circles.pick(11, 0, { maxDistance: 0 })).toBe(-1);
  expect(new Diagram().pick(0, 0)).toBe(-1);
});

test("fitAreasAsync in a filter is busy, too, and after it all goes on", async () => {
  const pair = new Diagram([0, 0, 1, 10, 0, 2]);
  const voronoi = pair.voronoi([-20, -20, 20, 20]);
  const started = [];
  const filter = () => started.push(voronoi.fitAreasAsync([1, 1])) > 0;
  expect([...pair.kNearest(0, 0, 1, { filter })]).toEqual([0]);
  await expectRejection(() => started[0], "busy", "a filter may not change the diagram");
  expect(pair.sites().xyr).toEqual(Float64Array.of(0, 0, 1, 10, 0, 2));
  expect((await voronoi.fitAreasAsync([1, 1])).converged).toBe(true);
});

test("without a limit the farthest are found, too; circles of negative r meet nothing", () => {
  const far = new Diagram([1e100, -1e100, 1, -1e100, 0, 1e100, 0, 0, -1, 3, 4, 0]);
  expect([...far.search(-Infinity, -Infinity, Infinity, Infinity)]).toEqual([0, 1, 3]);
  expect([...far.search(1e100, -Infinity, Infinity, Infinity)]).toEqual([0]);
  expect([...far.search(-Infinity, -Infinity, -1e100, Infinity)]).toEqual([1]);
  expect([...far.search(0, 0, 3, Infinity)]).toEqual([1, 3]); // the large one by its rim
  expect([...far.search(0, 1, 3, Infinity)]).toEqual([3]);
  expect([...far.within(3, 4, Infinity)]).toEqual([...far.kNearest(3, 4, Infinity)]);
  expect(far.within(3, 4, Infinity).length).toBe(4);
});

test.each([
  [(d) => d.kNearest(NaN, 0, 1), "not-finite", "x is NaN"],
  [(d) => d.kNearest(0, 1e101, 1), "out-of-range", "y is 1e+101"],
  [(d) => d.kNearest("1", 0, 1), "not-finite", 'x is the string "1"'],
  [(d) => d.kNearest(0, 0), "not-finite", "k is undefined"],
  [(d) => d.kNearest(0, 0, NaN), "not-finite", "k is NaN"],
  [(d) => d.kNearest(0, 0, "3"), "not-finite", 'k is the string "3"'],
  [(d) => d.kNearest(0, 0, 3n), "not-finite", "k is the bigint 3n"],
  [(d) => d.kNearest(0, 0, -1), "out-of-range", "k is -1"],
  [(d) => d.kNearest(0, 0, 1.5), "out-of-range", "k is 1.5"],
  [(d) => d.within(Infinity, 0, 1), "not-finite", "x is Infinity"],
  [(d) => d.within(0, null, 1), "not-finite", "y is null"],
  [(d) => d.within(1e101, 0, 1), "out-of-range", "x is 1e+101"],
  [(d) => d.within(0, 0), "not-finite", "maxDistance is undefined"],
  [(d) => d.within(0, 0, -Infinity), "not-finite", "maxDistance is -Infinity"],
  [(d) => d.within(0, 0, NaN), "not-finite", "maxDistance is NaN"],
  [(d) => d.within(0, 0, null), "not-finite", "maxDistance is null"],
  [
    (d) => d.within(0, 0, undefined, { filter: () => true }),
    "not-finite",
    "maxDistance is undefined",
  ],
  [(d) => d.within(0, 0, "Infinity"), "not-finite", 'maxDistance is the string "Infinity"'],
  [(d) => d.within(Infinity, 0, Infinity), "not-finite", "x is Infinity"],
  [(d) => d.within(0, 1e101, Infinity), "out-of-range", "y is 1e+101"],
  [(d) => d.search(Infinity, 0, Infinity, 1), "bad-bounds", "xmin of bounds is Infinity"],
  [(d) => d.search(0, 0, 1, -Infinity), "bad-bounds", "ymax of bounds is -Infinity"],
  [(d) => d.search(-Infinity, NaN, Infinity, 1), "bad-bounds", "ymin of bounds is NaN"],
  [(d) => d.search(-Infinity, 2, Infinity, 1), "bad-bounds", "expected xmin <= xmax and ymin"],
  [(d) => d.within(0, 0, "1"), "not-finite", 'maxDistance is the string "1"'],
  [(d) => d.within(0, 0, 1e200), "out-of-range", "maxDistance is 1e+200"],
])("%p", (call, code, message) => {
  expectRefusal(() => call(diagram), code, message);
});
