// A window to draw: a coast and a lake whose corners can be dragged. Cells end at them, and their
// areas add up to the window's.
import { ApolloniusError, Diagram, type Voronoi } from "apollonius-diagram";
import { figure, type Handle, type Said, type Size } from "../figure/figure.js";
import { drawDot, type Pen } from "../figure/pen.js";
import { flat } from "./circles.js";

const kCircles = [
  [112, 106, 40],
  [250, 76, 18],
  [378, 112, 34],
  [66, 238, 12],
  [176, 300, 46],
  [302, 210, 10],
  [404, 262, 22],
  [318, 338, 14],
] as const;

type Corner = [x: number, y: number];
/** Coasts and lakes to begin with, in the unit of the circles. */
const kShapes = {
  island: {
    label: "Island",
    coast: [
      [64, 44],
      [226, 24],
      [438, 66],
      [452, 286],
      [296, 380],
      [96, 354],
      [22, 202],
    ],
    lake: [
      [214, 136],
      [290, 142],
      [272, 224],
      [206, 236],
    ],
  },
  star: {
    label: "Crosses itself",
    coast: [
      [237, 16],
      [362, 384],
      [34, 156],
      [440, 156],
      [112, 384],
    ],
    lake: [
      [30, 40],
      [120, 30],
      [130, 100],
      [50, 110],
    ],
  },
  flat: {
    label: "No inside",
    coast: [
      [40, 330],
      [160, 250],
      [280, 170],
      [400, 90],
    ],
    lake: [
      [100, 290],
      [220, 210],
      [340, 130],
    ],
  },
} as const;
type Shape = keyof typeof kShapes;
const isShape = (name: string): name is Shape => name in kShapes;

type Panel = { x: number; y: number; width: number; height: number };
type State = {
  map: Size;
  list: Panel;
  f: number; // units of the figure in one of the circles'
  shape: Shape;
  coast: Corner[];
  lake: Corner[];
  diagram: Diagram;
  view: Voronoi | null; // null: the window is refused
  refusal: string; // why
};

/** A window without an inside is refused by an error that says why; that is shown. */
function renew(state: State) {
  state.view?.dispose();
  state.view = null;
  state.refusal = "";
  try {
    state.view = state.diagram.voronoi([state.coast, state.lake]);
  } catch (error) {
    if (!(error instanceof ApolloniusError) || error.code !== "bad-bounds") throw error;
    state.refusal = error.message;
  }
}

function setShape(state: State, shape: Shape) {
  const { coast, lake } = kShapes[shape];
  const scaled = (ring: readonly (readonly [number, number])[]) =>
    ring.map(([x, y]): Corner => [x * state.f, y * state.f]);
  Object.assign(state, { shape, coast: scaled(coast), lake: scaled(lake) });
  renew(state);
}

const sumOf = (areas: Float64Array) => areas.reduce((sum, area) => sum + area, 0);
const ringPath = (ring: readonly Corner[]) => `M${ring.join("L")}Z`;

function drawMap(pen: Pen, { view, diagram, coast, lake }: State) {
  if (view) {
    pen.path(view.renderBounds(), "window");
    pen.path(view.render(), "edge");
  } else pen.path(ringPath(coast) + ringPath(lake), "wrong");
  for (const { x, y, r } of diagram) pen.circle(x, y, r, "circle");
  for (const { id, x, y } of diagram) pen.text(String(id), x, y, "name", { align: "middle" });
  for (const [x, y] of [...coast, ...lake]) drawDot(pen, x, y, "bar", 5);
}

function drawAreas(pen: Pen, { view, list }: State) {
  const { x, y, width, height } = list;
  if (!view) {
    pen.text("The window is refused.", x, y + 10, "alarm", { isBold: true });
    return;
  }
  const areas = view.cellAreas();
  const most = Math.max(...areas);
  const row = height / (areas.length + 2.4);
  const bars = x + 18;
  const full = width - 18 - 66;
  const right = x + width;
  for (const [id, area] of areas.entries()) {
    const middle = y + (id + 0.5) * row;
    pen.text(String(id), x, middle, "quiet", { size: 13 });
    pen.rectangle(bars, middle - row / 3, (full * area) / most, (2 * row) / 3, "bar");
    pen.text(area.toFixed(1), right, middle, "name", { size: 13, align: "end" });
  }
  const end = y + (areas.length + 0.3) * row;
  pen.line(x, end, right, end, "frame");
  const totals = [
    ["sum of the cells", sumOf(areas)],
    ["window.area", view.window.area],
  ] as const;
  for (const [k, [name, area]] of totals.entries()) {
    const middle = end + (k + 0.6) * row;
    pen.text(name, x, middle, "quiet", { size: 13 });
    pen.text(area.toFixed(6), right, middle, "name", { size: 13, align: "end", isBold: true });
  }
}

export default figure<State>({
  size: { wide: [740, 400], narrow: [370, 504] },
  start(_, isNarrow) {
    const f = isNarrow ? 0.78 : 1;
    const map: Size = isNarrow ? [370, 312] : [474, 400];
    const list = isNarrow
      ? { x: 16, y: 320, width: 338, height: 176 }
      : { x: 500, y: 28, width: 222, height: 344 };
    const diagram = new Diagram(flat(kCircles).map((value) => value * f));
    const none = { coast: [], lake: [], view: null, refusal: "" };
    const state: State = { map, list, f, shape: "island", diagram, ...none };
    setShape(state, "island");
    return state;
  },
  draw(pen, state) {
    pen.inside(0, 0, ...state.map, () => drawMap(pen, state));
    drawAreas(pen, state);
  },
  code: ({ view }) =>
    `diagram.voronoi([coast, lake]).window.area  // ${view?.window.area ?? "error"}`,
  say({ view, refusal }) {
    if (!view) return [["Refused", "wrong"], `: ${refusal}.`];
    const areas = view.cellAreas();
    const [sum, area] = [sumOf(areas), view.window.area];
    const apart = Math.abs(sum - area) / area;
    const equal: Said =
      apart === 0 ? "to the last bit." : `but for rounding, ${apart.toExponential(0)} of it.`;
    const count = areas.filter((cell) => cell > 0).length;
    return [`${count} cells fill the window: their areas add up to `, `its own, ${equal}`];
  },
  controls: [
    {
      kind: "choice",
      label: "Window",
      options: Object.entries(kShapes).map(([name, { label }]) => [name, label]),
      get: ({ shape }) => shape,
      set: (state, value) => {
        if (isShape(value)) setShape(state, value);
      },
    },
  ],
  handles(state) {
    const [width, height] = state.map;
    const handle = (ring: Corner[], k: number, name: string): Handle => ({
      label: `${name}: corner ${k + 1} of ${ring.length}`,
      x: ring[k][0],
      y: ring[k][1],
      move(x, y) {
        ring[k] = [Math.max(4, Math.min(width - 4, x)), Math.max(4, Math.min(height - 4, y))];
        renew(state);
      },
    });
    return [
      ...state.lake.map((_, k) => handle(state.lake, k, "Lake")),
      ...state.coast.map((_, k) => handle(state.coast, k, "Coast")),
    ];
  },
  circles: ({ diagram }) => diagram.sites().xyr,
});
