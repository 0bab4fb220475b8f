// The largest empty circles with their centres in a window, against trying all places.
import { Diagram } from "../../build/packed/consumer.mjs";
import { box, windows } from "./support/box_with_hole.mjs";
import { generator } from "./support/random.mjs";

test.each(windows)("no place in %s is farther from all sites", (_name, window, holds) => {
  const random = generator(41);
  for (let run = 0; run < 20; ++run) {
    const circles = Array.from({ length: 1 + Math.floor(12 * random()) }, () => [
      140 * random() - 20,
      100 * random() - 20,
      8 * random() ** 2,
    ]);
    const diagram = Diagram.from(circles);
    const { x, y, r, site } = diagram.voronoi(window).largestEmptyCircle();
    let farthest = -Infinity;
    for (let px = 0; px <= 100; px += 0.5)
      for (let py = 0; py <= 60; py += 0.5)
        if (holds(px, py)) farthest = Math.max(farthest, diagram.nearest(px, py).distance);
    expect(r).toBeGreaterThanOrEqual(farthest - 1e-12);
    expect(r).toBeLessThan(farthest + 0.8); // a step of the grid
    expect(r).toBe(diagram.nearest(x, y).distance);
    const [cx, cy, cr] = circles[site];
    expect(Math.hypot(x - cx, y - cy) - cr).toBeCloseTo(r, 9);
    expect(x >= 0 && x <= 100 && y >= 0 && y <= 60).toBe(true);
  }
});

test("of several, none has its centre in one before it, and they come by size", () => {
  const random = generator(42);
  const diagram = Diagram.from(
    Array.from({ length: 60 }, () => [100 * random(), 60 * random(), random()]),
  );
  const view = diagram.voronoi(box);
  const circles = view.emptyCircles(10);
  expect(circles).toHaveLength(10);
  expect(circles[0]).toEqual(view.largestEmptyCircle());
  circles.forEach((one, k) => {
    if (k > 0) expect(one.r).toBeLessThanOrEqual(circles[k - 1].r);
    for (const before of circles.slice(0, k))
      expect(Math.hypot(one.x - before.x, one.y - before.y)).toBeGreaterThanOrEqual(before.r);
  });
  expect(view.emptyCircles(0)).toEqual([]);
  expect(diagram.voronoi(box, { maxDistance: 1 }).emptyCircles(10)).toEqual(circles);
});

test("one site, none, and a window that is covered", () => {
  expect(new Diagram([0, 0, 1]).voronoi(box).largestEmptyCircle()).toEqual({
    x: 100,
    y: 60,
    r: expect.closeTo(Math.hypot(100, 60) - 1, 12),
    site: 0,
  });
  expect(new Diagram().voronoi(box).largestEmptyCircle()).toBe(null);
  expect(new Diagram([50, 30, 99]).voronoi(box).largestEmptyCircle().r).toBeLessThan(0);
  expect(() => new Diagram([0, 0, 1]).voronoi(box).emptyCircles(NaN)).toThrow(
    expect.objectContaining({ code: "not-finite" }),
  );
});
