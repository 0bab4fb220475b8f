// Expectations of d3-delaunay, one by one, in words of our own: each is asked of d3-delaunay and of
// the adapter. `differs` says why the two do not agree.
const square = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
];
const triangle = [
  [0, 0],
  [1, 0],
  [0, 1],
];
const line = [
  [0, 0],
  [1, 0],
  [2, 0],
  [3, 0],
];
const pentagon = [
  [0, 0],
  [10, 1],
  [13, 9],
  [6, 14],
  [-2, 8],
  [5, 6],
];
const sorted = (numbers) => [...numbers].sort((a, b) => a - b);
/** Rings and cycles from their smallest element on. */
const cycle = (items, key = (item) => item) => {
  const keys = items.map(key);
  const start = keys.indexOf(keys.reduce((a, b) => (a < b ? a : b)));
  return [...items.slice(start), ...items.slice(0, start)];
};
const triples = (triangles) =>
  Array.from({ length: triangles.length / 3 }, (_, k) =>
    sorted(triangles.slice(3 * k, 3 * k + 3)).join(" "),
  ).sort();
const corners = (ring) => ring && sorted(ring.slice(0, -1).map(([x, y]) => 1000 * x + y));
const calls = (draw) => {
  const made = [];
  const context = new Proxy(
    {},
    {
      get:
        (_, name) =>
        (...list) =>
          made.push([name, ...list]),
    },
  );
  draw(context);
  return made;
};

/** [name of the expectation, (Delaunay) => result, why the two differ] */
export const report = [
  ["from pairs", (D) => [...D.from(triangle).points]],
  ["from an iterable", (D) => [...D.from(new Set(triangle)).points]],
  ["from an array-like", (D) => [...D.from({ length: 1, 0: [3, 4] }).points]],
  [
    "from with accessors",
    (D) => [
      ...D.from(
        [{ a: 1 }],
        (d) => d.a,
        (_d, i) => i + 5,
      ).points,
    ],
  ],
  ["from a flat array", (D) => [...new D(Float64Array.of(0, 0, 1, 0, 0, 1)).triangles].sort()],
  ["triangles of three points", (D) => triples(D.from(triangle).triangles)],
  [
    "triangles of a square",
    (D) => triples(D.from(square).triangles),
    "the other diagonal: four points on one circle have two triangulations, and here the choice " +
      "depends on the set of points alone",
  ],
  [
    "twins of half-edges run the other way",
    (D) => {
      const { triangles, halfedges } = D.from(pentagon);
      const end = (e) => triangles[e % 3 === 2 ? e - 2 : e + 1];
      return sorted(
        [...halfedges].map((twin, e) =>
          twin === -1
            ? -1
            : Number(
                triangles[twin] === end(e) && end(twin) === triangles[e] && halfedges[twin] === e,
              ),
        ),
      );
    },
  ],
  ["the polygon of a triangle", (D) => corners(D.from(triangle).trianglePolygon(0))],
  [
    "the polygon of a triangle is closed",
    (D) => {
      const ring = D.from(triangle).trianglePolygon(0);
      return [ring.length, String(ring[0]) === String(ring[3])];
    },
  ],
  [
    "polygons of all triangles",
    (D) => [...D.from(pentagon).trianglePolygons()].map((ring) => corners(ring).join()).sort(),
  ],
  ["the path of a triangle", (D) => D.from(triangle).renderTriangle(0).split(/[MLZ]/).sort()],
  [
    "a triangle drawn into a context",
    (D) => calls((c) => D.from(triangle).renderTriangle(0, c)).map(([name]) => name),
  ],
  ["the polygon of the hull", (D) => corners(D.from(pentagon).hullPolygon())],
  [
    "direction of triangles",
    (D) => cycle([...D.from(triangle).triangles]),
    "counter-clockwise with y upwards, as the hull",
  ],
  ["hull of three points", (D) => sorted(D.from(triangle).hull)],
  [
    "direction of the hull",
    (D) => cycle([...D.from(triangle).hull]),
    "counter-clockwise with y upwards, which is the other way round on a page",
  ],
  ["hull of no points", (D) => [...D.from([]).hull]],
  ["hull of one point", (D) => [...D.from([[1, 2]]).hull]],
  [
    "hull of two points",
    (D) =>
      sorted(
        D.from([
          [0, 0],
          [1, 0],
        ]).hull,
      ),
  ],
  [
    "triangles of no, one, two points",
    (D) => [0, 1, 2].map((k) => D.from(triangle.slice(0, k)).triangles.length),
    "none below three points; d3-delaunay has a triangle with itself for one and two",
  ],
  ["hull of points in line", (D) => [...D.from(line).hull].length, "all of them, there and back"],
  [
    "triangles of points in line",
    (D) => D.from(line).triangles.length,
    "none: points in line have no Voronoi vertex; d3-delaunay has one that is degenerate",
  ],
  ["order of points in line", (D) => [...D.from(line).collinear]],
  ["neighbors in line", (D) => line.map((_, i) => sorted(D.from(line).neighbors(i)))],
  [
    "neighbors of three points",
    (D) => triangle.map((_, i) => sorted(D.from(triangle).neighbors(i))),
  ],
  [
    "neighbors in a square",
    (D) => square.map((_, i) => sorted(D.from(square).neighbors(i))),
    "the other diagonal",
  ],
  [
    "neighbors of one point",
    (D) => [...D.from([[1, 2]]).neighbors(0)],
    "none; d3-delaunay says -1",
  ],
  [
    "find",
    (D) =>
      [
        [0, -1],
        [2.2, 0],
        [9, 1],
        [1.4, 7],
      ].map(([x, y]) => D.from(line).find(x, y)),
  ],
  ["find of no points", (D) => D.from([]).find(0, 0)],
  ["find of NaN", (D) => [D.from(line).find(NaN, 0), D.from(line).find(0, NaN)]],
  [
    "find after points moved",
    (D) => {
      const d = D.from([
        [0, 0],
        [300, 0],
        [0, 300],
        [300, 300],
        [100, 100],
      ]);
      const before = d.find(49, 49);
      d.points[0] = d.points[1] = 50;
      return [before, d.update().find(60, 49)];
    },
  ],
  [
    "default bounds",
    (D) => {
      const v = D.from(triangle).voronoi();
      return [v.xmin, v.ymin, v.xmax, v.ymax];
    },
  ],
  [
    "bounds as given",
    (D) => {
      const v = D.from(triangle).voronoi([-1, -2, 3, 4]);
      return [v.xmin, v.ymin, v.xmax, v.ymax];
    },
  ],
  ...[
    ["inverted", [1, 0, 0, 1]],
    ["NaN", [NaN, 0, 1, 1]],
    ["too few", [0, 0, 1]],
  ].map(([what, bounds]) => [
    `invalid bounds (${what}) throw`,
    (D) => {
      try {
        D.from(triangle).voronoi(bounds);
        return "nothing";
      } catch {
        return "thrown";
      }
    },
  ]),
  [
    "empty bounds",
    (D) => {
      try {
        D.from(triangle).voronoi([0, 0, 0, 0]);
        return "nothing";
      } catch {
        return "thrown";
      }
    },
    "bounds have an inside: xmin < xmax and ymin < ymax",
  ],
  [
    "circumcenter of three points",
    (D) => [
      ...D.from([
        [0, 0],
        [300, 0],
        [0, 300],
      ]).voronoi().circumcenters,
    ],
  ],
  [
    "cell of one point is the window",
    (D) =>
      corners(
        D.from([[5, 5]])
          .voronoi([0, 0, 9, 8])
          .cellPolygon(0),
      ),
  ],
  [
    "cells of two points",
    (D) =>
      [0, 1].map((i) =>
        corners(
          D.from([
            [2, 2],
            [6, 2],
          ])
            .voronoi([0, 0, 8, 4])
            .cellPolygon(i),
        ),
      ),
  ],
  [
    "cells of three points",
    (D) =>
      [0, 1, 2].map((i) =>
        corners(
          D.from([
            [0, 0],
            [6, 0],
            [0, 6],
          ])
            .voronoi([-1, -1, 8, 8])
            .cellPolygon(i),
        ),
      ),
  ],
  [
    "cells of four points on one circle",
    (D) => square.map((_, i) => corners(D.from(square).voronoi([-1, -1, 2, 2]).cellPolygon(i))),
  ],
  [
    "cells of points in line",
    (D) => line.map((_, i) => corners(D.from(line).voronoi([-1, -1, 5, 1]).cellPolygon(i))),
    "exactly; d3-delaunay moves the points a little, by up to 2e-8 here",
  ],
  [
    "where a ring starts, and how it runs",
    (D) =>
      D.from([
        [2, 2],
        [6, 2],
      ])
        .voronoi([0, 0, 8, 4])
        .cellPolygon(0),
    "counter-clockwise with y upwards; the first corner may be another",
  ],
  [
    "the last point of a ring is its first",
    (D) => {
      const ring = D.from(triangle).voronoi([-1, -1, 2, 2]).cellPolygon(0);
      return String(ring[0]) === String(ring.at(-1));
    },
  ],
  [
    "a cell outside the window is null",
    (D) =>
      D.from([
        [1, 1],
        [100, 1],
        [200, 1],
      ])
        .voronoi([0, 0, 9, 9])
        .cellPolygon(2),
  ],
  [
    "cellPolygons: those with a cell, and their index",
    (D) =>
      [
        ...D.from([
          [1, 1],
          [4, 1],
          [200, 1],
        ])
          .voronoi([0, 0, 9, 9])
          .cellPolygons(),
      ].map((c) => c.index),
  ],
  [
    "a duplicate has no cell",
    (D) =>
      [0, 1, 2]
        .map(
          (i) =>
            D.from([
              [1, 1],
              [4, 1],
              [1, 1],
            ])
              .voronoi([0, 0, 9, 9])
              .cellPolygon(i) !== null,
        )
        .filter(Boolean).length,
  ],
  [
    "contains",
    (D) =>
      [
        [1, 1],
        [5, 1],
        [100, 100],
      ].map(([x, y]) =>
        D.from([
          [1, 1],
          [4, 1],
        ])
          .voronoi([0, 0, 9, 9])
          .contains(1, x, y),
      ),
  ],
  [
    "contains of NaN",
    (D) => {
      try {
        return D.from(line).voronoi().contains(0, NaN, 0);
      } catch {
        return "thrown";
      }
    },
    "NaN is an error",
  ],
  [
    "cells with a common edge in the window",
    (D) =>
      [0, 1, 2].map((i) =>
        sorted(
          D.from([
            [0, 0],
            [6, 0],
            [0, 6],
          ])
            .voronoi([-1, -1, 2, 2])
            .neighbors(i),
        ),
      ),
  ],
  [
    "the path of the bounds",
    (D) =>
      corners(
        calls((c) => D.from(triangle).voronoi([0, 0, 9, 8]).renderBounds(c))
          .filter(([name]) => name !== "rect")
          .map(([, x, y]) => [x, y]),
      ),
    "a closed path; d3-delaunay calls rect()",
  ],
  [
    "the path of a cell is closed",
    (D) => D.from(triangle).voronoi([-1, -1, 2, 2]).renderCell(0).endsWith("Z"),
  ],
  [
    "the path of a cell outside the window",
    (D) =>
      D.from([
        [1, 1],
        [100, 1],
        [200, 1],
      ])
        .voronoi([0, 0, 9, 9])
        .renderCell(2),
    "an empty string, not null: a path is a string always",
  ],
  [
    "the path of the edges of one point",
    (D) =>
      D.from([[1, 1]])
        .voronoi()
        .render(),
    "an empty string, not null",
  ],
  [
    "the path of the edges of no points",
    (D) => D.from([]).voronoi().render(),
    "an empty string, not null",
  ],
  [
    "the path of the edge of two points",
    (D) =>
      D.from([
        [2, 2],
        [6, 2],
      ])
        .voronoi([0, 0, 8, 4])
        .render()
        .split(/[ML]/)
        .sort()
        .join(" ")
        .trim(),
    "one segment; d3-delaunay draws two rays from a point between",
  ],
  [
    "how many lines the edges of three points are",
    (D) =>
      calls((c) =>
        D.from([
          [0, 0],
          [6, 0],
          [0, 6],
        ])
          .voronoi([-1, -1, 8, 8])
          .render(c),
      ).filter(([name]) => name === "lineTo").length,
  ],
  [
    "the path of the hull has all corners",
    (D) =>
      sorted(
        calls((c) => D.from(triangle).renderHull(c))
          .filter(([name]) => /To$/.test(name))
          .map(([, x, y]) => 1000 * x + y),
      ).filter((v, k, all) => v !== all[k - 1]),
  ],
  [
    "a view follows its diagram after update",
    (D) => {
      const d = D.from([
        [2, 2],
        [6, 2],
      ]);
      const v = d.voronoi([0, 0, 8, 4]);
      d.points[2] = 4;
      v.update();
      return corners(v.cellPolygon(0));
    },
  ],
];
