// Numbers of a magnitude below 1e-100 are taken as 0, wherever a call takes numbers, and 0 comes
// back, never -0: a radius that decays ends no animation.
import { hierarchy } from "d3-hierarchy";
import { Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { treemap } from "../../build/packed/treemap.mjs";
import { expectRefusal } from "./support/refusal.mjs";

const kTiny = [1e-320, -1e-320, Number.MIN_VALUE, 0.99e-100, -0.99e-100, -0];
const kSites = [0, 0, 0, 30, 0, 0.1, 0, 30, 0.2, -30, -30, 0];

/** The numbers of a site; toEqual tells 0 from -0. */
const numbersOf = (diagram, id) => Object.values(diagram.site(id)).slice(0, 3);

describe.each([
  ["plane", Diagram],
  ["sphere", SphericalDiagram],
])("on the %s", (_, AnyDiagram) => {
  test("a radius that decays by halves ends as 0", () => {
    const diagram = new AnyDiagram(kSites);
    let r = 1;
    for (; r > 0; r /= 2) {
      const id = diagram.insert(40, 40, r);
      diagram.update(1, 30, 0, r);
      diagram.updateMany([2, 3], [0, 30, r, -30, -30, -r]);
      const expected = r < 1e-100 ? 0 : r;
      for (const site of [1, 2, id]) expect(numbersOf(diagram, site)[2]).toBe(expected);
      expect(numbersOf(diagram, 3)[2]).toBe(expected === 0 ? 0 : -expected);
      diagram.remove(id);
    }
    expect(diagram.size).toBe(4);
    const [first] = AnyDiagram.from([{ x: 1, y: 2, r: 5e-324, lon: 1, lat: 2 }]).ids();
    expect(first).toBe(0);
  });

  test.each(kTiny)("sites of %p are at 0", (tiny) => {
    const diagram = new AnyDiagram();
    const id = diagram.insert(tiny, -tiny, tiny);
    const [many] = diagram.insertMany([tiny, tiny, -tiny]);
    const [pair] = diagram.insertMany([tiny, tiny], { r: tiny });
    for (const site of [id, many, pair]) expect(numbersOf(diagram, site)).toEqual([0, 0, 0]);
    diagram.insert(20, 20, 0);
    diagram.update(id, tiny, tiny, tiny);
    expect(numbersOf(diagram, id)).toEqual([0, 0, 0]);
    const copy = AnyDiagram.fromBytes(diagram.toBytes());
    expect(numbersOf(copy, many)).toEqual([0, 0, 0]);
    const built = AnyDiagram.from(
      [0],
      () => tiny,
      () => -tiny,
      () => tiny,
    );
    expect(numbersOf(built, 0)).toEqual([0, 0, 0]);
  });

  test.each(kTiny)("queries at %p are those at 0", (tiny) => {
    const diagram = new AnyDiagram(kSites);
    const options = { maxDistance: tiny };
    expect(diagram.find(tiny, -tiny)).toBe(0);
    expect(diagram.find(tiny, tiny, options)).toBe(0);
    expect(diagram.nearest(tiny, tiny, options)).toEqual(diagram.nearest(0, 0));
    expect(diagram.farthest(tiny, tiny)).toEqual(diagram.farthest(0, 0));
    expect([...diagram.findMany([tiny, tiny, 30, -tiny], options)]).toEqual([0, 1]);
    expect([...diagram.kNearest(tiny, tiny, 4, options)]).toEqual([0]);
    expect([...diagram.kNearestMany([tiny, tiny], 4, options).ids]).toEqual([0]);
    expect([...diagram.within(tiny, tiny, tiny)]).toEqual([0]);
    expect(diagram.pick(tiny, tiny, options)).toBe(0);
    expect(diagram.find(tiny, tiny, { ...options, filter: (id) => id > 0 })).toBe(-1);
  });
});

test.each(kTiny)("views with %p are those with 0", (tiny) => {
  const diagram = new Diagram([0, 0, 1, 5, 1, 2, 2, 6, 0.5]);
  const view = diagram.voronoi([tiny, -tiny, 8, 8]);
  expect([...view.window.bounds]).toEqual([0, 0, 8, 8]);
  expect(view.window.contains(-1e-320, tiny)).toBe(true);
  expect(view.cellAreas()).toEqual(diagram.voronoi([0, 0, 8, 8]).cellAreas());
  const ring = [
    [tiny, tiny],
    [8, -tiny],
    [tiny, 8],
  ];
  const inRing = diagram.voronoi(ring);
  expect([...inRing.window.bounds]).toEqual([0, 0, 8, 8]);
  expect(inRing.window.contains(-1e-320, tiny)).toBe(true);
  const limited = (maxDistance) => diagram.voronoi([0, 0, 8, 8], { maxDistance }).cellAreas();
  for (const limit of [tiny, [tiny, tiny, tiny], () => tiny])
    expect(limited(limit)).toEqual(limited(0));
  expect(view.interpolate([1, 2, 3], [3, tiny], { r: tiny })).toEqual(
    view.interpolate([1, 2, 3], [3, 0]),
  );
  expectRefusal(() => diagram.voronoi([0, 0, tiny, 1]), "bad-bounds", "expected xmin < xmax");
  expectRefusal(() => diagram.voronoi({ x: 0, y: 0, r: tiny }), "bad-bounds", "r of the disc");
  expectRefusal(() => view.fitAreas([1, tiny, 1]), "bad-target", "expected a number above 0");
});

test("treemap().padding(1e-320) lays out as padding(0) does", () => {
  const polygons = (padding) => {
    const root = hierarchy({ children: [{ value: 1 }, { value: 2 }] }).sum((d) => d.value ?? 0);
    return treemap()
      .size([8, 8])
      .padding(padding)(root)
      .leaves()
      .map((leaf) => leaf.polygon);
  };
  expect(polygons(1e-320)).toEqual(polygons(0));
});

test("a sphere has a radius of at least 1e-100", () => {
  expectRefusal(
    () => new SphericalDiagram([], { radius: 1e-101 }),
    "out-of-range",
    "from 1e-100 to",
  );
});
