// The curves of the page, in numbers: every drawn point is as far from one site as from the other.
import { describe, expect, test } from "@jest/globals";
import { newArc, setBisector, setDualEdge } from "../../web/bisector.js";
import { drawConic, kTolerance } from "../../web/conic.js";
import { generator } from "../../web/random_sets.js";

/** A point of a rational quadratic curve. */
function pointOn({ x0, y0, x1, y1, w, x2, y2 }, t) {
  const a = (1 - t) ** 2;
  const b = 2 * w * t * (1 - t);
  const c = t ** 2;
  return [(a * x0 + b * x1 + c * x2) / (a + b + c), (a * y0 + b * y1 + c * y2) / (a + b + c)];
}

/** Records a path as points on its curves. */
class Recorder {
  points = [];
  curves = 0;
  lineTo(x, y) {
    const [x0, y0] = this.points.at(-1);
    for (let k = 1; k <= 16; k++) this.points.push([x0 + ((x - x0) * k) / 16, y0 + ((y - y0) * k) / 16]);
  }
  bezierCurveTo(a, b, c, d, x, y) {
    const [x0, y0] = this.points.at(-1);
    this.curves++;
    for (let k = 1; k <= 16; k++) {
      const t = k / 16;
      const u = 1 - t;
      const mix = (p, q, r, s) => u ** 3 * p + 3 * u * u * t * q + 3 * u * t * t * r + t ** 3 * s;
      this.points.push([mix(x0, a, c, x), mix(y0, b, d, y)]);
    }
  }
}

function distanceToPolyline([x, y], line) {
  let nearest = Infinity;
  for (let k = 0; k + 1 < line.length; k++) {
    const [ax, ay] = line[k];
    const [bx, by] = line[k + 1];
    const square = (bx - ax) ** 2 + (by - ay) ** 2;
    const u = square > 0 ? Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square)) : 0;
    nearest = Math.min(nearest, Math.hypot(ax + u * (bx - ax) - x, ay + u * (by - ay) - y));
  }
  return nearest;
}

const distance = ([px, py], { x, y, r }) => Math.hypot(px - x, py - y) - r;

/** Two sites, neither covering the other, sometimes nearly so. */
function randomPair(random) {
  const a = { x: 200 * random() - 100, y: 200 * random() - 100, r: 60 * random() };
  const angle = 2 * Math.PI * random();
  const away = 10 ** (4 * random() - 2);
  const r = random() < 0.2 ? a.r : 60 * random();
  const length = Math.abs(a.r - r) + away;
  const b = { x: a.x + length * Math.cos(angle), y: a.y + length * Math.sin(angle), r };
  return random() < 0.5 ? [a, b] : [b, a];
}

const bisector = (a, b, first, second, far) => {
  const arc = newArc();
  return setBisector(arc, a.x, a.y, a.r, b.x, b.y, b.r, first, second, far) ? arc : null;
};

/** On which side of the way from p to q the point is: positive on the left. */
const side = ([px, py], [qx, qy], { x, y }) => (qx - px) * (y - py) - (qy - py) * (x - px);

describe("bisectors", () => {
  test("a whole bisector is equally far from both sites, with the first on the left, up to the distance asked for", () => {
    const random = generator(1);
    for (let k = 0; k < 700; k++) {
      const [a, b] = randomPair(random);
      const arc = bisector(a, b, null, null, 1000);
      expect(arc).not.toBeNull();
      let worst = 0;
      for (let t = 0; t <= 1; t += 1 / 8) {
        const p = pointOn(arc, t);
        worst = Math.max(worst, Math.abs(distance(p, a) - distance(p, b)));
      }
      expect(worst).toBeLessThan(1e-8 * (1000 + arc.w));
      const pole = a.r >= b.r ? a : b;
      expect(Math.hypot(arc.x0 - pole.x, arc.y0 - pole.y)).toBeCloseTo(1000, 4);
      expect(Math.hypot(arc.x2 - pole.x, arc.y2 - pole.y)).toBeCloseTo(1000, 4);
      // At the middle, a is on the left and b on the right of the curve's direction.
      const p = pointOn(arc, 0.5);
      const q = pointOn(arc, 0.5 + 1e-4);
      expect(side(p, q, a)).toBeGreaterThan(side(p, q, b));
    }
  });

  test("a piece between two points of the bisector starts and ends there, and drawn curves stay within the tolerance", () => {
    const random = generator(2);
    let curves = 0;
    for (let k = 0; k < 700; k++) {
      const [a, b] = randomPair(random);
      const whole = bisector(a, b, null, null, 500);
      const [s, t] = [random(), random()].sort();
      const [x0, y0] = pointOn(whole, s);
      const [x2, y2] = pointOn(whole, t);
      if (Math.hypot(x2 - x0, y2 - y0) < 1e-6) continue;
      const arc = bisector(a, b, { x: x0, y: y0 }, { x: x2, y: y2 }, 1e9);
      expect(arc).toMatchObject({ x0, y0, x2, y2 });
      const path = new Recorder();
      path.points.push([x0, y0]);
      drawConic(path, arc.x0, arc.y0, arc.x1, arc.y1, arc.w, arc.x2, arc.y2);
      curves += path.curves;
      // The difference of distances changes by at most 2 per unit of distance to the curve.
      const off = path.points.map((p) => Math.abs(distance(p, a) - distance(p, b)));
      expect(Math.max(...off)).toBeLessThanOrEqual(2 * kTolerance + 1e-6);
    }
    expect(curves).toBeGreaterThan(300);
  });

  test("the tolerance in pixels holds against a fine sampling of the true curve", () => {
    let worst = 0;
    for (const w of [1, 1.2, 1.6, 2, 3, 5, 10, 100, 1e4]) {
      for (const size of [1, 30, 1000]) {
        const arc = { x0: -size, y0: 0, x1: 0.3 * size, y1: size, w, x2: size, y2: 0.2 * size };
        const path = new Recorder();
        path.points.push([arc.x0, arc.y0]);
        drawConic(path, arc.x0, arc.y0, arc.x1, arc.y1, arc.w, arc.x2, arc.y2);
        // More densely where the curve turns: t with t/(1-t) in geometric steps.
        const truth = Array.from({ length: 4001 }, (_, k) => pointOn(arc, 1 / (1 + Math.exp((2000 - k) / 140))));
        truth.unshift([arc.x0, arc.y0]);
        truth.push([arc.x2, arc.y2]);
        for (const p of path.points) worst = Math.max(worst, distanceToPolyline(p, truth));
      }
    }
    expect(worst).toBeLessThanOrEqual(1.05 * kTolerance);
    expect(worst).toBeGreaterThan(0.1 * kTolerance); // the test sees something
  });

  test("covered sites have no bisector; a piece beyond the distance asked for is not drawn", () => {
    expect(bisector({ x: 0, y: 0, r: 5 }, { x: 1, y: 0, r: 2 }, null, null, 100)).toBeNull();
    expect(bisector({ x: 0, y: 0, r: 5 }, { x: 3, y: 0, r: 2 }, null, null, 100)).toBeNull();
    expect(bisector({ x: 0, y: 0, r: 0 }, { x: 300, y: 0, r: 0 }, null, null, 100)).toBeNull();
    const a = { x: 0, y: 0, r: 1 };
    const b = { x: 10, y: 0, r: 1 };
    expect(bisector(a, b, { x: 5, y: 200 }, { x: 5, y: 900 }, 100)).toBeNull();
    expect(bisector(a, b, { x: 5, y: -900 }, { x: 5, y: 0 }, 100).y0).toBeCloseTo(-Math.sqrt(100 ** 2 - 5 ** 2), 9);
  });
});

describe("dual edges", () => {
  test("run from centre to centre along the bisector of the two Voronoi circles", () => {
    const random = generator(3);
    let curved = 0;
    for (let k = 0; k < 500; k++) {
      const [a, b] = randomPair(random);
      const whole = bisector(a, b, null, null, 300);
      const circles = [random(), random()].sort().map((t) => {
        const p = pointOn(whole, t);
        return { x: p[0], y: p[1], r: distance(p, a) };
      });
      const arc = newArc();
      setDualEdge(arc, a.x, a.y, a.r, b.x, b.y, b.r, circles[0], circles[1]);
      expect(arc).toMatchObject({ x0: a.x, y0: a.y, x2: b.x, y2: b.y });
      if (arc.w === 1) continue; // a segment
      curved++;
      for (let t = 0; t <= 1; t += 1 / 8) {
        const p = pointOn(arc, t);
        expect(Math.abs(distance(p, circles[0]) - distance(p, circles[1]))).toBeLessThan(1e-5);
      }
    }
    expect(curved).toBeGreaterThan(250);
  });

  test("are parabolas where one Voronoi circle is a half-plane, segments where both are", () => {
    const random = generator(4);
    for (let k = 0; k < 300; k++) {
      const [a, b] = randomPair(random);
      const whole = bisector(a, b, null, null, 1e7);
      const [x, y] = pointOn(bisector(a, b, null, null, 300), random());
      const circle = { x, y, r: distance([x, y], a) };
      // Beside the half-plane, a circle that is nearly one: the curve must be as far from it, up to the circle's curvature.
      const far = { x: whole.x2, y: whole.y2, r: distance([whole.x2, whole.y2], a) };
      const arc = newArc();
      setDualEdge(arc, a.x, a.y, a.r, b.x, b.y, b.r, circle, null);
      expect(arc).toMatchObject({ x0: a.x, y0: a.y, w: 1, x2: b.x, y2: b.y });
      const size = Math.hypot(arc.x1, arc.y1) + 1000;
      const off = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((t) => {
        const p = pointOn(arc, t / 8);
        return Math.abs(distance(p, circle) - distance(p, far));
      });
      expect(Math.max(...off)).toBeLessThan((size * size) / 5e6);
      setDualEdge(arc, a.x, a.y, a.r, b.x, b.y, b.r, null, null);
      expect(arc).toMatchObject({ x1: (a.x + b.x) / 2, y1: (a.y + b.y) / 2, w: 1 });
    }
  });
});
