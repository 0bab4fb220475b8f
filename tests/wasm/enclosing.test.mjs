// The smallest circle around circles, and the farthest circle of a point: against brute force, and
// d3-hierarchy's packEnclose where that has an answer.
import { packEnclose, packSiblings } from "d3-hierarchy";
import { Diagram, enclose } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator, randomCircles } from "./support/random.mjs";

const reach = ({ x, y, r }, px, py) => Math.hypot(px - x, py - y) + r;

function expectAround(circles, found) {
  const size = Math.max(...circles.flatMap(({ x, y, r }) => [x, y, r].map(Math.abs)), found.r);
  const most = Math.max(...circles.map((circle) => reach(circle, found.x, found.y)));
  expect(Math.abs(most - found.r)).toBeLessThanOrEqual(1e-14 * size);
  for (const k of found.sites)
    expect(Math.abs(reach(circles[k], found.x, found.y) - found.r)).toBeLessThanOrEqual(
      1e-14 * size,
    );
}

const objects = (xyr) =>
  Array.from({ length: xyr.length / 3 }, (_, k) => ({
    x: xyr[3 * k],
    y: xyr[3 * k + 1],
    r: xyr[3 * k + 2],
  }));

test("none, one, two, one within another, three around a fourth", () => {
  expect(enclose([])).toBeUndefined();
  expect(new Diagram().smallestEnclosingCircle()).toBeNull();
  expect(enclose([{ x: 3, y: 4, r: 5 }])).toEqual({ x: 3, y: 4, r: 5, sites: Uint32Array.of(0) });
  const pair = [0, 0, 1, 10, 0, 3];
  expect(new Diagram(pair).smallestEnclosingCircle()).toEqual({
    x: 6,
    y: 0,
    r: 7,
    sites: Uint32Array.of(0, 1),
  });
  const within = new Diagram([0, 0, 9, 1, 1, 2]).smallestEnclosingCircle();
  expect(within).toEqual({ x: 0, y: 0, r: 9, sites: Uint32Array.of(0) });
  const four = [3, 4, 5, -6, 8, 0, 0, -7, 3, 1, 1, 1];
  expect(new Diagram(four).smallestEnclosingCircle()).toEqual({
    x: 0,
    y: 0,
    r: 10,
    sites: Uint32Array.of(0, 1, 2),
  });
});

test("the same circle as d3's packEnclose, of packs, tangent, nested and equal circles", () => {
  const random = generator(551);
  for (let run = 0; run < 300; ++run) {
    const n = 1 + Math.floor(30 * random());
    const size = [1e-7, 1, 1e3, 1e22][run % 4];
    const circles = Array.from({ length: n }, () => ({
      x: size * (random() - 0.5),
      y: size * (random() - 0.5),
      r: size * (run % 3 === 0 ? 0.1 : 0.3 * random() ** 3),
    }));
    const found = enclose(circles);
    expectAround(circles, found);
    const theirs = packEnclose(circles.map((circle) => ({ ...circle })));
    // which takes 1e-9 for nothing, whatever the size
    for (const key of ["x", "y", "r"])
      expect(Math.abs(found[key] - theirs[key])).toBeLessThanOrEqual(1e-8 * Math.max(size, 1));
  }
});

test("the same circle as d3's of a thousand packs of its own", () => {
  const random = generator(557);
  for (let run = 0; run < 1000; ++run) {
    const radii = Array.from({ length: 2 + Math.floor(20 * random()) }, () => random() ** 2 + 0.01);
    const circles = packSiblings(radii.map((r) => ({ r })));
    const found = enclose(circles);
    expectAround(circles, found);
    const theirs = packEnclose(circles.map((circle) => ({ ...circle })));
    for (const key of ["x", "y", "r"])
      expect(Math.abs(found[key] - theirs[key])).toBeLessThan(1e-7);
  }
});

/** Circles of these radii, each of which touches the first one and the one before it. */
function packed(radii) {
  const [first, second, ...others] = radii;
  const circles = [
    { x: 0, y: 0, r: first },
    { x: first + second, y: 0, r: second },
  ];
  let angle = 0;
  for (const r of others) {
    const [a, b, c] = [first + circles.at(-1).r, first + r, circles.at(-1).r + r];
    angle += Math.acos(Math.max(-1, Math.min(1, (a * a + b * b - c * c) / (2 * a * b))));
    circles.push({ x: b * Math.cos(angle), y: b * Math.sin(angle), r });
  }
  return circles;
}

test.each([
  ["150", [5.473061352023348e21, 1.1729457180068344e21, 1023]],
  ["150", [5.473061352023e12, 1.172945718007e12, 1023]],
  ["109", [9746398945, 2098088, 7282532, 621827840.5, 4878111435.5, 42741940720.5, 103236413853.5]],
  ["89", [0.5672, 0.6363, 0.5628, 1.5619, 1.5659, 0.9196, 0.4747, 0.3834, 1.3476, 2.88e-7]],
])("radii of the report d3-hierarchy#%s", (_report, radii) => {
  for (const order of [radii, [...radii].reverse()]) {
    const circles = packed(order);
    expectAround(circles, enclose(circles));
  }
});

// Kinds of d3-hierarchy's reports: circles that nearly touch the one around others, in numbers
// whose last places decide.
test("circles that all touch one circle, up to rounding", () => {
  for (const size of [1e-7, 1, 14.5, 1e6, 1e22]) {
    const circles = Array.from({ length: 200 }, (_, k) => {
      const [angle, r] = [2.399963 * k, (size * (1 + (k % 7))) / 20];
      return { x: (size - r) * Math.cos(angle), y: (size - r) * Math.sin(angle), r };
    });
    const found = enclose(circles);
    expectAround(circles, found);
    expect(Math.abs(found.r / size - 1)).toBeLessThan(1e-14);
    expect(found.sites.length).toBeGreaterThan(1);
  }
});

test("the same bits after any history", () => {
  const xyr = randomCircles(500, 552, 200);
  const expected = new Diagram(xyr).smallestEnclosingCircle();
  const other = new Diagram(randomCircles(500, 553));
  other.updateMany(
    other.ids(),
    objects(xyr)
      .reverse()
      .flatMap(({ x, y, r }) => [x, y, r]),
  );
  const found = other.smallestEnclosingCircle();
  expect([found.x, found.y, found.r]).toEqual([expected.x, expected.y, expected.r]);
  expect([...found.sites].map((id) => 499 - id).sort((a, b) => a - b)).toEqual([...expected.sites]);
});

test("farthest: the largest |p - c| + r, hidden circles never", () => {
  const xyr = randomCircles(400, 554, 300);
  const circles = objects(xyr);
  const diagram = new Diagram(xyr);
  const random = generator(555);
  for (let k = 0; k < 200; ++k) {
    const [x, y] = [3000 * random() - 1500, 3000 * random() - 1500];
    const { id, distance } = diagram.farthest(x, y);
    const most = Math.max(...circles.map((circle) => reach(circle, x, y)));
    expect(distance).toBeCloseTo(most, 9);
    expect(reach(circles[id], x, y)).toBeCloseTo(most, 9);
    expect(diagram.isHidden(id)).toBe(false);
  }
  expect(new Diagram().farthest(0, 0)).toBeNull();
  // ties go to the larger r, then x, then y
  expect(new Diagram([-2, 0, 1, 2, 0, 1, 0, 1, 2]).farthest(0, 0).id).toBe(2);
  expect(new Diagram([-2, 0, 1, 2, 0, 1, 0, 2, 1]).farthest(0, 0).id).toBe(1);
});

test("farthest on the sphere", () => {
  const random = generator(556);
  const lonLatR = Array.from({ length: 300 }, (_, k) => [
    360 * random() - 180,
    180 * random() - 90,
    k % 3 === 0 ? 1000 * random() : 0,
  ]).flat();
  const radius = 6371;
  const globe = new SphericalDiagram(lonLatR, { radius });
  for (let k = 0; k < 5; ++k) {
    const [lon, lat] = [360 * random() - 180, 180 * random() - 90];
    const { id, distance } = globe.farthest(lon, lat);
    const single = new SphericalDiagram([lon, lat, 0], { radius });
    const way = (site) => {
      const { lon: x, lat: y, r } = globe.site(site);
      return single.nearest(x, y).distance + r;
    };
    expect(Math.abs(Math.max(...Array.from(globe.ids(), way)) - distance)).toBeLessThan(1e-6);
    expect(Math.abs(way(id) - distance)).toBeLessThan(1e-6);
  }
  expect(new SphericalDiagram().farthest(0, 0)).toBeNull();
});
