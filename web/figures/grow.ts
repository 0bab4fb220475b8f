// All circles grow at one speed and stop where they meet: cells cut at a distance.
import { curvePoint, Diagram } from "apollonius-diagram";
import { figure, type Size } from "../figure/figure.js";
import { flat } from "./circles.js";

const kMost = 130; // units that circles grow by
const kSteps = 12; // lines that a curve is drawn by
const kSpeed = 32; // units a second
const kCircles = [
  [90, 100, 46],
  [210, 62, 14],
  [330, 130, 60],
  [486, 70, 24],
  [610, 120, 40],
  [690, 250, 16],
  [560, 260, 52],
  [430, 230, 10],
  [300, 300, 30],
  [170, 250, 56],
  [50, 280, 12],
  [410, 345, 20],
  [690, 30, 10],
  [240, 185, 7],
  [650, 350, 26],
  [60, 190, 8],
] as const;

type State = {
  diagram: Diagram;
  circles: readonly (readonly number[])[];
  size: Size;
  distance: number;
  isGrowing: boolean;
};

/** The lines where circles have met: the Voronoi edges, without the arcs of circles that grow. */
function seamsOf(grown: ReturnType<Diagram["voronoi"]>): string {
  const { curves } = grown.edgeCurves();
  let path = "";
  for (let k = 0; k < curves.length / 7; k++)
    for (let step = 0; step <= kSteps; step++)
      path += `${step === 0 ? "M" : "L"}${curvePoint(curves, k, step / kSteps).join()}`;
  return path;
}

export default figure<State>({
  size: { wide: [740, 380], narrow: [370, 420] },
  start(size, isNarrow) {
    const circles = isNarrow
      ? kCircles.map(([x, y, r]) => [y * 0.97, x * 0.56, r * 0.66])
      : kCircles;
    return { diagram: new Diagram(flat(circles)), circles, size, distance: 22, isGrowing: false };
  },
  draw(pen, { diagram, circles, size, distance }) {
    const grown = diagram.voronoi([0, 0, ...size], { maxDistance: distance });
    for (const path of grown.renderCells()) if (path) pen.path(path, "circle");
    for (const [x, y, r] of circles) pen.circle(x, y, r, "rim");
    pen.path(seamsOf(grown), "strongEdge");
  },
  say({ diagram, size, distance }) {
    const covered = diagram.voronoi([0, 0, ...size], { maxDistance: distance }).cellAreas();
    const share = covered.reduce((sum, area) => sum + area, 0) / (size[0] * size[1]);
    return [
      `Grown by ${distance.toFixed(0)}: `,
      [`${(100 * Math.min(share, 1)).toFixed(share < 0.995 ? 0 : 1)} % `, "neighbor"],
      share < 0.999
        ? "of the picture is reached."
        : "of the picture is reached. The seams are the diagram.",
    ];
  },
  tick(state, seconds) {
    if (!state.isGrowing) return false;
    state.distance = Math.min(kMost, state.distance + kSpeed * seconds);
    state.isGrowing = state.distance < kMost;
    return true;
  },
  controls: [
    {
      kind: "slider",
      label: "Grown by",
      min: 0,
      max: kMost,
      step: 1,
      get: ({ distance }) => Math.round(distance),
      set: (state, value) => {
        state.distance = value;
        state.isGrowing = false;
      },
    },
    {
      kind: "button",
      label: ({ isGrowing }) => (isGrowing ? "Stop" : "Grow"),
      act: (state) => {
        state.isGrowing = !state.isGrowing;
        if (state.isGrowing && state.distance >= kMost) state.distance = 0;
      },
    },
  ],
  circles: ({ circles }) => flat(circles),
});
