// With equal radii, whatever they are, the results are those of d3-delaunay.
import { Delaunay } from "d3-delaunay";
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator } from "./support/random.mjs";

const count = 400;
const random = generator(71);
const items = Array.from({ length: count }, () => ({ x: random() * 960, y: random() * 500 }));
const delaunay = Delaunay.from(
  items,
  (d) => d.x,
  (d) => d.y,
);
/** A cycle of ids from the smallest one on. */
const cycle = (ids) => {
  const start = ids.indexOf(Math.min(...ids));
  return [...ids.slice(start), ...ids.slice(0, start)];
};
/** Corners of a hull, without points in line between two others. */
const corners = (hull, points) => {
  const cross = (a, b, c) =>
    (points[2 * b] - points[2 * a]) * (points[2 * c + 1] - points[2 * a + 1]) -
    (points[2 * c] - points[2 * a]) * (points[2 * b + 1] - points[2 * a + 1]);
  return [...hull].filter((id, k) => cross(hull.at(k - 1), id, hull[(k + 1) % hull.length]) !== 0);
};
/**
 * Ours is counter-clockwise with y upwards, and has all points that are in line on it;
 * d3-delaunay's may lack some.
 */
const expectSameHull = (diagram, { hull, points }) => {
  const ours = diagram.hull();
  expect(cycle(corners(ours, points))).toEqual(cycle(corners(hull, points).reverse()));
  expect([...hull].filter((id) => !ours.includes(id))).toEqual([]);
};
const sorted = (numbers) => [...numbers].sort((a, b) => a - b);

describe.each([0, 1, 250, -3])("all radii %d", (r) => {
  const diagram = Diagram.from(
    items,
    (d) => d.x,
    (d) => d.y,
    () => r,
  );

  test("find", () => {
    for (let k = 0; k < 3000; ++k) {
      const [x, y] = [random() * 1200 - 120, random() * 700 - 100];
      expect(diagram.find(x, y)).toBe(delaunay.find(x, y));
    }
  });

  test("neighbors", () => {
    for (let id = 0; id < count; ++id)
      expect(sorted(diagram.neighbors(id))).toEqual(sorted(delaunay.neighbors(id)));
  });

  test("hull", () => {
    expectSameHull(diagram, delaunay);
  });

  test.each([
    ["a few", (k) => [(k * 7919) % 101, (k * 104729) % 97], 12],
    ["in a disk", (k) => [Math.sqrt(k) * Math.cos(k), Math.sqrt(k) * Math.sin(k)], 300],
    ["on a circle", (k) => [Math.cos(k), Math.sin(k)], 60],
    ["a lattice, with points in line on the hull", (k) => [k % 9, Math.floor(k / 9)], 63],
    [
      "a triangle",
      (k) =>
        [
          [0, 0],
          [5, 1],
          [2, 4],
        ][k],
      3,
    ],
  ])("hull of other points: %s", (_, point, length) => {
    const points = Array.from({ length }, (__, k) => point(k));
    const circles = new Diagram(points.flatMap(([x, y]) => [x, y, r]));
    expectSameHull(circles, Delaunay.from(points));
  });

  test("points in line, two and one: the hull goes there and back, neighbors are beside", () => {
    for (const point of [
      (k) => [k, 0],
      (k) => [0, -k],
      (k) => [3 * k, -k],
      (k) => [(k % 7) + 10 * Math.floor(k / 7), 5],
    ]) {
      const points = Array.from({ length: 20 }, (_, k) => point((k * 7) % 20));
      const { collinear } = Delaunay.from(points);
      const line = new Diagram(points.flatMap(([x, y]) => [x, y, r]));
      expect(sorted(line.hull())).toEqual(sorted([...collinear, ...collinear.subarray(1, -1)]));
      collinear.forEach((id, k) => {
        expect(sorted(line.neighbors(id))).toEqual(
          sorted([collinear[k - 1], collinear[k + 1]].filter((other) => other !== undefined)),
        );
        expect(sorted(line.neighbors(id))).toEqual(sorted(Delaunay.from(points).neighbors(id)));
      });
    }
    expect(sorted(new Diagram([0, 0, r, 5, 5, r]).hull())).toEqual(
      sorted(
        Delaunay.from([
          [0, 0],
          [5, 5],
        ]).hull,
      ),
    );
    expect(sorted(new Diagram([3, 4, r]).hull())).toEqual([...Delaunay.from([[3, 4]]).hull]);
  });

  test("triangles and circumcenters are the vertices", () => {
    const { sites, xy, clearance } = diagram.vertices();
    const rows = (triples, centers) =>
      Array.from({ length: triples.length / 3 }, (_, k) => ({
        key: sorted(triples.slice(3 * k, 3 * k + 3)).join(" "),
        x: centers[2 * k],
        y: centers[2 * k + 1],
      })).sort((a, b) => (a.key < b.key ? -1 : 1));
    const ours = rows(sites, xy);
    const theirs = rows(delaunay.triangles, delaunay.voronoi([0, 0, 960, 500]).circumcenters);
    expect(ours.map(({ key }) => key)).toEqual(theirs.map(({ key }) => key));
    ours.forEach(({ x, y }, k) => {
      // d3-delaunay's circumcenters lose digits in flat triangles; ours do not.
      const tolerance = 1e-6 * (1 + Math.hypot(x, y));
      expect(Math.hypot(x - theirs[k].x, y - theirs[k].y)).toBeLessThan(tolerance);
    });
    expect(clearance.every((d) => d > -r)).toBe(true);
  });

  test("halfedges are the edges", () => {
    const pairs = new Set();
    const { triangles, halfedges } = delaunay;
    triangles.forEach((from, h) => {
      const to = triangles[h % 3 === 2 ? h - 2 : h + 1];
      if (halfedges[h] < h) pairs.add(sorted([from, to]).join(" "));
    });
    const { sites } = diagram.edges();
    expect(
      new Set(
        Array.from({ length: sites.length / 2 }, (_, k) =>
          sorted(sites.slice(2 * k, 2 * k + 2)).join(" "),
        ),
      ),
    ).toEqual(pairs);
    expect(sites.length / 2).toBe(pairs.size);
  });
});

test("from takes the same accessors", () => {
  const calls = [];
  const x = (item, index, all) => {
    calls.push([index, all === items]);
    return item.x;
  };
  const built = Diagram.from(items, x, (d) => d.y);
  const ours = calls.splice(0);
  Delaunay.from(items, x, (d) => d.y);
  expect(ours).toEqual(calls);
  expect(built.find(100, 100)).toBe(delaunay.find(100, 100));
});

test("duplicates: d3-delaunay skips all but one, here the others are hidden", () => {
  const points = [
    [10, 10],
    [50, 10],
    [10, 60],
    [10, 10],
  ];
  const diagram = Diagram.from(points);
  expect(diagram.visibleSize).toBe(3);
  expect(diagram.isHidden(0) !== diagram.isHidden(3)).toBe(true);
  expect(Delaunay.from(points).triangles.length).toBe(3);
});
