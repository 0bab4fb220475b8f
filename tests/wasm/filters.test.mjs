// Filters of find, nearest, findMany, pick and pickMany, and pickMany without one, against trying
// all sites; and how often a filter is asked.
import { Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator, randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const random = generator(81);
const xyr = randomCircles(1000, 82, 120); // about a third hidden
const diagram = new Diagram(xyr);
const points = Array.from({ length: 150 }, () => [random() * 2600 - 1300, random() * 2600 - 1300]);

/** Returns the calls' answers, by trying all circles of a list of [id, x, y, r]. */
function bruteForce(circles) {
  const away = ([, cx, cy, r], x, y) => Math.hypot(cx - x, cy - y) - r;
  const nearest = (x, y, filter) => {
    let best = null;
    for (const circle of circles) {
      if (!filter(circle[0])) continue;
      const far = away(circle, x, y);
      // ties to the larger r, then x, then y
      const isNearer = (other) => {
        const key = (one, d) => [-d, one[3], one[1], one[2]];
        const [a, b] = [key(circle, far), key(other.circle, other.distance)];
        const k = a.findIndex((value, place) => value !== b[place]);
        return k !== -1 && a[k] > b[k];
      };
      if (best === null || isNearer(best)) best = { circle, distance: far };
    }
    return best && { id: best.circle[0], distance: best.distance };
  };
  const pick = (x, y, farthest, top, filter) => {
    const under = circles.filter((c) => filter(c[0]) && away(c, x, y) <= 0);
    if (under.length > 0 && top === "last") return Math.max(...under.map(([id]) => id));
    const least = Math.min(...under.map((circle) => circle[3]));
    const smallest = new Set(under.filter((circle) => circle[3] === least).map(([id]) => id));
    if (under.length > 0) return nearest(x, y, (id) => smallest.has(id)).id;
    const near = nearest(x, y, filter);
    return near && near.distance <= farthest ? near.id : -1;
  };
  return { nearest, pick };
}

const listOf = (one) => [...one].map(({ id, x, y, r }) => [id, x, y, r]);
const allowed = new Set(Array.from({ length: 30 }, () => Math.floor(random() * 1000)));
const filters = [
  ["all pass", () => true],
  ["none passes", () => false],
  ["every second", (id) => id % 2],
  ["one of ten", (id) => id % 10 === 3],
  ["thirty", (id) => allowed.has(id)],
  ["one", (id) => id === 777],
  ["hidden ones", (id) => diagram.isHidden(id)],
];

test.each(filters)("of 1000 sites, %s: find, nearest and findMany", (_, filter) => {
  const { nearest } = bruteForce(listOf(diagram));
  const { ids, distances } = diagram.nearestMany(points.flat(), { filter });
  expect(ids).toBeInstanceOf(Int32Array);
  expect(diagram.findMany(Float64Array.from(points.flat()), { filter })).toEqual(ids);
  points.forEach(([x, y], k) => {
    const expected = nearest(x, y, filter);
    const found = diagram.nearest(x, y, { filter });
    expect(diagram.find(x, y, { filter })).toBe(expected?.id ?? -1);
    expect(ids[k]).toBe(expected?.id ?? -1);
    if (expected === null) {
      expect(found).toBeNull();
      expect(distances[k]).toBe(Infinity);
    } else {
      expect(found.id).toBe(expected.id);
      expect(found.distance).toBeCloseTo(expected.distance, 9);
      expect(distances[k]).toBe(found.distance);
    }
  });
});

test.each(filters)("of 1000 sites, %s: pick and pickMany", (_, filter) => {
  const { pick } = bruteForce(listOf(diagram));
  for (const top of [undefined, "smallest", "last"]) {
    for (const maxDistance of [undefined, 0, 20, Infinity]) {
      const options = { maxDistance, top, filter };
      const ids = diagram.pickMany(points.flat(), options);
      expect(ids).toBeInstanceOf(Int32Array);
      points.forEach(([x, y], k) => {
        const expected = pick(x, y, maxDistance ?? Infinity, top ?? "smallest", filter);
        expect(diagram.pick(x, y, options)).toBe(expected);
        expect(ids[k]).toBe(expected);
      });
      if (maxDistance === undefined)
        expect(diagram.pickMany(points.flat(), { top, filter })).toEqual(ids);
    }
  }
});

// Small integers: ties, rims, nested and identical circles.
test("on a grid, where all is tied: the circles that brute force finds", () => {
  for (let round = 0; round < 60; ++round) {
    const count = Math.floor(random() * 40);
    const whole = (size) => Math.floor(random() * size);
    const circles = Array.from({ length: count }, () => [whole(7), whole(7), whole(4)]);
    const one = new Diagram(circles.flat());
    const { nearest, pick } = bruteForce(listOf(one));
    const share = random();
    const passing = new Set([...circles.keys()].filter(() => random() < share));
    const options = { filter: (id) => passing.has(id) };
    const xy = Array.from({ length: 50 }, () => [whole(9) - 1, whole(9) - 1]);
    const found = one.findMany(xy.flat(), options);
    const picked = ["smallest", "last"].map((top) =>
      one.pickMany(xy.flat(), { ...options, maxDistance: 2, top }),
    );
    xy.forEach(([x, y], k) => {
      const first = nearest(x, y, options.filter)?.id ?? -1;
      expect([found[k], one.find(x, y, options)]).toEqual([first, first]);
      ["smallest", "last"].forEach((top, t) => {
        const expected = pick(x, y, 2, top, options.filter);
        const ids = [picked[t][k], one.pick(x, y, { ...options, maxDistance: 2, top })];
        expect(ids).toEqual([expected, expected]);
      });
    });
    one.dispose();
  }
});

test("pickMany is pick, at every limit, rims and empty diagrams included", () => {
  for (const maxDistance of [undefined, 0, 1e-100, 35, Infinity])
    for (const top of [undefined, "last"]) {
      const expected = points.map(([x, y]) => diagram.pick(x, y, { maxDistance, top }));
      expect([...diagram.pickMany(points.flat(), { maxDistance, top })]).toEqual(expected);
    }
  const circles = new Diagram([0, 0, 5, 3, 0, 1, 20, 0, 5, 3, 0, 2]);
  const xy = [3, 0, 0, 4, 11, 0, 5, 0, 25, 0, 26, 0];
  expect([...circles.pickMany(xy)]).toEqual([1, 0, 2, 3, 2, 2]);
  expect([...circles.pickMany(xy, { maxDistance: 4 })]).toEqual([1, 0, 2, 3, 2, 2]);
  expect([...circles.pickMany(xy, { maxDistance: 3.9 })]).toEqual([1, 0, -1, 3, 2, 2]);
  // at that very distance
  expect([...circles.pickMany(xy, { maxDistance: 1 })]).toEqual([1, 0, -1, 3, 2, 2]);
  expect([...circles.pickMany(xy, { maxDistance: 0 })]).toEqual([1, 0, -1, 3, 2, -1]);
  expect([...circles.pickMany([])]).toEqual([]);
  expect([...new Diagram().pickMany([0, 0, 1, 1])]).toEqual([-1, -1]);
  expect([...new Diagram().pickMany([0, 0], { filter: () => true })]).toEqual([-1]);
  // next to a limit that doubles do not tell from the distance
  const [x, far] = [3e15, 5e15 - 1];
  const remote = new Diagram([x, 4e15, 1]);
  for (const maxDistance of [far - 1, far, far + 1]) {
    const id = remote.pick(0, 0, { maxDistance });
    expect(remote.pickMany([0, 0], { maxDistance })[0]).toBe(id);
    expect(remote.find(0, 0, { maxDistance })).toBe(id);
  }
});

test("identical and nested circles: the first that passes, hidden or not", () => {
  const nested = new Diagram([0, 0, 9, 0, 0, 5, 0, 0, 5, 1, 0, 2, 50, 0, 1]);
  const among = (...ids) => ({ filter: (id) => ids.includes(id) });
  expect(nested.find(1, 0, among(1, 3, 4))).toBe(1);
  expect(nested.nearest(1, 0, among(3, 4))).toEqual({ id: 3, distance: -2 });
  expect(nested.pick(1, 0, among(0, 1, 2))).toBe(1); // the first of identical ones
  expect(nested.pick(1, 0, among(0, 2))).toBe(2);
  expect(nested.pick(1, 0, among(0, 1))).toBe(1);
  expect(nested.pick(1, 0, { ...among(0, 3), top: "last" })).toBe(3);
  expect(nested.pick(1, 0, { ...among(4), maxDistance: 10 })).toBe(-1);
  expect(nested.pick(1, 0, { ...among(4), maxDistance: 48 })).toBe(4);
  expect([...nested.findMany([1, 0, 60, 0], among(3))]).toEqual([3, 3]);
});

test("after changes, with gaps between ids", () => {
  const changed = new Diagram(xyr);
  for (let id = 0; id < 1000; id += 3) changed.remove(id);
  changed.update(1, 0, 0, 500);
  const { nearest, pick } = bruteForce(listOf(changed));
  const filter = (id) => id % 50 === 1 || id > 990;
  const found = changed.findMany(points.flat(), { filter });
  const picked = changed.pickMany(points.flat(), { filter });
  points.forEach(([x, y], k) => {
    expect(found[k]).toBe(nearest(x, y, filter).id);
    expect(picked[k]).toBe(pick(x, y, Infinity, "smallest", filter));
  });
});

// --- Work ----------------------------------------------------------------------------------------

/** A filter, and the ids about which it has been asked, repeats included. */
function counting(filter) {
  const asked = [];
  const counted = (id) => {
    asked.push(id);
    return filter(id);
  };
  return { filter: counted, asked };
}

test("one of ten passes: find and pick ask about ten sites or so, of 100 000", () => {
  const large = new Diagram(randomCircles(100_000, 83, 2));
  const calls = [
    (x, y, options) => large.find(x, y, options),
    (x, y, options) => large.nearest(x, y, options),
    (x, y, options) => large.pick(x, y, options),
  ];
  for (const call of calls) {
    let sum = 0;
    for (const [x, y] of points) {
      const { filter, asked } = counting((id) => id % 10 === 0);
      call(x / 1.4, y / 1.4, { filter });
      expect(new Set(asked).size).toBe(asked.length);
      sum += asked.length;
    }
    expect(sum / points.length).toBeGreaterThan(5);
    expect(sum / points.length).toBeLessThan(20);
  }
  const { filter, asked } = counting(() => true);
  large.find(0, 0, { filter });
  expect(asked).toEqual([large.find(0, 0)]);
  // of many points, too: about the sites around them
  for (const many of ["findMany", "pickMany"]) {
    const { filter, asked } = counting((id) => id % 10 === 0);
    const some = points.slice(0, 20).flatMap(([x, y]) => [x / 1.4, y / 1.4]);
    large[many](some, { filter });
    expect(new Set(asked).size).toBe(asked.length);
    expect(asked.length).toBeLessThan(20 * 20);
  }
  large.dispose();
});

test("few or none pass: many points ask about each site once", () => {
  const large = new Diagram(randomCircles(20_000, 84, 5));
  const xy = Float64Array.from({ length: 40_000 }, () => random() * 2000 - 1000);
  for (const few of [() => false, (id) => id === 19_999, (id) => id % 5000 === 7]) {
    for (const many of ["findMany", "pickMany"]) {
      const { filter, asked } = counting(few);
      large[many](xy, { filter });
      expect(new Set(asked).size).toBe(asked.length);
      expect(asked.length).toBe(20_000);
    }
  }
  const few = (id) => id % 5000 === 7;
  const found = large.findMany(xy, { filter: few });
  const { nearest } = bruteForce(
    [7, 5007, 10007, 15007].map((id) => [id, ...Object.values(large.site(id))]),
  );
  for (let k = 0; k < 20_000; k += 500)
    expect(found[k]).toBe(nearest(xy[2 * k], xy[2 * k + 1], few).id);
  large.dispose();
});

// --- Filters that misbehave ----------------------------------------------------------------------

const uses = [
  ["find", (d, options) => d.find(0, 0, options)],
  ["nearest", (d, options) => d.nearest(0, 0, options)],
  ["findMany", (d, options) => d.findMany([0, 0, 100, 100], options)],
  ["pick", (d, options) => d.pick(0, 0, options)],
  ["find, maxDistance", (d, options) => d.find(0, 0, options && { ...options, maxDistance: 5000 })],
  ["nearestMany", (d, options) => d.nearestMany([0, 0, 100, 100], options)],
  ["farthest", (d, options) => d.farthest(0, 0, options)],
  ["search", (d, options) => d.search(-Infinity, -Infinity, Infinity, Infinity, options)],
  ["pickMany", (d, options) => d.pickMany([0, 0, 100, 100], options)],
];

test.each(uses)("%s: a filter may throw, and may not change the diagram", (_, use) => {
  const circles = new Diagram(xyr);
  const before = circles.toBytes();
  const error = new Error("own");
  const failing = (after) => () => {
    if (--after < 0) throw error;
    return false;
  };
  for (const after of [0, 1, 3, 500, 999])
    expect(() => use(circles, { filter: failing(after) })).toThrow(error);
  const changes = [
    (id) => circles.remove(id),
    () => circles.insert(0, 0, 1),
    (id) => circles.update(id, 0, 0, 1),
    () => circles.clear(),
    () => circles.dispose(),
  ];
  for (const change of changes)
    expectRefusal(() => use(circles, { filter: change }), "busy", "a filter may not change");
  // it may ask the diagram, with filters as well
  const inner = { filter: (id) => id % 2 === 0 };
  const asking = (id) => use(circles, inner) !== -2 && id % 3 === 0;
  expect(use(circles, { filter: asking })).toEqual(use(circles, { filter: (id) => id % 3 === 0 }));
  expect(circles.toBytes()).toEqual(before);
  circles.remove(0); // not busy any more
  expectRefusal(() => use(circles, { filter: 7 }), "bad-option", "options.filter is 7");
  expectRefusal(
    () => use(circles, { fitler: inner.filter }),
    "bad-option",
    "options.fitler is unk",
  );
  const free = use(circles, undefined);
  expect(use(circles, {})).toEqual(free);
  expect(use(circles, { filter: undefined })).toEqual(free);
  circles.dispose();
  expectRefusal(() => use(circles, inner), "disposed", "the diagram");
});

test("a filter may change the array of the call", () => {
  const xy = Float64Array.of(0, 0, 500, 500);
  const spoiling = () => xy.fill(NaN) && true;
  expect(diagram.findMany(xy, { filter: spoiling })).toEqual(diagram.findMany([0, 0, 500, 500]));
});

test.each([
  [(d) => d.findMany([0, 0], new Uint8Array(8)), "bad-option", "options is Uint8Array(8)"],
  [(d) => d.findMany([0, 0], "1"), "bad-option", 'options is the string "1"'],
  [(d) => d.nearestMany([0, 0], { distances: true }), "bad-option", "options.distances is unknown"],
  [(d) => d.findMany([0, NaN], { filter: () => true }), "not-finite", "xy[1] is NaN"],
  [
    (d) => d.find(0, 0, 7),
    "bad-option",
    "options is 7, expected { maxDistance, filter }: { maxDistance: 20 } is a limit",
  ],
  [(d) => d.find(NaN, 0, { filter: () => true }), "not-finite", "x is NaN"],
  [(d) => d.nearest(0, 1e101, { filter: () => true }), "out-of-range", "y is 1e+101"],
  [(d) => d.pick(0, "1", { filter: () => true }), "not-finite", 'y is the string "1"'],
  [(d) => d.pick(1e101, 0, { filter: () => true }), "out-of-range", "x is 1e+101"],
  [(d) => d.pick(0, 0, { maxDistance: -1 }), "out-of-range", "maxDistance is -1"],
  [(d) => d.pick(0, 0, { maxDistance: null }), "not-finite", "maxDistance is null"],
  [(d) => d.pickMany([0, 0, 1]), "bad-length", "a multiple of 2 values in xy, got 3"],
  [(d) => d.pickMany([0, 0], { maxDistance: -1 }), "out-of-range", "maxDistance is -1"],
  [(d) => d.pickMany([0, 0], { top: "first" }), "bad-option", 'options.top is the string "first"'],
])("%p", (call, code, message) => {
  expectRefusal(() => call(diagram), code, message);
});

// --- The sphere ----------------------------------------------------------------------------------

test("SphericalDiagram: find, nearest and findMany", () => {
  const sites = Array.from({ length: 400 }, () => [
    360 * random() - 180,
    (Math.asin(2 * random() - 1) * 180) / Math.PI,
    random() * 0.05,
  ]);
  const globe = new SphericalDiagram(sites.flat());
  const places = sites.map(([lon, lat]) => [lon + 1, lat * 0.9]);
  for (const filter of [() => true, () => false, (id) => id % 7 === 0, (id) => id === 99]) {
    const { ids, distances } = globe.nearestMany(places.flat(), { filter });
    expect(globe.findMany(places.flat(), { filter })).toEqual(ids);
    places.forEach(([lon, lat], k) => {
      const [first = -1] = globe.kNearest(lon, lat, 1, { filter });
      expect(globe.find(lon, lat, { filter })).toBe(first);
      expect(ids[k]).toBe(first);
      const found = globe.nearest(lon, lat, { filter });
      expect(found?.id ?? -1).toBe(first);
      expect(distances[k]).toBeCloseTo(found?.distance ?? Infinity, 14);
      if (first === globe.find(lon, lat)) expect(found).toEqual(globe.nearest(lon, lat));
    });
  }
  const change = { filter: () => globe.clear() };
  for (const use of [() => globe.find(0, 0, change), () => globe.findMany([0, 0], change)])
    expectRefusal(use, "busy", "a filter may not change");
  expectRefusal(() => globe.nearest(0, 0, { filter: 1 }), "bad-option", "options.filter is 1");
  globe.dispose();
});
