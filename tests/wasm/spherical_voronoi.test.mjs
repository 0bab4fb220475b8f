// The view of the sphere's cells: its answers within a distance, one by one and all at once, and
// that they are as the plane's.
import { geoArea, geoDistance } from "d3-geo";
import { Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { generator } from "./support/random.mjs";

const random = generator(43);
const degrees = 180 / Math.PI;
const point = () => [360 * random() - 180, Math.asin(2 * random() - 1) * degrees];
const sites = (n, heaviest) => Array.from({ length: n }, () => [...point(), heaviest * random()]);
const radius = 10;

const grid = Array.from({ length: 60 }, (_, k) => [
  -180 + 30 * (k % 12),
  -60 + 30 * ((k / 12) | 0),
  0,
]);
const sets = [
  ["one", [[20, 30, 1]]],
  ["two", sites(2, 1)],
  ["three", sites(3, 1)],
  ["points", sites(50, 0)],
  ["caps", sites(50, 2)],
  ["mostly hidden", sites(50, 12)],
  ["about a pole", sites(30, 0.1).map(([lon, , r], k) => [lon, 90 - k / 3, r])],
  ["across the antimeridian", sites(30, 0.1).map(([lon, lat, r]) => [180 + lon / 20, lat / 9, r])],
  ["a grid", grid],
];
const segmentsOf = (line) => line.slice(1).map((to, k) => `${line[k]} ${to}`);
const reversed = (segment) => segment.split(" ").reverse().join(" ");

/** The sides of cells in common, by pairs of ids. */
function sharedSides(view, options) {
  const owners = new Map();
  for (const ring of view.cellPolygons(options))
    for (const side of segmentsOf(ring)) owners.set(side, ring.index);
  const shared = new Map();
  for (const [side, id] of owners) {
    const other = owners.get(reversed(side));
    if (other !== undefined) shared.set(side, [id, other]);
  }
  return shared;
}

describe.each(sets)("%s", (_, list) => {
  const diagram = new SphericalDiagram(list.flat(), { radius });
  const limits = list.map((_, id) => (id % 4 === 3 ? Infinity : 5 * random()));
  const views = [undefined, 4, -0.5, limits, new Map(limits.entries()), (id) => limits[id]].map(
    (maxDistance) => diagram.voronoi({ maxDistance }),
  );

  test("cells one by one are those of the lists", () => {
    for (const view of views) {
      const [areas, perimeters] = [view.cellAreas(), view.cellPerimeters()];
      const centroids = view.cellCentroids();
      expect([areas.length, perimeters.length]).toEqual([list.length, list.length]);
      expect(centroids.length).toBe(2 * list.length);
      for (const id of diagram.ids()) {
        const measures = view.cellMeasures(id);
        expect(measures).toEqual({
          area: areas[id],
          centroid: view.cellCentroid(id),
          perimeter: perimeters[id],
        });
        expect([view.cellArea(id), view.cellPerimeter(id)]).toEqual([areas[id], perimeters[id]]);
        expect([...centroids.subarray(2 * id, 2 * id + 2)]).toEqual(
          measures.centroid ?? [NaN, NaN],
        );
      }
    }
  });

  test("geometries are those of the collection, cut or not", () => {
    for (const [k, view] of views.entries())
      for (const options of [
        {},
        { winding: "clockwise" },
        { antimeridian: "keep", tolerance: 1 },
      ]) {
        const { features } = view.toGeoJSON(options);
        const shown = new Map(features.map(({ id, geometry }) => [id, geometry]));
        for (const id of diagram.ids()) {
          const geometry = view.cellGeometry(id, options);
          const expected = shown.get(id) ?? null;
          expect(geometry?.type).toBe(expected?.type);
          if (geometry === null || geometry.type === "Sphere") continue;
          // Where neighbours end sooner, those of all have a point there.
          if (k < 3) expect(geometry).toEqual(expected);
          else if (options.winding)
            expect(Math.abs(geoArea(geometry) - geoArea(expected))).toBeLessThan(1e-3);
        }
      }
  });

  test("the mesh has what is a side of two cells, once", () => {
    for (const view of views)
      for (const tolerance of [undefined, 0.02]) {
        if (list.length === 1) continue;
        const shared = sharedSides(view, { tolerance });
        const { type, coordinates } = view.cellMesh({ tolerance });
        expect(type).toBe("MultiLineString");
        const sides = coordinates.flatMap(segmentsOf);
        expect(sides.length).toBe(shared.size / 2);
        for (const side of sides) expect(shared.has(side)).toBe(true);
        expect(new Set(sides.flatMap((side) => [side, reversed(side)])).size).toBe(shared.size);
        // A line is one edge: of one pair.
        for (const line of coordinates)
          expect(new Set(segmentsOf(line).map((side) => String(shared.get(side)))).size).toBe(1);
      }
  });

  test("neighbours are those with a side in common", () => {
    for (const [k, view] of views.entries()) {
      if (list.length === 1) return expect([...view.neighbors(0)]).toEqual([]);
      const near = new Map(Array.from(diagram.ids(), (id) => [id, new Set(view.neighbors(id))]));
      for (const [id, others] of near) {
        expect([...others].length).toBe(view.neighbors(id).length);
        for (const other of others) expect(near.get(other)).toContain(id);
        const all = [...diagram.neighbors(id)];
        if (k === 0) expect([...others]).toEqual(all);
        expect(all.filter((other) => others.has(other)).sort()).toEqual([...others].sort());
      }
      for (const [id, other] of sharedSides(view, { tolerance: 1e-3 }).values())
        expect(near.get(id)).toContain(other);
      if (list === grid) continue; // edges that are points
      const pairs = new Set([...sharedSides(view, { tolerance: 1e-4 }).values()].map(String));
      let missing = 0; // edges as short as the tolerance
      for (const [id, others] of near)
        for (const other of others) missing += pairs.has(`${id},${other}`) ? 0 : 1;
      expect(missing).toBeLessThanOrEqual(2);
    }
  });

  test("what is contained is what is nearest and within", () => {
    for (const [k, view] of views.entries())
      for (let n = 0; n < 60; ++n) {
        const place = point();
        const { id, distance } = diagram.nearest(...place);
        const most = [Infinity, 4, -0.5][k] ?? limits[id];
        expect(view.contains(id, ...place)).toBe(distance <= most);
        for (const other of diagram.ids().subarray(0, 5))
          if (other !== id) expect(view.contains(other, ...place)).toBe(false);
      }
  });

  test("values and weights end where cells do, in slices, too", async () => {
    const values = list.map(() => random());
    const places = Array.from({ length: 80 }, point);
    const whole = views[0].interpolate(values, places.flat());
    for (const [k, view] of views.entries()) {
      const field = view.interpolate(values, places.flat());
      places.forEach((place, n) => {
        const { id, distance } = diagram.nearest(...place);
        const isWithin = distance <= ([Infinity, 4, -0.5][k] ?? limits[id]);
        expect(field[n]).toBe(isWithin ? whole[n] : NaN);
        expect(view.naturalWeights(...place)).toEqual(
          isWithin ? views[0].naturalWeights(...place) : null,
        );
      });
      expect(await view.interpolateAsync(values, places.flat())).toEqual(field);
    }
  });

  test("vertices, edges and empty circles are the diagram's, whatever cells reach", () => {
    for (const view of views) {
      expect(view.vertices()).toEqual(diagram.vertices());
      expect(view.edges()).toEqual(diagram.edges());
      expect(view.emptyCircles(4)).toEqual(views[0].emptyCircles(4));
      expect(view.largestEmptyCircle()).toEqual(views[0].largestEmptyCircle());
    }
  });
});

test("the tolerance of polygons is in the unit of the radius", () => {
  const places = sites(40, 0);
  const points = (r, tolerance) => {
    const isFine = tolerance < 1e-8 * r; // fewer and smaller cells, or there are 100 000 points
    const diagram = new SphericalDiagram((isFine ? places.slice(0, 4) : places).flat(), {
      radius: r,
    });
    const view = diagram.voronoi({ maxDistance: r / (isFine ? 100 : 4) });
    return [...view.cellPolygons({ tolerance })].map((ring) => [...ring]);
  };
  for (let r = 6360; r < 6400; ++r)
    expect(points(r, Number(`${r}e-9`)).length).toBe(points(r, 1e-9 * r).length);
  for (const tolerance of [undefined, 1e-9, 1e-5, 1e-2])
    for (const r of [6371, 1e-50, 3e80]) {
      const expected = points(1, tolerance);
      const scaled = points(r, tolerance && tolerance * r);
      expect(scaled.map((ring) => ring.length)).toEqual(expected.map((ring) => ring.length));
    }
  expect(points(6371, 1).flat().length).toBeGreaterThan(points(6371, 100).flat().length + 20);
});

test("a view shows the diagram as it is now, and lists as they are", () => {
  const diagram = new SphericalDiagram([0, 0, 0, 90, 0, 0]);
  const list = [0.5, 0.5];
  const [view, within] = [diagram.voronoi(), diagram.voronoi({ maxDistance: list })];
  const cap = (r) => 2 * Math.PI * (1 - Math.cos(r));
  expect(view.cellArea(0)).toBeCloseTo(2 * Math.PI, 12);
  expect(within.cellArea(0)).toBeCloseTo(cap(0.5), 12);
  const id = diagram.insert(180, 0);
  expect(view.cellArea(id)).toBeCloseTo(1.5 * Math.PI, 1);
  expect(() => within.cellAreas()).toThrow(expect.objectContaining({ code: "bad-option" }));
  expect(within.cellArea(0)).toBeCloseTo(cap(0.5), 12);
  list[0] = 0.3;
  list.push(0.1);
  expect([...within.cellAreas()]).toEqual([0.3, 0.5, 0.1].map((r) => expect.closeTo(cap(r), 12)));
});

test("a function is asked for one site by a call about one cell, and for all by others", () => {
  const diagram = new SphericalDiagram([0, 0, 0, 10, 0, 0, 0, 10, 0, 90, 0, 0, -90, 0, 0]);
  let asked = [];
  const view = diagram.voronoi({
    maxDistance: (id) => {
      asked.push(id);
      return 0.2;
    },
  });
  const all = [0, 1, 2, 3, 4];
  for (const [call, expected] of [
    [() => view.cellArea(1), [1]],
    [() => view.cellMeasures(1), [1]],
    [() => view.cellGeometry(1), [1]],
    [() => view.cellPolygon(1), [1]],
    [() => view.contains(1, 9, 0), [1]],
    [() => view.contains(1, 80, 0), []],
    [() => view.naturalWeights(9, 0), [1]],
    [() => view.neighbors(1).length, [1, ...diagram.neighbors(1)]],
    [() => view.cellAreas(), all],
    [() => view.cellCentroids(), all],
    [() => view.cellPerimeters(), all],
    [() => view.toGeoJSON(), all],
    [() => view.cellMesh(), all],
    [() => [...view.cellPolygons()], all],
    [() => view.interpolate([1, 2, 3, 4, 5], [0, 0, 9, 0]), all],
    [() => view.emptyCircles(3), []],
  ]) {
    asked = [];
    call();
    expect(asked).toEqual(expected);
  }
});

test("interpolateAsync tells its progress, can be aborted, and notices changes", async () => {
  const diagram = new SphericalDiagram(sites(500, 0).flat());
  const values = Float64Array.from({ length: 500 }, random);
  const places = Array.from({ length: 3000 }, point).flat();
  const view = diagram.voronoi();
  const told = [];
  const field = await view.interpolateAsync(values, places, {
    r: 0.01,
    onProgress: (share) => told.push(share),
  });
  expect(field).toEqual(view.interpolate(values, places, { r: 0.01 }));
  expect([...told].sort((a, b) => a - b)).toEqual(told);
  expect(told.at(-1)).toBe(1);
  const many = Array.from({ length: 40 }, () => places).flat();
  const reason = new Error("enough");
  await expect(
    view.interpolateAsync(values, many, { signal: AbortSignal.abort(reason) }),
  ).rejects.toBe(reason);
  for (const change of [
    () => diagram.insert(1, 2, 0),
    () => diagram.update(0, 3, 4),
    () => diagram.remove(5),
    () => diagram.removeMany([6]),
  ]) {
    const known = new Float64Array(Math.max(...diagram.ids()) + 1);
    const later = view.interpolateAsync(known, many);
    change();
    await expect(later).rejects.toMatchObject({ code: "busy" });
  }
  await expect(view.interpolateAsync([1], places)).rejects.toMatchObject({ code: "bad-length" });
});

test("cellCirclesAsync says what cellCircles says, and notices changes", async () => {
  const diagram = new SphericalDiagram(sites(120, 0).flat());
  for (const limit of [undefined, 900, (id) => 300 + id]) {
    const view = diagram.voronoi({ maxDistance: limit });
    const told = [];
    const circles = await view.cellCirclesAsync({ onProgress: (share) => told.push(share) });
    expect(circles).toEqual(view.cellCircles());
    expect([...told].sort((a, b) => a - b)).toEqual(told);
    expect(told.at(-1)).toBe(1);
  }
  const reason = new Error("enough");
  const view = diagram.voronoi();
  await expect(view.cellCirclesAsync({ signal: AbortSignal.abort(reason) })).rejects.toBe(reason);
  const later = view.cellCirclesAsync();
  diagram.remove(3);
  await expect(later).rejects.toMatchObject({ code: "busy" });
});

// A question has one name, number of arguments and kind of answer on both surfaces.
test("a view of the sphere has the calls of the plane's, but for what the reference says", () => {
  const lacking = ["cellCurves", "cellParts", "dispose", "edgeCurves"];
  lacking.push("fitAreas", "fitAreasAsync", "render", "renderBounds", "renderCell", "renderCells");
  const namesOf = (view) =>
    Object.getOwnPropertyNames(Object.getPrototypeOf(view)).filter(
      (name) => name !== "constructor",
    );
  const [ours, theirs] = [new SphericalDiagram().voronoi(), new Diagram().voronoi()];
  const names = namesOf(ours).filter((name) => !["vertices", "edges"].includes(name));
  const planar = namesOf(theirs).filter((name) => !["vertices", "edges"].includes(name));
  expect([...names, ...lacking].sort()).toEqual(planar.sort());
  for (const name of names)
    if (!/Circle/.test(name))
      // with options in the plane
      expect(`${name} ${ours[name].length}`).toBe(`${name} ${theirs[name].length}`);
  expect(Object.prototype.toString.call(ours)).toBe("[object SphericalVoronoi]");
  expect(Object.isFrozen(ours)).toBe(true);
});

/** The point at a distance from another one, in a direction. */
function pointAt([lon, lat], angle, bearing) {
  const { sin, cos } = Math;
  const from = lat / degrees;
  const to = Math.asin(sin(from) * cos(angle) + cos(from) * sin(angle) * cos(bearing));
  const turn = Math.atan2(sin(bearing) * sin(angle) * cos(from), cos(angle) - sin(from) * sin(to));
  return [lon + turn * degrees, to * degrees];
}

test("the largest circles inside cells are inside, and as large as those of the plane", () => {
  const list = sites(40, 2);
  const globe = new SphericalDiagram(list.flat(), { radius });
  for (const maxDistance of [Infinity, 2, (id) => id % 3]) {
    const view = globe.voronoi({ maxDistance });
    const circles = view.cellCircles();
    expect(circles).toHaveLength(3 * list.length);
    list.forEach((_, id) => {
      const circle = view.cellCircle(id);
      if (view.cellArea(id) === 0) {
        expect([circle, ...circles.subarray(3 * id, 3 * id + 3)]).toEqual([null, NaN, NaN, NaN]);
        return;
      }
      const { lon, lat, r } = circle;
      expect([...circles.subarray(3 * id, 3 * id + 3)]).toEqual([lon, lat, r]);
      expect(r).toBeGreaterThan(0);
      for (let k = 0; k < 32; ++k) {
        const place = pointAt([lon, lat], (r / radius) * (1 - 1e-9), (k * Math.PI) / 16);
        expect(view.contains(id, ...place)).toBe(true);
      }
    });
  }
  const size = 1e-3 * degrees;
  const places = Array.from({ length: 40 }, () => [random(), random(), random() / 30]);
  const small = new SphericalDiagram(
    places.flatMap(([x, y, w]) => [size * x, size * y, w]),
    { radius: 1e3 },
  );
  const plane = new Diagram(places.flat());
  const view = plane.voronoi([-9, -9, 9, 9], { maxDistance: 0.1 });
  places.forEach((_, id) => {
    const ours = small.voronoi({ maxDistance: 0.1 }).cellCircle(id);
    const theirs = view.cellCircle(id);
    expect(ours === null).toBe(theirs === null);
    if (ours) expect(Math.abs(ours.r - theirs.r)).toBeLessThan(0.0011 * theirs.r);
  });
});

// Close to the equator of a huge sphere, all is as on the plane.
test("a small patch of a huge sphere has the plane's neighbours, areas and weights", () => {
  const size = 1e-3 * degrees;
  const places = Array.from({ length: 60 }, () => [random() - 0.5, random() - 0.5, random() / 30]);
  const r = 1e3;
  const globe = new SphericalDiagram(
    places.flatMap(([x, y, w]) => [size * x, size * y, w]),
    { radius: r },
  );
  const plane = new Diagram(places.flat());
  for (const maxDistance of [0.05, (id) => (id % 5) / 60]) {
    const ours = globe.voronoi({ maxDistance });
    const theirs = plane.voronoi([-2, -2, 2, 2], { maxDistance });
    const areas = theirs.cellAreas();
    ours.cellAreas().forEach((area, id) => {
      expect(Math.abs(area - areas[id])).toBeLessThan(1e-6);
      expect([...ours.neighbors(id)].sort()).toEqual([...theirs.neighbors(id)].sort());
    });
    for (let k = 0; k < 50; ++k) {
      const [x, y] = [random() - 0.5, random() - 0.5];
      const id = plane.find(x, y);
      expect(ours.contains(id, size * x, size * y)).toBe(theirs.contains(id, x, y));
      const [a, b] = [ours.naturalWeights(size * x, size * y), theirs.naturalWeights(x, y)];
      expect(a === null).toBe(b === null);
      if (a && Math.max(Math.abs(x), Math.abs(y)) < 0.2)
        expect([...a.ids].sort()).toEqual([...b.ids].sort());
    }
  }
});

test("areas within a distance are those of caps; d3-geo measures the geometries alike", () => {
  const view = new SphericalDiagram([0, 0, 0.1, 90, 0, 0], { radius: 2 }).voronoi({
    maxDistance: 0.5,
  });
  const cap = (angle) => 4 * 2 * Math.PI * (1 - Math.cos(angle));
  expect(view.cellArea(0)).toBeCloseTo(cap(0.3), 12);
  expect(4 * geoArea(view.cellGeometry(0, { winding: "clockwise" }))).toBeCloseTo(cap(0.3), 3);
  for (const place of view.cellPolygon(1))
    expect(2 * geoDistance(place, [90, 0])).toBeCloseTo(0.5, 3);
});
