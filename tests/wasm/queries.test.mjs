// Queries by example. (Against brute force: every_call.test.mjs.)
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator, randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const count = 400;
const xyr = randomCircles(count, 11);
const diagram = new Diagram(xyr);

test("findMany of few points, which are asked one by one, and of more: the answers of find", () => {
  const random = generator(13);
  for (const points of [0, 1, 2, 15, 16, 17, 40]) {
    const xy = Float64Array.from({ length: 2 * points }, () => random() * 3000 - 1500);
    const expected = Int32Array.from({ length: points }, (_, k) =>
      diagram.find(xy[2 * k], xy[2 * k + 1]),
    );
    const floats = Float32Array.from(xy);
    expect(diagram.findMany(xy)).toEqual(expected);
    expect(diagram.findMany([...xy])).toEqual(expected);
    expect(diagram.nearestMany(xy).ids).toEqual(expected);
    expect(diagram.findMany(xy, { maxDistance: 1e9 })).toEqual(expected);
    expect(diagram.findMany(floats)).toEqual(diagram.findMany([...floats]));
    expect(new Diagram().findMany(xy)).toEqual(new Int32Array(points).fill(-1));
    if (points === 0) continue;
    for (const [value, code, said] of [
      [NaN, "not-finite", "NaN"],
      [1e200, "out-of-range", "1e+200"],
    ]) {
      const bad = xy.with(2 * points - 1, value); // the last one
      const message = `xy[${2 * points - 1}] is ${said}`;
      expectRefusal(() => diagram.findMany(bad), code, message);
      expectRefusal(() => diagram.findMany([...bad]), code, message);
    }
  }
});

/** A double times 2^200, and its last place times that; it must be a multiple of 2^-200. */
function scaled(value) {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, Math.abs(value));
  const exponent = bits.getBigUint64(0) >> 52n;
  const mantissa = 2n ** 52n + (bits.getBigUint64(0) & (2n ** 52n - 1n));
  const lastPlace = 1n << (exponent - 1075n + 200n); // throws if it is smaller
  return { whole: (value < 0 ? -1n : 1n) * mantissa * lastPlace, lastPlace };
}

/** The largest whole number whose square is not larger. */
function squareRoot(square) {
  if (square < 2n) return square;
  let root = 1n << BigInt((square.toString(2).length + 1) >> 1);
  for (;;) {
    const next = (root + square / root) >> 1n;
    if (next >= root) return root;
    root = next;
  }
}

/** Is this |p - c| - r of whole numbers, within one unit in the last place? By whole numbers. */
function expectExact(distance, [x, y, r], px, py) {
  const [dx, dy] = [BigInt(px) - BigInt(x), BigInt(py) - BigInt(y)];
  const square = dx * dx + dy * dy;
  const exact = squareRoot(square << 400n) - (BigInt(r) << 200n); // times 2^200, rounded down
  const [sign, expected] = [Math.sign(distance), r < 0 ? 1n : square - BigInt(r) ** 2n];
  expect(sign).toBe(expected > 0n ? 1 : expected < 0n ? -1 : 0);
  if (distance === 0) return;
  const { whole, lastPlace } = scaled(distance);
  const off = whole - exact;
  expect(off <= lastPlace && off >= -lastPlace).toBe(true);
}

test("distances are right to the last place, and of the right sign, where digits cancel", () => {
  const random = generator(14);
  const whole = (size) =>
    Math.floor(random() * 2 ** 21) * 2 ** (size - 21) + Math.floor(random() * 2 ** (size - 21));
  const cases = [
    [[3e15, 4e15 + 1, 5e15], 0, 0],
    [[3e15, 4e15 - 1, 5e15], 0, 0],
    [[3e15, 4e15, 5e15], 0, 0],
    [[3, 4, -5], 0, 0],
    [[2 ** 52, 1, 2 ** 52], 0, 0],
    [[0, 0, 0], 0, 0],
  ];
  for (let k = 0; k < 1000; ++k) {
    const size = 22 + (k % 31);
    const [x, y, px, py] = Array.from({ length: 4 }, () => whole(size));
    const far = Math.hypot(px - x, py - y);
    for (const r of [Math.round(far), Math.floor(far) - 1, whole(size), -whole(size)])
      if (Number.isSafeInteger(r)) cases.push([[x, y, r], px, py]);
  }
  expect(cases.length).toBeGreaterThan(3000);
  for (const [circle, px, py] of cases) {
    const one = new Diagram(circle);
    const { distance } = one.nearest(px, py);
    expectExact(distance, circle, px, py);
    const { distances } = one.nearestMany(new Array(20).fill([px, py]).flat());
    expect(distances).toEqual(new Float64Array(20).fill(distance));
    one.dispose();
  }
});

test("distances that hypot cannot give", () => {
  const distanceTo = (circle, x, y) => new Diagram(circle).nearest(x, y).distance;
  expect(distanceTo([3e15, 4e15 + 1, 5e15], 0, 0)).toBe(0.8);
  expect(distanceTo([3e15, 4e15, 5e15], 0, 0)).toBe(0);
  expect(distanceTo([1e100, 0, 1e100], 1e-100, 0)).toBe(-1e-100);
  expect(distanceTo([1e100, 0, 1e100], -1e-100, 0)).toBe(1e-100);
  expect(distanceTo([1e100, 1e100, 0], 0, 0) / 1e100).toBeCloseTo(Math.SQRT2, 15);
  expect(distanceTo([1e-100, 1e-100, 0], 0, 0) / 1e-100).toBeCloseTo(Math.SQRT2, 15);
});

test("distance is negative inside a circle", () => {
  expect(new Diagram([0, 0, 5]).nearest(1, 0)).toEqual({ id: 0, distance: -4 });
});

test("ties go to the larger r, then x, then y", () => {
  const find = (triples, x, y) => {
    const built = new Diagram(triples);
    return built.site(built.find(x, y));
  };
  expect(find([-2, 0, 0, 3, 0, 1], 0, 0)).toEqual({ x: 3, y: 0, r: 1 });
  expect(find([-2, 0, 0, 2, 0, 0], 0, 0)).toEqual({ x: 2, y: 0, r: 0 });
  expect(find([0, -2, 0, 0, 2, 0], 0, 0)).toEqual({ x: 0, y: 2, r: 0 });
});

test("neighbors in line are the ones beside", () => {
  const line = new Diagram([0, 0, 0, 1, 0, 0, 2, 0, 0]);
  expect([0, 1, 2].map((id) => [...line.neighbors(id)].sort())).toEqual([[1], [0, 2], [1]]);
});

test("neighbors are counter-clockwise", () => {
  const star = new Diagram([0, 0, 0, 10, 0, 0, 0, 10, 0, -10, 0, 0, 0, -10, 0]);
  const around = [...star.neighbors(0)];
  const start = around.indexOf(1);
  expect([...around.slice(start), ...around.slice(0, start)]).toEqual([1, 2, 3, 4]);
});

test("vertices of integer circles are integers where they can be", () => {
  const d = new Diagram([154, 103, 2, 147, 96, 2, 138, 105, 10]); // 3 from (150, 100)
  const { xy, clearance } = d.vertices();
  expect([...xy]).toEqual([150, 100]);
  expect([...clearance]).toEqual([3]);
});

test("an edge's ends are vertices of both of its sites, and Euler's formula holds", () => {
  const { sites, vertices } = diagram.edges();
  const corners = diagram.vertices().sites;
  let unbounded = 0;
  for (let edge = 0; edge < sites.length / 2; ++edge) {
    for (const row of vertices.subarray(2 * edge, 2 * edge + 2)) {
      if (row === -1) ++unbounded;
      else
        expect([...corners.subarray(3 * row, 3 * row + 3)]).toEqual(
          expect.arrayContaining([...sites.subarray(2 * edge, 2 * edge + 2)]),
        );
    }
  }
  // Cells - edges + vertices, with infinity for one more vertex.
  expect(diagram.visibleSize - sites.length / 2 + corners.length / 3 + 1).toBe(2);
  expect(unbounded).toBeGreaterThan(0);
});

test("an edge walked from its first to its second vertex has its first site on the left", () => {
  const { sites, vertices } = diagram.edges();
  const { xy } = diagram.vertices();
  for (let edge = 0; edge < sites.length / 2; ++edge) {
    const [from, to] = vertices.subarray(2 * edge, 2 * edge + 2);
    if (from === -1 || to === -1) continue;
    const a = diagram.site(sites[2 * edge]);
    const b = diagram.site(sites[2 * edge + 1]);
    // From the left site to the right one it is a right turn off the way: way x (b - a) is
    // negative.
    const wayX = xy[2 * to] - xy[2 * from];
    const wayY = xy[2 * to + 1] - xy[2 * from + 1];
    if (Math.hypot(wayX, wayY) < 1e-6) continue;
    expect(wayX * (b.y - a.y) - wayY * (b.x - a.x)).toBeLessThan(0);
  }
});

test("arrays that were handed out stay as they are", () => {
  const built = new Diagram(randomCircles(50, 13));
  const [ids, edges, vertices] = [built.ids(), built.edges(), built.vertices()];
  const before = JSON.stringify([ids, edges, vertices]);
  built.insertMany(randomCircles(100_000, 14)); // makes the memory grow
  expect(JSON.stringify([ids, edges, vertices])).toBe(before);
});
