// A country divided among hospitals, to each as much land as it has beds, step by step. Country and
// beds are invented.
import { Diagram } from "apollonius-diagram";
import { figure, type Point, type Size } from "../figure/figure.js";
import { drawDot, drawPointer, type Pen } from "../figure/pen.js";

const kCoast = [
  [40, 90],
  [120, 40],
  [230, 66],
  [330, 24],
  [450, 50],
  [560, 30],
  [660, 80],
  [712, 170],
  [690, 260],
  [716, 340],
  [640, 410],
  [540, 388],
  [450, 424],
  [350, 392],
  [300, 330],
  [230, 366],
  [140, 410],
  [60, 360],
  [28, 270],
  [70, 190],
] as const;
/** x, y, beds. */
const kHospitals = [
  [110, 110, 900],
  [205, 130, 240],
  [130, 230, 420],
  [90, 320, 160],
  [190, 330, 610],
  [290, 100, 330],
  [310, 230, 180],
  [390, 120, 1250],
  [400, 320, 280],
  [480, 220, 150],
  [520, 90, 380],
  [560, 330, 720],
  [610, 170, 210],
  [650, 260, 140],
  [640, 120, 330],
] as const;
const kBeds = kHospitals.map(([, , beds]) => beds);
const kAllBeds = kBeds.reduce((sum, beds) => sum + beds, 0);
const kStepTime = 1.1; // seconds
const kGood = 0.01; // an area is right to the eye
const kDecades = 8; // of the chart, from 1e-7 to 10

type State = {
  isNarrow: boolean;
  coast: [number, number][];
  places: Point[];
  /** Weights after each step; those of step 0 are equal. */
  steps: Float64Array[];
  errors: number[];
  at: number; // steps done; between two of them while it plays
  isPlaying: boolean;
  pointer: Point | null;
};

const diagramOf = (places: readonly Point[], weights: Float64Array) =>
  new Diagram(places.flatMap(([x, y], k) => [x, y, weights[k]]));

/** The weights of each step: fitAreas ends at the tolerance, so it is asked for each. */
function stepsOf(places: readonly Point[], coast: readonly [number, number][]) {
  const equal = new Float64Array(places.length);
  const diagram = diagramOf(places, equal);
  const errors: number[] = [];
  const onIteration = ({ error }: { error: number }) => {
    errors.push(error);
  };
  diagram.voronoi([coast]).fitAreas(kBeds, { onIteration });
  const better = errors.filter((error, k) => errors.slice(0, k).every((other) => other > error));
  const steps = better.map((tolerance) => {
    const fitted = diagramOf(places, equal).voronoi([coast]).fitAreas(kBeds, { tolerance });
    return fitted.weights;
  });
  return { steps: [equal, ...steps], better };
}

/** Each cell's land, as a multiple of what its beds ask for. */
function landOf({ places, coast, steps, at }: State) {
  const [before, after] = [steps[Math.floor(at)], steps[Math.ceil(at)]];
  const weights = before.map((weight, k) => weight + (at % 1) * (after[k] - weight));
  const diagram = diagramOf(places, weights);
  const view = diagram.voronoi([coast]);
  const shares = Array.from(
    view.cellAreas(),
    (area, k) => (area * kAllBeds) / (view.window.area * kBeds[k]),
  );
  return { diagram, view, shares };
}

const largest = (shares: readonly number[]) =>
  Math.max(...shares.map((share) => Math.abs(share - 1)));
const brief = (error: number) => (error < 0.001 ? error.toExponential(0) : error.toPrecision(2));

function drawSteps(pen: Pen, { errors, at, isNarrow }: State) {
  const [left, top, width] = isNarrow ? [14, 538, 342] : [558, 60, 172];
  const row = isNarrow ? 22 : 34;
  pen.text("Largest error, step by step", left, top, "name", { size: 13, isBold: true });
  for (const [k, error] of errors.entries()) {
    const y = top + (k + 1) * row;
    const reach = (Math.max(0, Math.log10(error) + kDecades - 1) / kDecades) * (width - 75);
    const isDone = k <= at;
    pen.text(String(k), left, y, isDone ? "name" : "quiet", { size: 13 });
    pen.rectangle(left + 18, y - 7, Math.max(reach, 1.5), 14, isDone ? "bar" : "frame");
    if (isDone) pen.text(brief(error), left + 24 + reach, y, "name", { size: 13 });
  }
}

export default figure<State>({
  size: { wide: [740, 360], narrow: [370, 680] },
  start(_: Size, isNarrow) {
    const turn = ([x, y]: readonly number[]): [number, number] =>
      isNarrow ? [y * 0.72 + 22, x * 0.72] : [x * 0.77 - 12, y * 0.77 + 8];
    const coast = kCoast.map(turn);
    const places = kHospitals.map(turn);
    const { steps, better } = stepsOf(places, coast);
    const state: State = {
      isNarrow,
      coast,
      places,
      steps,
      errors: [],
      at: 0,
      isPlaying: false,
      pointer: null,
    };
    state.errors = [largest(landOf(state).shares), ...better];
    return state;
  },
  draw(pen, state) {
    const { diagram, view, shares } = landOf(state);
    pen.path(view.renderBounds(), "window");
    for (const [k, share] of shares.entries())
      if (Math.abs(share - 1) >= kGood) pen.path(view.renderCell(k), "wrongArea");
    if (state.pointer) pen.path(view.renderCell(diagram.find(...state.pointer)), "nearestCell");
    pen.path(view.render(), "edge");
    for (const [k, [x, y]] of state.places.entries()) {
      drawDot(pen, x, y, "centre", 3);
      const [up, down] = [y - 12 / pen.scale, y + 13 / pen.scale];
      pen.text(String(kBeds[k]), x, up, "name", { align: "middle", size: 12, isBold: true });
      const look = Math.abs(shares[k] - 1) < kGood ? "ok" : "name";
      pen.text(`× ${shares[k].toFixed(2)}`, x, down, look, { align: "middle", size: 12 });
    }
    drawSteps(pen, state);
    if (state.pointer) drawPointer(pen, ...state.pointer);
  },
  say(state) {
    const { diagram, shares } = landOf(state);
    const step = Math.round(state.at);
    if (state.pointer) {
      const k = diagram.find(...state.pointer);
      const { r } = diagram.site(k);
      return [
        [`${kBeds[k]} beds`, "nearest"],
        `, land ${shares[k].toFixed(4)} times its share, head start ${r.toFixed(0)}.`,
      ];
    }
    const wrong = shares.filter((share) => Math.abs(share - 1) >= kGood).length;
    if (wrong === 0)
      return [`Step ${step}: each has its share, to ${brief(largest(shares))} of it.`];
    return [
      `${step === 0 ? "Nearest hospital, no head starts" : `Step ${step}`}: `,
      [`${wrong} of ${shares.length}`, "wrong"],
      " have too much land for their beds, or too little.",
    ];
  },
  tick(state, seconds) {
    if (!state.isPlaying) return false;
    const last = state.steps.length - 1;
    state.at = Math.min(last, state.at + seconds / kStepTime);
    state.isPlaying = state.at < last;
    return true;
  },
  hover(state, at) {
    const isInMap = at && diagramOf(state.places, state.steps[0]).voronoi([state.coast]).window;
    state.pointer = at && isInMap?.contains(...at) ? at : null;
  },
  controls: [
    {
      kind: "slider",
      label: "Step",
      min: 0,
      max: 5,
      step: 1,
      get: ({ at }) => Math.round(at),
      set(state, value) {
        state.at = Math.min(value, state.steps.length - 1);
        state.isPlaying = false;
      },
    },
    {
      kind: "button",
      label: ({ isPlaying }) => (isPlaying ? "Stop" : "Play"),
      act(state) {
        state.isPlaying = !state.isPlaying;
        const last = state.steps.length - 1;
        if (state.isPlaying && state.at === last) state.at = 0;
        if (!state.isPlaying) state.at = Math.round(state.at);
      },
    },
  ],
  circles: (state) => landOf(state).diagram.sites().xyr,
});
