// The poster is seen before the playground's scripts have come: the set that it opens with, drawn
// where the site is built, across a wide window and upright for a tall one.
import { Diagram } from "apollonius-diagram";
import type { Pen } from "../figure/pen.js";
import type { Triple } from "./model/circle.js";
import { kOpening } from "./sets/opening.js";

const kFar = 1200; // units around the set, which a window of any shape shows
const kUp = 600; // what the set's y is flipped at (sets/presets.ts)

function poster(circles: readonly Triple[]) {
  const box = circles.reduce(
    ([left, top, right, bottom], [x, y, r]) => [
      Math.min(left, x - r),
      Math.min(top, y - r),
      Math.max(right, x + r),
      Math.max(bottom, y + r),
    ],
    [Infinity, Infinity, -Infinity, -Infinity],
  );
  const [left, top, right, bottom] = box;
  const moved = circles.map(([x, y, r]): Triple => [x - left, y - top, r]);
  return {
    size: [right - left, bottom - top] as const,
    draw(pen: Pen) {
      const diagram = new Diagram(Float64Array.from(moved.flat()));
      const window: [number, number, number, number] = [-kFar, -kFar, right + kFar, bottom + kFar];
      pen.path(diagram.voronoi(window).render(), "edge");
      for (const [id, [x, y, r]] of moved.entries())
        pen.circle(x, y, r, diagram.isHidden(id) ? "hidden" : "circle");
    },
  };
}

export const wide = poster(kOpening);
export const tall = poster(kOpening.map(([x, y, r]): Triple => [kUp - y, -x, r]));
