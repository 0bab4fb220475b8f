// Windows of any shape: every form that one can have, holes and parts in every shape that comes
// out, bad rings. The geometry itself is tested in tests/geometry/regions_test.cpp.
import { Delaunay } from "d3-delaunay";
import { Diagram } from "../../build/packed/consumer.mjs";
import { generator, randomCircles } from "./support/random.mjs";
import { isInside, Recorder, ringArea } from "./support/recorder.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const circles = randomCircles(300, 61, 90);
const diagram = new Diagram(circles);

const outer = [
  [-800, -600],
  [900, -500],
  [700, 700],
  [0, 100],
  [-700, 650],
];
const hole = [
  [-300, -300],
  [-300, 0],
  [0, -300],
];
const island = [
  [800, 500],
  [950, 500],
  [950, 800],
];
const closed = (ring) => [...ring, ring[0]];
const shape = { type: "Polygon", coordinates: [closed(outer), closed(hole)] };
const multi = (...rings) => ({
  type: "MultiPolygon",
  coordinates: rings.map((ring) => [closed(ring)]),
});
const collection = (...geometries) => ({
  type: "FeatureCollection",
  features: geometries.map((geometry) => ({ type: "Feature", properties: null, geometry })),
});
const areaOf = (points) => Math.abs(ringArea(closed(points).flat()));
const flatOf = (ring) => ring.flat?.() ?? ring;
const total = (values) => values.reduce((sum, value) => sum + value, 0);

test("rings of points, flat rings, nested lists and GeoJSON are one region", () => {
  const expected = diagram.voronoi(shape).cellAreas();
  expect(total(expected)).toBeCloseTo(areaOf(outer) - areaOf(hole), 6);
  const forms = [
    [outer, hole],
    [outer.flat(), hole.flat()],
    [Float64Array.from(outer.flat()), Float32Array.from(hole.flat())],
    [[closed(outer), closed(hole)]],
    [outer.map(([x, y]) => [x, y, 17]), hole.map((point) => Float64Array.from(point))],
    [[...outer].reverse(), hole],
    { type: "MultiPolygon", coordinates: [shape.coordinates] },
    { type: "Feature", properties: {}, geometry: shape },
    collection(shape),
    // an island of its own, which cancels where the hole is
    collection({ type: "Polygon", coordinates: [closed(outer)] }, multi(hole)),
  ];
  for (const form of forms) {
    const areas = diagram.voronoi(form).cellAreas();
    for (let id = 0; id < 300; ++id) expect(areas[id]).toBeCloseTo(expected[id], 6);
  }
  expect(total(diagram.voronoi(outer.flat()).cellAreas())).toBeCloseTo(areaOf(outer), 6);
  expect(total(diagram.voronoi(outer).cellAreas())).toBeCloseTo(areaOf(outer), 6);
});

test("what cellParts, cellPolygon and toGeoJSON give is a window, with its holes", () => {
  const alone = Diagram.from([[0, 0, 5]]);
  const around = alone.voronoi([outer, hole, island]);
  const whole = areaOf(outer) - areaOf(hole) + areaOf(island);
  expect(around.cellArea(0)).toBeCloseTo(whole, 6);
  for (const flat of [false, true]) {
    const regions = around.cellParts(0, { flat });
    expect(regions.map((rings) => rings.length).sort()).toEqual([1, 2]);
    expect(alone.voronoi(regions).cellArea(0)).toBeCloseTo(whole, 6);
    for (const region of regions) {
      const area = total(region.map((ring) => ringArea(flatOf(ring))));
      expect(alone.voronoi(region).cellArea(0)).toBeCloseTo(area, 6);
      expect(alone.voronoi([region]).cellArea(0)).toBeCloseTo(area, 6);
    }
    expect(alone.voronoi(around.cellPolygon(0, { flat })).cellArea(0)).toBeCloseTo(whole, 6);
  }
  expect(alone.voronoi(around.toGeoJSON()).cellArea(0)).toBeCloseTo(whole, 6);
  expect(alone.voronoi(around.toGeoJSON().features[0]).cellArea(0)).toBeCloseTo(whole, 6);
});

test.each([
  [
    "a triangle, closed",
    [
      [0, 0],
      [90, 0],
      [0, 90],
      [0, 0],
    ],
  ], // as many points as bounds have numbers
  [
    "a triangle",
    [
      [0, 0],
      [90, 0],
      [0, 90],
    ],
  ],
  [
    "a rectangle",
    [
      [0, 0],
      [90, 0],
      [90, 45],
      [0, 45],
    ],
  ],
  [
    "a pentagon",
    [
      [0, 0],
      [90, 0],
      [90, 30],
      [30, 60],
      [0, 30],
    ],
  ],
])("a ring with holes, alone and in a list: %s", (_, ring) => {
  const hole = [
    [10, 10],
    [10, 20],
    [20, 10],
    [10, 10],
  ];
  const expected = areaOf(ring) - 50;
  const nested = [ring, hole];
  const flat = nested.map((one) => Float64Array.from(one.flat()));
  for (const region of [nested, [nested], flat, [flat]])
    expect(total(diagram.voronoi(region).cellAreas())).toBeCloseTo(expected, 9);
});

test("all cells together are the window again", () => {
  const voronoi = diagram.voronoi([outer, hole, island]);
  const expected = areaOf(outer) - areaOf(hole) + areaOf(island);
  const cells = voronoi.toGeoJSON();
  expect(total(diagram.voronoi(cells).cellAreas()) / expected).toBeCloseTo(1, 9);
});

test("the box is where the region is", () => {
  const { xmin, ymin, xmax, ymax } = diagram.voronoi([outer, island]);
  expect([xmin, ymin, xmax, ymax]).toEqual([-800, -600, 950, 800]);
});

test("a region that is a rectangle gives the same as bounds", () => {
  const region = diagram.voronoi([-900, -700, 1000, -700, 1000, 800, -900, 800]);
  const bounds = diagram.voronoi([-900, -700, 1000, 800]);
  for (const call of ["cellAreas", "cellCentroids", "cellPerimeters"]) {
    const [ours, theirs] = [region[call](), bounds[call]()];
    expect(ours.length).toBe(theirs.length);
    for (let k = 0; k < ours.length; ++k) {
      if (Number.isNaN(theirs[k])) expect(ours[k]).toBeNaN();
      else expect(Math.abs(ours[k] - theirs[k])).toBeLessThan(1e-6);
    }
  }
  for (const id of diagram.ids()) {
    expect([...region.neighbors(id)].sort()).toEqual([...bounds.neighbors(id)].sort());
    expect(region.contains(id, 3, 4)).toBe(bounds.contains(id, 3, 4));
  }
});

test("measures of all cells are those of each", () => {
  const voronoi = diagram.voronoi([outer, hole, island]);
  const [areas, centroids, perimeters] = [
    voronoi.cellAreas(),
    voronoi.cellCentroids(),
    voronoi.cellPerimeters(),
  ];
  for (const id of diagram.ids()) {
    const one = voronoi.cellMeasures(id) ?? { area: 0, centroid: null, perimeter: 0 };
    expect(one.area).toBeCloseTo(areas[id], 6);
    expect(one.perimeter).toBeCloseTo(perimeters[id], 6);
    const [x, y] = one.centroid ?? [NaN, NaN];
    if (Number.isNaN(x)) expect(centroids[2 * id]).toBeNaN();
    else expect(Math.hypot(centroids[2 * id] - x, centroids[2 * id + 1] - y)).toBeLessThan(1e-6);
  }
});

test("rings, holes and parts: polygons hold the points that are nearest and in the region", () => {
  const voronoi = diagram.voronoi([outer, hole, island]);
  const random = generator(5);
  const inRegion = (x, y) =>
    [outer, hole, island].filter((ring) => isInside(closed(ring).flat(), x, y)).length % 2 === 1;
  const regions = new Map(
    [...diagram.ids()].map((id) => [id, voronoi.cellParts(id, { flat: true }) ?? []]),
  );
  const isIn = (id, x, y) =>
    regions
      .get(id)
      .some(
        ([ring, ...holes]) => isInside(ring, x, y) && !holes.some((other) => isInside(other, x, y)),
      );
  let wrong = 0;
  for (let k = 0; k < 3000; ++k) {
    const [x, y] = [-900 + 1900 * random(), -700 + 1600 * random()];
    const expected = inRegion(x, y) ? diagram.find(x, y) : -1;
    const found = [...regions.keys()].filter((id) => isIn(id, x, y));
    wrong += found.length > 1 || (found[0] ?? -1) !== expected ? 1 : 0;
  }
  expect(wrong).toBeLessThanOrEqual(6); // within the tolerance of an edge
});

test("one cell around a hole and two islands: GeoJSON says so", () => {
  const alone = Diagram.from([[0, 0, 5]]);
  const square = (x, y, r) => [
    [x - r, y - r],
    [x + r, y - r],
    [x + r, y + r],
    [x - r, y + r],
  ];
  // An island in the hole of the large square, and one beside it.
  const voronoi = alone.voronoi([
    square(0, 0, 10),
    square(0, 0, 5),
    square(1, 0, 2),
    square(20, 0, 1),
  ]);
  const { geometry } = voronoi.toGeoJSON().features[0];
  expect(geometry.type).toBe("MultiPolygon");
  expect(geometry.coordinates.map((polygon) => polygon.length).sort()).toEqual([1, 1, 2]);
  const [ring, inner] = geometry.coordinates.find((polygon) => polygon.length === 2);
  expect(ringArea(ring.flat())).toBe(400);
  expect(ringArea(inner.flat())).toBe(-100);
  const { area, centroid, perimeter } = voronoi.cellMeasures(0);
  expect([area, perimeter]).toEqual([400 - 100 + 16 + 4, 80 + 40 + 16 + 8]);
  expect(centroid[0]).toBeCloseTo((16 * 1 + 4 * 20) / 320, 12);
  expect(centroid[1]).toBeCloseTo(0, 12);
  expect(ringArea(voronoi.cellPolygon(0, { flat: true }))).toBe(320);
  const drawn = new Recorder();
  voronoi.renderCell(0, drawn);
  expect(drawn.count("closePath")).toBe(4);
  expect(voronoi.cellCurves(0).starts.length).toBe(5);
});

test("equal weights in a convex region: the cells of d3-delaunay, clipped", () => {
  const random = generator(9);
  const points = Array.from({ length: 200 }, () => [random() * 960, random() * 500]);
  const ring = Array.from({ length: 40 }, (_, k) => {
    const angle = (2 * Math.PI * k) / 40;
    return [480 + 300 * Math.cos(angle), 250 + 200 * Math.sin(angle)];
  });
  const theirs = Delaunay.from(points).voronoi([0, 0, 960, 500]);
  const areas = new Diagram(points.flatMap(([x, y]) => [x, y, 3])).voronoi(ring).cellAreas();
  for (let id = 0; id < points.length; ++id) {
    // Sutherland and Hodgman: one side of the region after the other.
    let polygon = theirs.cellPolygon(id).slice(1);
    ring.forEach(([ax, ay], k) => {
      const [bx, by] = ring[(k + 1) % ring.length];
      const side = ([x, y]) => (bx - ax) * (y - ay) - (by - ay) * (x - ax);
      polygon = polygon.flatMap((p, m) => {
        const q = polygon[(m + 1) % polygon.length];
        const [s, t] = [side(p), side(q)];
        const cut = p.map((value, axis) => value + (s / (s - t)) * (q[axis] - value));
        return [...(s >= 0 ? [p] : []), ...(s * t < 0 ? [cut] : [])];
      });
    });
    const expected = polygon.length < 3 ? 0 : Math.abs(ringArea(closed(polygon).flat()));
    expect(Math.abs(areas[id] - expected)).toBeLessThan(1e-7);
  }
});

test("it follows the diagram, and outlives neither it nor its use", () => {
  const moving = new Diagram([0, 0, 1, 10, 0, 1]);
  const voronoi = moving.voronoi([-10, -10, 20, -10, 20, 10, -10, 10]);
  expect([...voronoi.cellAreas()]).toEqual([300, 300]);
  moving.update(1, 20, 0, 1);
  expect([...voronoi.cellAreas()]).toEqual([400, 200]);
  const third = moving.insert(10, 0, 1);
  expect(voronoi.cellArea(third)).toBeCloseTo(200, 9);
  moving.remove(third);
  expect([...voronoi.cellAreas()].slice(0, 2)).toEqual([400, 200]);
  moving.clear();
  expect(voronoi.cellAreas().length).toBe(0);
  moving.dispose();
  expectRefusal(() => voronoi.cellAreas(), "disposed", "");
  expectRefusal(() => voronoi.renderBounds(), "disposed", "");
});

test("the border is drawn without what cancels", () => {
  // The two squares share a side, which is inside of neither.
  const voronoi = diagram.voronoi([
    [0, 0, 1, 0, 1, 1, 0, 1],
    [1, 0, 2, 0, 2, 1, 1, 1],
  ]);
  expect(voronoi.renderBounds()).toBe("M0,1L0,0L1,0L2,0L2,1L1,1Z");
});

test.each([
  [
    [
      [0, 0],
      [1, 0],
    ],
    "ring 0 of the region has 2 points",
  ],
  [[0, 0, 1, 0, 1, 1, 0], "ring 0 of the region has 7 numbers"],
  [
    [
      outer,
      [
        [0, 0],
        [1, 0],
        [0, 0],
      ],
    ],
    "ring 1 of the region has 2 points",
  ],
  [
    [
      outer,
      [
        [0, 0],
        [1, NaN],
        [1, 1],
      ],
    ],
    "y of point 1 in ring 1 of the region is NaN",
  ],
  [
    [
      [0, 0],
      [1, 0],
      [1e101, 1],
    ],
    "x of point 2 in ring 0 of the region is 1e+101",
  ],
  [
    [
      [0, 0],
      ["1", 0],
      [1, 1],
    ],
    'x of point 1 in ring 0 of the region is the string "1"',
  ],
  [
    [
      [0, 0],
      [1, 0],
      [2, 0],
    ],
    "the region has no area",
  ],
  [
    [
      [0, 0],
      [1, 0],
      [1, 1],
      [1, 0],
    ],
    "the region has no area",
  ],
  [[[]], "the region has no rings"],
  [{ type: "Point", coordinates: [0, 0] }, "the region is an object of type Point, expected rings"],
  [{ type: 7, coordinates: [0, 0] }, "the region is an object of type 7, expected rings, or Geo"],
  [{ type: Object.create(null) }, "the region is an object of type an object, expected rings"],
  [{ type: "Feature", geometry: null }, "the region is a Feature without geometry, expected"],
  [
    { type: "Feature", geometry: { type: "LineString" } },
    "the region is an object of type LineString, expected",
  ],
  [{ type: "Polygon" }, "ring 0 of the region is no array"],
  [collection(shape, null), "the region is a Feature without geometry"],
  [collection(shape, { type: "Polygon" }), "ring 2 of the region is no array"],
  [collection(), "the region has no rings"],
  [{ type: "FeatureCollection" }, "the region is an object of type FeatureCollection, expected"],
  [{ type: "FeatureCollection", features: [null] }, "the region is"],
  [[[[[outer]]]], "ring 0 of the region is nested too deep"],
  [[outer, [[[[hole]]]]], "ring 1 of the region is nested too deep"],
])("%j is refused: %s", (region, message) => {
  expectRefusal(() => diagram.voronoi(region), "bad-bounds", message);
});

/** Gives what is made to `put`, which makes it a part of itself. */
const looped = (made, put) => {
  put(made);
  return made;
};
test.each([
  ["a list", () => looped([], (list) => list.push(list))],
  ["a list behind a ring", () => looped([outer], (list) => list.push(list))],
  ["a Feature", () => looped({ type: "Feature" }, (it) => Object.assign(it, { geometry: it }))],
  ["a FeatureCollection", () => looped(collection(), (it) => it.features.push(it))],
])("what is nested in itself is refused: %s", (_, make) => {
  expectRefusal(() => diagram.voronoi(make()), "bad-bounds", "");
});
