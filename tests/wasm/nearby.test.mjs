// kNearest and within, against sorting everything. (The exact comparison with the oracle is
// tests/diagram/queries_test.cpp.)
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator, randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const xyr = randomCircles(1000, 41, 120); // about a third hidden
const diagram = new Diagram(xyr);
const random = generator(42);
const points = Array.from({ length: 40 }, () => [random() * 3000 - 1500, random() * 3000 - 1500]);

function distance(id, x, y) {
  return Math.hypot(xyr[3 * id] - x, xyr[3 * id + 1] - y) - xyr[3 * id + 2];
}

function sorted(x, y) {
  return [...diagram.ids()].sort((a, b) => distance(a, x, y) - distance(b, x, y));
}

test.each(points)("kNearest and within around %f, %f", (x, y) => {
  const expected = sorted(x, y);
  expect(diagram.hiddenSize).toBeGreaterThan(100);
  for (const k of [0, 1, 7, 200, 1000, 5000, Infinity])
    expect([...diagram.kNearest(x, y, k)]).toEqual(expected.slice(0, k));
  expect(diagram.kNearest(x, y, 1)[0]).toBe(diagram.find(x, y));
  for (const limit of [-100, -10, 0, 50, 400, 1e9]) {
    expect([...diagram.within(x, y, limit)]).toEqual(
      expected.filter((id) => distance(id, x, y) <= limit),
    );
  }
});

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

test("after changes", () => {
  const circles = new Diagram(xyr);
  for (let id = 0; id < 1000; id += 3) circles.remove(id);
  const expected = sorted(10, 20).filter((id) => id % 3 !== 0);
  expect([...circles.kNearest(10, 20, 50)]).toEqual(expected.slice(0, 50));
});

test("an empty diagram, and one site", () => {
  const circles = new Diagram();
  expect(circles.kNearest(0, 0, 3)).toEqual(new Uint32Array());
  expect(circles.within(0, 0, 3)).toEqual(new Uint32Array());
  circles.insert(1, 1, 1);
  expect(circles.kNearest(0, 0, 3)).toEqual(new Uint32Array([0]));
  expect(circles.within(9, 9, 3)).toEqual(new Uint32Array());
});

test("the cost is that of the answer, not of the diagram", () => {
  const small = new Diagram(randomCircles(2000, 43, 20));
  const large = new Diagram(randomCircles(200_000, 44, 2));
  const time = (circles) => {
    let best = Infinity;
    for (let run = 0; run < 5; ++run) {
      const start = performance.now();
      for (const [x, y] of points) circles.kNearest(x / 2, y / 2, 10);
      best = Math.min(best, performance.now() - start);
    }
    return best;
  };
  time(small);
  expect(time(large)).toBeLessThan(20 * time(small)); // O(n) would be 100 times
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
  [(d) => d.within(1e-101, 0, 1), "out-of-range", "x is 1e-101"],
  [(d) => d.within(0, 0), "not-finite", "distance is undefined"],
  [(d) => d.within(0, 0, Infinity), "not-finite", "distance is Infinity"],
  [(d) => d.within(0, 0, "1"), "not-finite", 'distance is the string "1"'],
  [(d) => d.within(0, 0, 1e200), "out-of-range", "distance is 1e+200"],
])("%p", (call, code, message) => {
  expectRefusal(() => call(diagram), code, message);
});
