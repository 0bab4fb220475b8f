// Shared by the figures of insertion and deletion: the walk to the nearest circle, and the parts of
// a diagram's edges where a circle would be nearer than those that the edges belong to.
import { curvePoint, type Diagram } from "apollonius-diagram";
import type { Control, Size } from "../figure/figure.js";
import { randomCircles } from "../shared/random_sets.js";

export type Circle = { x: number; y: number; r: number };

export const distanceTo = ({ x, y, r }: Circle, px: number, py: number) =>
  Math.hypot(x - px, y - py) - r;

type Stepped = { step: number };

/** The step of a figure that is told in steps, for the paragraphs beside it. */
export const kStepping = {
  get: ({ step }: Stepped) => step,
  set: (state: Stepped, step: number) => {
    state.step = step;
  },
};

/** Chooses a step by hand. @param names of the steps */
export const stepChoice = (names: readonly string[]): Control<Stepped> => ({
  kind: "choice",
  label: "Step",
  options: names.map((name, k) => [String(k), name] as const),
  get: ({ step }) => String(step),
  set: (state, value) => {
    state.step = Number(value);
  },
});

/** Random circles that keep their distance from the sides. */
export function someCircles(count: number, seed: number, [width, height]: Size): Circle[] {
  const xyr = randomCircles({
    count,
    hiddenShare: 0,
    seed,
    width: width - 60,
    height: height - 60,
  });
  return Array.from({ length: count }, (_, k) => ({
    x: xyr[3 * k] + 30,
    y: xyr[3 * k + 1] + 30,
    r: 0.62 * xyr[3 * k + 2] + 3,
  }));
}

export const triples = (circles: readonly Circle[]) =>
  Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r]));

/** The circles that a search meets: from each to its nearest neighbour, while that is nearer. */
export function walk(diagram: Diagram, x: number, y: number, start: number) {
  const distance = (id: number) => distanceTo(diagram.site(id), x, y);
  const path = [start];
  for (let at = start; ; ) {
    let best = at;
    for (const id of diagram.neighbors(at)) if (distance(id) < distance(best)) best = id;
    if (best === at) return path;
    path.push(best);
    at = best;
  }
}

/** The vertices, as rows of `vertices()`, whose empty circles a circle reaches into. */
export function conflicts(diagram: Diagram, circle: Circle) {
  const { xy, clearance } = diagram.vertices();
  return Array.from(clearance, (r, k) => ({ x: xy[2 * k], y: xy[2 * k + 1], r }))
    .filter(({ x, y, r }) => distanceTo(circle, x, y) < r)
    .sort((a, b) => distanceTo(circle, a.x, a.y) - a.r - distanceTo(circle, b.x, b.y) + b.r);
}

const kSamples = 40; // on each edge
const kHalvings = 20; // to where the circle begins to be nearer

/** The edges in a window, cut where a circle begins to be nearer: SVG paths of both parts. */
export function cutEdges(diagram: Diagram, [width, height]: Size, circle: Circle) {
  const { curves, sites } = diagram.voronoi([0, 0, width, height]).edgeCurves();
  const parts = { lost: "", kept: "" };
  for (let k = 0; 7 * k < curves.length; k++) {
    const site = diagram.site(sites[2 * k]);
    const at = (t: number) => curvePoint(curves, k, t);
    const isLost = ([x, y]: readonly [number, number]) =>
      distanceTo(circle, x, y) < distanceTo(site, x, y);
    const border = (from: number, to: number) => {
      const wasLost = isLost(at(from));
      for (let n = 0; n < kHalvings; n++) {
        const middle = (from + to) / 2;
        if (isLost(at(middle)) === wasLost) from = middle;
        else to = middle;
      }
      return at(from);
    };
    let was = isLost(at(0));
    let path = `M${at(0)}`;
    for (let n = 1; n <= kSamples; n++) {
      const point = at(n / kSamples);
      const is = isLost(point);
      if (is !== was) {
        const end = border((n - 1) / kSamples, n / kSamples);
        parts[was ? "lost" : "kept"] += `${path}L${end}`;
        path = `M${end}`;
        was = is;
      }
      path += `L${point}`;
    }
    parts[was ? "lost" : "kept"] += path;
  }
  return parts;
}
