// The largest circles inside cells, and inside windows: against JTS, and against trying all places.
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import { Diagram } from "../../build/packed/consumer.mjs";
import { isThorough } from "../support/effort.mjs";
import { box, windows, withHole } from "./support/box_with_hole.mjs";
import { generator } from "./support/random.mjs";
import { scribble } from "./support/refusals.mjs";

const { default: MaximumInscribedCircle } = await import(
  "jsts/org/locationtech/jts/algorithm/construct/MaximumInscribedCircle.js"
);

const kEnough = 0.999;
/** Rounding of coordinates up to 100. */
const kRounding = 1e-12;

const randomSites = (random, count, heaviest = 8) =>
  Array.from({ length: count }, () => [
    140 * random() - 20,
    100 * random() - 20,
    heaviest * random() ** 2,
  ]);

/** Points of an ellipse that is `aspect` times as wide as high, a little smaller. */
const pointsOf = ({ x, y, r }, aspect = 1) =>
  Array.from({ length: 90 }, (_, k) => {
    const [c, s] = [Math.cos((k * Math.PI) / 45), Math.sin((k * Math.PI) / 45)];
    return [x + r * aspect * (1 - 1e-9) * c, y + r * (1 - 1e-9) * s];
  });

/** Is the ellipse in the cell, as far as its points tell? */
function expectInside(diagram, view, holds, id, circle, aspect) {
  for (const [x, y] of pointsOf(circle, aspect)) {
    expect(holds(x, y) && view.window.contains(x, y)).toBe(true);
    const { x: cx, y: cy, r } = diagram.site(id);
    expect(Math.hypot(x - cx, y - cy) - r - diagram.nearest(x, y).distance).toBeLessThan(kRounding);
  }
}

/** JTS's largest circle in a polygon, of which it knows the radius to the tolerance. */
function ofJTS(coordinates, tolerance) {
  const polygon = new GeoJSONReader().read({ type: "MultiPolygon", coordinates });
  return new MaximumInscribedCircle(polygon, tolerance).getRadiusLine().getLength();
}

describe.each(windows)("the largest circle in a cell, in %s", (_name, window, holds) => {
  test("is inside, and as large as JTS finds it", () => {
    const random = generator(81);
    for (let run = 0; run < 5; ++run) {
      const diagram = Diagram.from(randomSites(random, 1 + run ** 2));
      const view = diagram.voronoi(window);
      const circles = view.cellCircles();
      for (const id of diagram.ids()) {
        const circle = view.cellCircle(id);
        if (circle === null) {
          expect(circles.subarray(3 * id, 3 * id + 3)).toEqual(new Float64Array(3).fill(NaN));
          expect(view.cellArea(id) || null).toBeNull();
          continue;
        }
        expect(Array.from(circles.subarray(3 * id, 3 * id + 3))).toEqual(Object.values(circle));
        expectInside(diagram, view, holds, id, circle);
        const parts = view.cellParts(id, { tolerance: 1e-5 });
        if (parts === null) continue; // too thin for a polygon
        const coordinates = parts;
        const found = ofJTS(coordinates, 1e-3 * circle.r);
        expect(circle.r).toBeGreaterThan(kEnough * found - 1e-5);
        expect(circle.r).toBeLessThan(found + 1e-3 * circle.r + 1e-5);
      }
    }
  });

  test("with an aspect, is the largest ellipse: no place of a grid has a larger one", () => {
    const random = generator(82);
    for (const aspect of [0.25, 3]) {
      const diagram = Diagram.from(randomSites(random, 12));
      const view = diagram.voronoi(window);
      for (const id of diagram.ids()) {
        const circle = view.cellCircle(id, { aspect });
        if (circle === null) continue;
        expectInside(diagram, view, holds, id, circle, aspect);
        const larger = circle.r / kEnough + 1e-9;
        const isCell = ([x, y]) =>
          x >= 0 && x <= 100 && y >= 0 && y <= 60 && holds(x, y) && diagram.find(x, y) === id;
        for (let x = 0; x <= 100; x += 2)
          for (let y = 0; y <= 60; y += 2) {
            if (!isCell([x, y])) continue;
            expect(pointsOf({ x, y, r: larger }, aspect).every(isCell)).toBe(false);
          }
      }
    }
  });

  test("ends where a cell's distance does", () => {
    const diagram = Diagram.from([
      [30, 10, 2],
      [80, 40, 1],
    ]);
    const view = diagram.voronoi(window, { maxDistance: 5 });
    const { x, y, r } = view.cellCircle(0);
    expect(r).toBeGreaterThan(kEnough * 7);
    expect(r).toBeLessThanOrEqual(7);
    expect(Math.hypot(x - 30, y - 10)).toBeLessThan(0.01);
  });
});

test("of shapes that are known", () => {
  const one = new Diagram([0, 0, 0]);
  const of = (window, options) => one.voronoi(window).cellCircle(0, options);
  expect(of([0, 0, 4, 4])).toEqual({ x: 2, y: 2, r: 2 });
  const { r } = of([
    [0, 0],
    [1, 0],
    [0, 1],
  ]);
  expect(r / (1 / (2 + Math.SQRT2))).toBeGreaterThan(kEnough);
  expect(r).toBeLessThan(1 / (2 + Math.SQRT2));
  expect(of([0, 0, 6, 1], { aspect: 3 }).r).toBeCloseTo(0.5, 12);
  expect(of([0, 0, 6, 6], { aspect: 3 }).r).toBeCloseTo(1, 12);
  // Corridors, along which all places are as good, in any direction; and as thin as doubles are.
  for (const turn of [0, 0.6, 2]) {
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    for (const length of [10, 1e4]) {
      const corridor = [
        [0, 0],
        [length, 0],
        [length, 1],
        [0, 1],
      ].map(([x, y]) => [c * x - s * y, s * x + c * y]);
      const circle = of(corridor);
      expect(circle.r).toBeGreaterThan(kEnough / 2);
      expect(circle.r).toBeLessThan(0.5 + 1e-9);
    }
  }
  expect(of([0, 1, 1, 1 + 2 ** -52]).r).toBeLessThan(2 ** -52);
  for (const size of [1e-90, 1e90])
    expect(of([0, 0, size, 3 * size]).r / (size / 2)).toBeCloseTo(1, 9);
});

test("of strips, slivers and cells of all sizes, moved far from the origin", () => {
  for (const [dx, dy] of [
    [0, 0],
    [1e9, -1e9],
  ]) {
    const row = Array.from({ length: 50 }, (_, k) => [dx + 2 * k, dy + 2 * k, 0]);
    const strips = Diagram.from(row).voronoi([dx - 100, dy - 100, dx + 200, dy + 200]);
    for (let id = 1; id < 49; ++id) {
      expect(strips.cellCircle(id).r / Math.SQRT2).toBeGreaterThan(kEnough);
      expect(strips.cellCircle(id).r / Math.SQRT2).toBeLessThan(1 + 1e-7);
    }
    // A site that its neighbour nearly covers has a cell like a needle.
    for (const rest of [1e-1, 1e-3, 1e-6]) {
      const pair = new Diagram([dx, dy, 10, dx + 9 + rest, dy, 1]);
      const view = pair.voronoi([dx - 100, dy - 100, dx + 100, dy + 100]);
      const circle = view.cellCircle(1);
      expect(circle.r).toBeGreaterThan(0);
      for (const [x, y] of pointsOf(circle)) {
        const [near, far] = [0, 1].map((id) => {
          const { x: cx, y: cy, r } = pair.site(id);
          return Math.hypot(x - cx, y - cy) - r;
        });
        expect(far - near).toBeLessThan(dx === 0 ? 1e-9 : 1e-6);
      }
    }
  }
});

// Each took minutes, or all of the memory: boxes had to be as small as the domain is thin.
describe("domains that are thin, at any angle", () => {
  const one = new Diagram([0, 0, 0]);
  /** A window that is thin along y = 0.37 x. */
  const strip = (width) => [
    [0, 0],
    [1, 0.37],
    [1, 0.37 + width],
    [0, width],
  ];
  const halfWidth = (width) => width / 2 / Math.hypot(1, 0.37);
  const sliver = (width) => [
    [0, 0],
    [1, 1 / 3],
    [2, 2 / 3 + width],
  ];
  const widths = [1e-3, 1e-6, 1e-9, 1e-12];
  /** Compares numbers that are rounded to 2^-52. */
  const expectAbout = (r, expected) => {
    expect(r / expected).toBeGreaterThan(kEnough - 1e-15 / expected);
    expect(r / expected).toBeLessThan(1 + 1e-9 + 1e-15 / expected);
  };

  test.each(widths)("a strip, a sliver and strips side by side, %d wide", (width) => {
    expectAbout(one.voronoi(strip(width)).cellCircle(0).r, halfWidth(width));
    const { r } = one.voronoi(sliver(width)).cellCircle(0);
    expectAbout(r, 0.2371708 * width);
    const many = Array.from({ length: 6 }, (_, k) =>
      strip((1 + k / 10) * width).map(([x, y]) => [x, y + 3 * k * width]),
    );
    expectAbout(one.voronoi(many).cellCircle(0).r, halfWidth(1.5 * width));
    const fan = [0, 2, 4].map((k) => [
      [0, 0],
      [1, 0.37 + k * width],
      [1, 0.37 + (k + 1) * width],
    ]);
    expect(one.voronoi(fan).cellCircle(0).r).toBeGreaterThan(kEnough * 0.46 * width - 1e-15);
  });

  test.each(widths)("empty circles inside them, %d wide", (width) => {
    const far = new Diagram([0.2, 0, 0, 5, 5, 0.1]);
    const inside = { inside: true };
    expectAbout(far.voronoi(sliver(width)).largestEmptyCircle(inside).r, 0.2371708 * width);
    expectAbout(far.voronoi(strip(width)).largestEmptyCircle(inside).r, halfWidth(width));
  });

  test.each(widths)("a ring of sixty sides, %d wide", (width) => {
    const ring = (radius) =>
      Array.from({ length: 60 }, (_, k) => [
        radius * Math.cos((k * Math.PI) / 30),
        radius * Math.sin((k * Math.PI) / 30),
      ]);
    const { r } = one.voronoi([ring(1), ring(1 - width)]).cellCircle(0);
    expect(r / (width / 2)).toBeGreaterThan(kEnough - 1e-15 / width);
    expect(r / (width / 2)).toBeLessThan(1 + 1e-15 / width);
  });

  test.each(widths)("the cell of a circle that a larger one covers but for %d", (rest) => {
    const [c, s] = [Math.cos(1), Math.sin(1)];
    const pair = new Diagram([0, 0, 10, (9 + rest) * c, (9 + rest) * s, 1]);
    const circle = pair.voronoi([-1e3, -1e3, 1e3, 1e3]).cellCircle(1);
    expect(circle.r).toBeGreaterThan(0);
    for (const [x, y] of pointsOf(circle))
      expect(Math.hypot(x - (9 + rest) * c, y - (9 + rest) * s) - 1).toBeLessThan(
        Math.hypot(x, y) - 10 + 1e-9,
      );
  });

  test("what doubles do not tell apart is refused", () => {
    expect(() => one.voronoi(scribble).cellCircle(0)).toThrow(
      expect.objectContaining({ code: "no-convergence" }),
    );
  });
});

test("cellCirclesAsync says what cellCircles says", async () => {
  const random = generator(88);
  const diagram = Diagram.from(randomSites(random, 300, 3));
  for (const { maxDistance } of [{}, { maxDistance: 4 }, { maxDistance: (id) => id % 7 }]) {
    const view = diagram.voronoi([0, 0, 100, 60], { maxDistance });
    const told = [];
    const options = { aspect: 2, onProgress: (share) => told.push(share) };
    expect(await view.cellCirclesAsync(options)).toEqual(view.cellCircles({ aspect: 2 }));
    expect([...told].sort((a, b) => a - b)).toEqual(told);
    expect(told.at(-1)).toBe(1);
  }
  const reason = new Error("enough");
  const aborted = diagram.voronoi().cellCirclesAsync({ signal: AbortSignal.abort(reason) });
  await expect(aborted).rejects.toBe(reason);
});

// All distances grow to the side of a cell's box, and beyond it.
test("of sites on a circle about the window's corner", () => {
  const sites = Array.from({ length: 150 }, (_, k) => [Math.cos(k), Math.sin(k), 0]);
  for (const off of [0, 9776.994645557248]) {
    const window = [
      [0, 0],
      [1, 0.3],
      [1, 1.2],
      [0, 0.9],
    ].map(([x, y]) => [off + x, off + y]);
    const diagram = Diagram.from(sites.map(([x, y, r]) => [off + x, off + y, r]));
    const { r } = diagram.voronoi(window).largestEmptyCircle({ inside: true });
    let most = 0;
    for (let x = 0; x <= 1; x += 0.01)
      for (let y = 0; y <= 1.2; y += 0.01) {
        const room =
          y > 0.3 * x && y < 0.9 + 0.3 * x ? borderDistance(window, off + x, off + y) : 0;
        most = Math.max(most, Math.min(room, diagram.nearest(off + x, off + y).distance));
      }
    expect(r).toBeGreaterThan(kEnough * most);
    expect(r).toBeLessThan(most + 0.02);
  }
});

test("of all kinds of scenes, in a moment, and no place of any is better", () => {
  const random = generator(86);
  for (let run = 0; run < (isThorough ? 48 : 16); ++run) {
    const scale = 10 ** Math.floor(8 * random() - 4);
    const off = random() < 0.3 ? 1e6 * random() : 0;
    const kind = run % 4;
    const at = (value) => off + scale * value;
    const sites = Array.from({ length: 1 + Math.floor(20 * random()) }, (_, k) => {
      if (kind === 0) return [at(random()), at(random()), 0.3 * scale * random() ** 3];
      if (kind === 1) return [9, 9, 2].map((n) => Math.round(n * random())).map(at);
      if (kind === 2) return [at(k / 10), at(0.07 * k), 1e-3 * scale * random()];
      return [at(random() * 10 ** (-9 * random())), at(random() * 10 ** (-9 * random())), 0];
    });
    const window =
      random() < 0.5
        ? [at(-1), at(-1), at(2), at(2)]
        : Array.from({ length: 3 + Math.floor(6 * random()) }, () => [
            at(3 * random() - 1),
            at(3 * random() - 1),
          ]);
    const diagram = Diagram.from(kind === 1 ? sites.map(([x, y, r]) => [x, y, r - off]) : sites);
    const view = diagram.voronoi(window);
    const circles = view.cellCircles();
    const empty = view.largestEmptyCircle({ inside: true });
    const grain = 1e-13 * (scale + off);
    for (let k = 0; k < 40; ++k) {
      const [x, y] = [at(3 * random() - 1), at(3 * random() - 1)];
      if (!view.window.contains(x, y)) continue;
      const id = diagram.find(x, y);
      // Half of how much farther the next cell is: less than the way to its border.
      const [, next] = diagram.kNearest(x, y, sites.length).filter((one) => !diagram.isHidden(one));
      const distance = (site) => {
        const { x: cx, y: cy, r } = diagram.site(site);
        return Math.hypot(x - cx, y - cy) - r;
      };
      const border = borderDistance(window, x, y);
      const room = next === undefined ? Infinity : (distance(next) - distance(id)) / 2;
      expect(circles[3 * id + 2]).toBeGreaterThan(kEnough * Math.min(room, border) - grain);
      expect(empty.r).toBeGreaterThan(kEnough * Math.min(distance(id), border) - grain);
    }
    diagram.dispose();
  }
});

/** Distance to the border of bounds, or of a ring. */
function borderDistance(window, x, y) {
  const [xmin, ymin, xmax, ymax] = window;
  const ring = Array.isArray(xmin)
    ? window
    : [
        [xmin, ymin],
        [xmax, ymin],
        [xmax, ymax],
        [xmin, ymax],
      ];
  return Math.min(
    ...ring.map(([ax, ay], k) => {
      const [bx, by] = ring[(k + 1) % ring.length];
      const [dx, dy] = [bx - ax, by - ay];
      const t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
      const s = Math.min(1, Math.max(0, t));
      return Math.hypot(x - ax - s * dx, y - ay - s * dy);
    }),
  );
}

describe.each(windows)("the largest empty circle inside %s", (_name, window, holds) => {
  const rings = window === box ? withHole.slice(0, 1) : withHole;
  const border = (x, y) => Math.min(...rings.map((ring) => borderDistance(ring, x, y)));
  const room = (diagram, x, y) => Math.min(diagram.nearest(x, y).distance, border(x, y));

  test("no place is farther from all sites and the border", () => {
    const random = generator(83);
    for (let run = 0; run < 10; ++run) {
      const diagram = Diagram.from(randomSites(random, 1 + Math.floor(12 * random())));
      const circle = diagram.voronoi(window).largestEmptyCircle({ inside: true });
      const { x, y, r, site } = circle;
      expect(r).toBeCloseTo(room(diagram, x, y), 9);
      expect(holds(x, y)).toBe(true);
      const { x: cx, y: cy, r: cr } = diagram.site(site);
      expect(Math.hypot(x - cx, y - cy) - cr).toBeCloseTo(diagram.nearest(x, y).distance, 9);
      let most = -Infinity;
      for (let px = 0; px <= 100; px += 0.7)
        for (let py = 0; py <= 60; py += 0.7)
          if (holds(px, py)) most = Math.max(most, room(diagram, px, py));
      expect(kEnough * most).toBeLessThan(Math.max(r, 0));
    }
  });

  test("of several, none has its centre in one before it, and they come by size", () => {
    const random = generator(84);
    const diagram = Diagram.from(randomSites(random, 60, 1));
    const view = diagram.voronoi(window);
    const circles = view.emptyCircles(15, { inside: true });
    expect(circles).toHaveLength(15);
    expect(circles[0]).toEqual(view.largestEmptyCircle({ inside: true }));
    circles.forEach((one, k) => {
      expect(one.r).toBeCloseTo(room(diagram, one.x, one.y), 9);
      if (k > 0) expect(one.r).toBeLessThanOrEqual(circles[k - 1].r);
      for (const before of circles.slice(0, k))
        expect(Math.hypot(one.x - before.x, one.y - before.y)).toBeGreaterThanOrEqual(before.r);
    });
    // Those of all places that are as large as these are among them: vertices far from the border.
    const whole = view.emptyCircles(1000).filter(({ x, y, r }) => border(x, y) >= r);
    for (const { x, y, r } of whole.filter(({ r }) => r > circles.at(-1).r)) {
      const isCovered = ({ x: cx, y: cy, r: cr }) =>
        cr >= r * kEnough && Math.hypot(cx - x, cy - y) <= cr;
      expect(circles.some(isCovered)).toBe(true);
    }
    expect(view.emptyCircles(0, { inside: true })).toEqual([]);
    expect(diagram.voronoi(window, { maxDistance: 1 }).emptyCircles(15, { inside: true })).toEqual(
      circles,
    );
  });

  test("one site, none, and a window that is covered", () => {
    const inside = { inside: true };
    expect(new Diagram().voronoi(window).largestEmptyCircle(inside)).toBeNull();
    const { r } = new Diagram([-500, 30, 1]).voronoi(box).largestEmptyCircle(inside);
    expect(r).toBeGreaterThan(kEnough * 30);
    expect(r).toBeLessThanOrEqual(30);
    const covered = new Diagram([50, 30, 99]).voronoi(window).largestEmptyCircle(inside);
    expect(covered.r).toBeLessThan(0);
  });
});

test("what is refused", () => {
  const view = new Diagram([0, 0, 1]).voronoi(box);
  const code = (expected) => expect.objectContaining({ code: expected });
  expect(() => view.cellCircle(1)).toThrow(code("unknown-site"));
  expect(() => view.cellCircle(0, { aspect: 0 })).toThrow(code("out-of-range"));
  expect(() => view.cellCircle(0, { aspect: NaN })).toThrow(code("not-finite"));
  expect(() => view.cellCircles({ aspekt: 2 })).toThrow(code("bad-option"));
  expect(() => view.largestEmptyCircle({ inside: 1 })).toThrow(code("bad-option"));
  expect(() => view.emptyCircles(2, { within: true })).toThrow(code("bad-option"));
});
