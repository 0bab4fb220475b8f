// Two circles to drag and to resize, the boundary between them, and two rulers from a place on it.
import { Diagram } from "apollonius-diagram";
import { figure, type Handle, type Point, type Size } from "../figure/figure.js";
import { drawDot, type Pen } from "../figure/pen.js";

type Circle = { x: number; y: number; r: number };
type State = { size: Size; circles: [Circle, Circle]; along: number };

const kLeast = 4; // units of a radius
const kNames = ["The blue circle", "The other circle"];

const inside = (value: number, most: number) => Math.max(8, Math.min(most - 8, value));

const diagramOf = ({ circles }: State) =>
  new Diagram(Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r])));

/** The place on the boundary that the smaller circle sees in direction `along`; null if none. */
function placeOf({ circles, along }: State): Point | null {
  const [small, large] = circles[0].r < circles[1].r ? circles : [circles[1], circles[0]];
  const [dx, dy] = [large.x - small.x, large.y - small.y];
  const distance = Math.hypot(dx, dy);
  const more = large.r - small.r;
  if (distance <= more) return null; // the small one is hidden
  // |p - small| = t and |p - large| = t + more, on a ray from the small centre that is turned away
  // from the large one by `along`.
  const [ax, ay] = [Math.cos(along), Math.sin(along)];
  const [ux, uy] = [dx / distance, dy / distance];
  const t = (distance ** 2 - more ** 2) / (2 * (more + distance * ax));
  if (!(t > 0)) return null;
  return [small.x + t * (ax * ux - ay * uy), small.y + t * (ax * uy + ay * ux)];
}

function drawRuler(pen: Pen, { x, y, r }: Circle, at: Point, isFirst: boolean) {
  const distance = Math.hypot(at[0] - x, at[1] - y);
  const share = distance > 0 ? r / distance : 0;
  const look = isFirst ? "ruler" : "otherRuler";
  const [rimX, rimY] = [x + share * (at[0] - x), y + share * (at[1] - y)];
  pen.line(rimX, rimY, ...at, look);
  const middle: Point = [(rimX + at[0]) / 2, (rimY + at[1]) / 2];
  const label = `${isFirst ? "d₁" : "d₂"} = ${Math.abs(distance - r).toFixed(0)}`;
  pen.text(label, middle[0], middle[1] - 14 / pen.scale, "name", { align: "middle", isBold: true });
}

export default figure<State>({
  size: { wide: [740, 380], narrow: [360, 320] },
  start(size, isNarrow) {
    const f = isNarrow ? 0.52 : 1;
    const circles: [Circle, Circle] = [
      { x: 250 * f, y: size[1] / 2, r: 92 * f },
      { x: 510 * f, y: size[1] / 2 - 10, r: 36 * f },
    ];
    return { size, circles, along: 0.75 };
  },
  draw(pen, state) {
    const diagram = diagramOf(state);
    const hidden = [0, 1].find((id) => diagram.isHidden(id));
    const [width, height] = state.size;
    pen.path(diagram.voronoi([0, 0, width, height]).render(), "strongEdge");
    for (const [id, { x, y, r }] of state.circles.entries()) {
      pen.circle(x, y, r, id === hidden ? "hidden" : "circle");
      drawDot(pen, x, y, "centre", 2.5);
      drawDot(pen, x + r, y, "bar", 5);
    }
    const at = hidden === undefined ? placeOf(state) : null;
    if (!at) return;
    state.circles.forEach((circle, k) => {
      drawRuler(pen, circle, at, k === 0);
    });
    drawDot(pen, ...at, "centre", 5);
  },
  say(state) {
    const diagram = diagramOf(state);
    const hidden = [0, 1].find((id) => diagram.isHidden(id));
    if (hidden !== undefined)
      return [
        "The smaller circle is ",
        ["hidden", "hidden"],
        ": from every place, the larger rim is nearer.",
      ];
    const { circles } = state;
    if (Math.abs(circles[0].r - circles[1].r) < 1)
      return ["Equal radii: the boundary is a straight line, as between two centres."];
    return [
      "d₁ = d₂ on the whole boundary: a branch of a hyperbola, bent around the smaller circle.",
    ];
  },
  controls: [
    {
      kind: "slider",
      label: "Along the boundary",
      min: -1.4,
      max: 1.4,
      step: 0.01,
      get: (state) => state.along,
      set: (state, value) => {
        state.along = value;
      },
      show: () => "",
    },
    {
      kind: "button",
      label: "Equal radii",
      act: ({ circles }) => {
        circles[1].r = circles[0].r;
      },
    },
    {
      kind: "button",
      label: "One inside the other",
      act: ({ circles: [first, second] }) => {
        second.r = Math.min(second.r, first.r / 2);
        second.x = first.x + first.r / 4;
        second.y = first.y + first.r / 5;
      },
    },
  ],
  handles({ circles, size }) {
    const centres: Handle[] = circles.map((circle, k) => ({
      label: `${kNames[k]}: move it`,
      x: circle.x,
      y: circle.y,
      r: 0.8 * circle.r,
      move(x, y) {
        circle.x = inside(x, size[0]);
        circle.y = inside(y, size[1]);
      },
    }));
    const rims: Handle[] = circles.map((circle, k) => ({
      label: `${kNames[k]}: its radius, ${Math.round(circle.r)}`,
      x: circle.x + circle.r,
      y: circle.y,
      move(x) {
        circle.r = Math.max(kLeast, Math.min(size[0] / 2, x - circle.x));
      },
    }));
    return [...centres, ...rims];
  },
  circles: ({ circles }) => circles.flatMap(({ x, y, r }) => [x, y, r]),
});
