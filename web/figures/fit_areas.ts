// Six cells in a rectangle, and a bar for each one's share of it. Weights are found with which each
// cell has exactly that share.
import { Diagram, type FittedAreas } from "apollonius-diagram";
import { figure, type Handle, type Size } from "../figure/figure.js";
import { drawDot, type Pen } from "../figure/pen.js";

const kMost = 60; // parts that a bar can say
const kApart = 14; // units that centres keep away from each other
const kEdge = 12; // units that they keep away from the frame
const kNames = ["A", "B", "C", "D", "E", "F"];
const kPlaces = [
  [0.18, 0.26],
  [0.5, 0.2],
  [0.82, 0.3],
  [0.24, 0.74],
  [0.56, 0.62],
  [0.84, 0.78],
];
const kParts = [10, 24, 6, 16, 40, 4];

type Place = { x: number; y: number };
type Box = { left: number; top: number; width: number; height: number };
type State = {
  field: Size; // the rectangle of the cells, from 0, 0
  chart: Box; // of the bars
  places: Place[];
  parts: number[];
  diagram: Diagram;
  fitted: FittedAreas;
};

/** Weights for the state as it is; from those of before it takes two or three steps. */
function weighted(state: Pick<State, "places" | "parts" | "field">, start?: Float64Array) {
  const diagram = new Diagram(state.places.flatMap(({ x, y }) => [x, y, 0]));
  const fitted = diagram.voronoi([0, 0, ...state.field]).fitAreas(state.parts, { start });
  if (!fitted) throw new Error("nobody stops it");
  return { diagram, fitted };
}

function change(state: State) {
  const { diagram } = state;
  Object.assign(state, weighted(state, state.fitted.weights));
  diagram.dispose();
}

const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0);
const between = (low: number, value: number, high: number) => Math.max(low, Math.min(high, value));
const barTop = ({ chart }: State, parts: number) => chart.top + chart.height * (1 - parts / kMost);
const barMiddle = ({ chart }: State, k: number) =>
  chart.left + ((k + 0.5) * chart.width) / kNames.length;

function drawCells(pen: Pen, { diagram, field, places }: State) {
  const view = diagram.voronoi([0, 0, ...field]);
  const areas = view.cellAreas();
  pen.path(view.render(), "edge");
  const least = Math.min(...Array.from(diagram, ({ r }) => r));
  pen.inside(0, 0, ...field, () => {
    // A common summand changes nothing: the smallest circle is a dot.
    for (const { x, y, r } of diagram) pen.circle(x, y, r - least + 3, "circle");
  });
  for (const [k, { x, y }] of places.entries()) {
    const percent = `${((100 * areas[k]) / (field[0] * field[1])).toFixed(4)} %`;
    drawDot(pen, x, y, "centre", 3);
    pen.text(kNames[k], x, y - 14 / pen.scale, "name", { align: "middle", isBold: true });
    pen.text(percent, x, y + 15 / pen.scale, "name", { align: "middle", size: 13 });
  }
  pen.rectangle(0, 0, ...field, "frame");
}

function drawBars(pen: Pen, state: State) {
  const { chart, parts } = state;
  const bottom = chart.top + chart.height;
  const width = (0.6 * chart.width) / kNames.length;
  for (const [k, value] of parts.entries()) {
    const [x, y] = [barMiddle(state, k), barTop(state, value)];
    const share = `${((100 * value) / sum(parts)).toFixed(0)} %`;
    pen.rectangle(x - width / 2, y, width, bottom - y, "bar");
    pen.line(x - width / 2, y, x + width / 2, y, "pointer");
    pen.text(share, x, y - 12 / pen.scale, "name", { align: "middle", size: 12 });
    pen.text(kNames[k], x, bottom + 14 / pen.scale, "name", { align: "middle", isBold: true });
  }
  pen.line(chart.left, bottom, chart.left + chart.width, bottom, "edge");
}

export default figure<State>({
  size: { wide: [740, 380], narrow: [370, 520] },
  start(_, isNarrow) {
    const field: Size = isNarrow ? [368, 290] : [480, 380];
    const chart = isNarrow
      ? { left: 15, top: 330, width: 340, height: 155 }
      : { left: 505, top: 40, width: 225, height: 305 };
    const places = kPlaces.map(([x, y]) => ({ x: x * field[0], y: y * field[1] }));
    const parts = [...kParts];
    return { field, chart, places, parts, ...weighted({ field, places, parts }) };
  },
  draw(pen, state) {
    drawCells(pen, state);
    drawBars(pen, state);
  },
  say({ fitted }) {
    return [
      `After ${fitted.iterations} steps, the largest error of an area is `,
      [fitted.error.toExponential(0), "neighbor"],
      fitted.converged ? " of its share (target: 1e-6)." : ": rounding allows no less here.",
    ];
  },
  handles(state) {
    const { places, parts, field } = state;
    const bars = parts.map((value, k): Handle => {
      return {
        label: `Share of ${kNames[k]}: ${((100 * value) / sum(parts)).toFixed(1)} percent`,
        x: barMiddle(state, k),
        y: barTop(state, value),
        move(_, y) {
          const wanted = kMost * (1 - (y - state.chart.top) / state.chart.height);
          parts[k] = between(1, wanted, kMost);
          change(state);
        },
      };
    });
    const centres = places.map((place, k): Handle => {
      return {
        label: `Centre of ${kNames[k]}: move it`,
        ...place,
        move(x, y) {
          const to = {
            x: between(kEdge, x, field[0] - kEdge),
            y: between(kEdge, y, field[1] - kEdge),
          };
          const isNear = (other: Place, i: number) =>
            i !== k && Math.hypot(other.x - to.x, other.y - to.y) < kApart;
          if (places.some(isNear)) return;
          Object.assign(place, to);
          change(state);
        },
      };
    });
    return [...bars, ...centres];
  },
  controls: [
    {
      kind: "button",
      label: "Equal shares",
      act(state) {
        state.parts.fill(20);
        change(state);
      },
    },
    {
      kind: "button",
      label: "One part to A, sixty to F",
      act(state) {
        state.parts.splice(0, 6, 1, 12, 12, 12, 12, 60);
        change(state);
      },
    },
  ],
  circles: ({ diagram }) => diagram.sites().xyr,
});
