// d3-delaunay's arrays: against delaunator for points, and as a pairing for circles.
import Delaunator from "delaunator";
import { Diagram } from "../../build/packed/consumer.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const next = (e) => (e % 3 === 2 ? e - 2 : e + 1);
const sorted = (items) => [...items].sort();
/** Triangles, each from its smallest site on, in their own direction. */
function trianglesOf({ triangles }, isReversed = false) {
  return sorted(
    Array.from({ length: triangles.length / 3 }, (_, t) => {
      const three = [...triangles.subarray(3 * t, 3 * t + 3)];
      if (isReversed) three.reverse();
      const at = three.indexOf(Math.min(...three));
      return [...three.slice(at), ...three.slice(0, at)].join(" ");
    }),
  );
}
/** Half-edges as start, end, and the third sites of both triangles. */
function pairsOf({ triangles, halfedges }, isReversed = false) {
  return sorted(
    Array.from(triangles, (_, e) => {
      const across = (h) => (h === -1 ? -1 : triangles[next(next(h))]);
      const ends = [triangles[e], triangles[next(e)]];
      if (isReversed) ends.reverse();
      return [...ends, across(e), across(halfedges[e])].join(" ");
    }),
  );
}

function expectPairing({ triangles, halfedges }) {
  expect(halfedges).toHaveLength(triangles.length);
  halfedges.forEach((twin, e) => {
    if (twin === -1) return;
    expect(halfedges[twin]).toBe(e);
    expect(twin).not.toBe(e);
    expect([triangles[twin], triangles[next(twin)]]).toEqual([triangles[next(e)], triangles[e]]);
  });
}

test.each([3, 4, 10, 1000])("%d points: delaunator's triangles and twins", (count) => {
  const points = randomCircles(count, 190 + count, 0).filter((_, k) => k % 3 !== 2);
  const xyr = Array.from({ length: 3 * count }, (_, k) =>
    k % 3 === 2 ? 5 : points[2 * Math.floor(k / 3) + (k % 3)],
  );
  const ours = new Diagram(xyr).triangulation();
  const theirs = new Delaunator(Float64Array.from(points));
  expect(trianglesOf(ours)).toEqual(trianglesOf(theirs, true));
  expect(pairsOf(ours)).toEqual(pairsOf(theirs, true));
  expect([...ours.points]).toEqual([...points]);
  expect(sorted(ours.hull)).toEqual(sorted(theirs.hull));
  expectPairing(ours);
});

test("a site of two edges is in two triangles, whose others have two edges in common", () => {
  // a small circle in the gap between two large ones
  const diagram = new Diagram([-10, 0, 9, 10, 0, 9, 0, 0, 0.5, 0, 300, 1, 0, -300, 1]);
  const ours = diagram.triangulation();
  expect([...diagram.neighbors(2)].sort()).toEqual([0, 1]);
  const own = [...ours.triangles.keys()].filter((e) => ours.triangles[e] === 2);
  expect(own).toHaveLength(2);
  // around it by half-edges, as with delaunator
  const around = [];
  let e = own[0];
  do {
    around.push(ours.triangles[next(e)]);
    e = ours.halfedges[next(next(e))];
  } while (e !== own[0]);
  expect(around.sort()).toEqual([0, 1]);
  const between = [...ours.triangles.keys()].filter(
    (h) => ours.triangles[h] === 0 && ours.triangles[next(h)] === 1,
  );
  expect(between).toHaveLength(2);
  expectPairing(ours);
});

test("polygons and drawings of triangles, and of the hull", () => {
  const ours = new Diagram([0, 0, 1, 4.25, 0, 1, 0, 3, 1]).triangulation();
  const ring = ours.trianglePolygon(0);
  expect(ring[3]).toEqual(ring[0]);
  expect(sorted(ring.slice(1).map(String))).toEqual(["0,0", "0,3", "4.25,0"]);
  expect([...ours.trianglePolygons()]).toEqual([ring]);
  const drawn = `M${ring[0]}L${ring[1]}L${ring[2]}Z`;
  expect(ours.renderTriangle(0)).toBe(drawn);
  expect(ours.renderTriangle(0, null, { digits: 1 })).toBe(drawn.replaceAll("4.25", "4.3"));
  const calls = [];
  const put =
    (name) =>
    (...list) =>
      calls.push([name, ...list]);
  const context = Object.fromEntries(
    ["moveTo", "lineTo", "bezierCurveTo", "closePath"].map((name) => [name, put(name)]),
  );
  expect(ours.renderTriangle(0, context)).toBeUndefined();
  expect(calls).toEqual([
    ["moveTo", ...ring[0]],
    ["lineTo", ...ring[1]],
    ["lineTo", ...ring[2]],
    ["closePath"],
  ]);
  const hull = ours.hullPolygon();
  expect(hull).toHaveLength(4);
  expect(hull[3]).toEqual(hull[0]);
  for (const wrong of [1, -1, 0.5, NaN, "0", undefined]) {
    expectRefusal(() => ours.trianglePolygon(wrong), "out-of-range", "triangle is ");
    expectRefusal(() => ours.renderTriangle(wrong), "out-of-range", "below 1");
  }
  expectRefusal(() => ours.renderTriangle(0, {}), "bad-option", "without moveTo()");
});

test("no triangles", () => {
  const empty = new Diagram();
  expect(empty.triangulation().hullPolygon()).toEqual([]);
  for (const diagram of [empty, new Diagram([1, 2, 3]), new Diagram([0, 0, 1, 9, 0, 1, 5, 0, 1])]) {
    const { points, triangles, halfedges } = diagram.triangulation();
    expect([triangles.length, halfedges.length]).toEqual([0, 0]);
    expect(points).toHaveLength(2 * diagram.size);
  }
});

test("it stays as it was", () => {
  const diagram = new Diagram(randomCircles(30, 230, 10));
  const ours = diagram.triangulation();
  const before = [...ours.trianglePolygons()];
  expect(diagram.triangulation()).toEqual(ours);
  diagram.clear();
  expect([...ours.trianglePolygons()]).toEqual(before);
});
