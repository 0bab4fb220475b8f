// Random circles whose sizes are spread more and more: how many of them are hidden.
import { Diagram } from "apollonius-diagram";
import { figure, type Size } from "../figure/figure.js";
import type { Pen } from "../figure/pen.js";
import { generator } from "../shared/random_sets.js";

const kCount = 400;
const kCovered = 0.45; // areas of all circles together, as a share of the picture
const kSpreads = 31; // places of the curve
const kMost = 2; // spread: standard deviation of the logarithm of a radius

type Panel = { x: number; y: number; width: number; height: number };
type State = {
  picture: Panel;
  curve: Panel;
  places: Float64Array; // x, y and a normal deviate of each circle
  shares: number[]; // hidden ones, by spread
  spread: number;
  xyr: Float64Array;
  diagram: Diagram;
};

/** Places in a unit square, and numbers that are normally distributed (Box and Muller). */
function randomPlaces() {
  const random = generator(7);
  const places = new Float64Array(3 * kCount);
  for (let k = 0; k < places.length; k += 3) {
    const z = Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
    places.set([random(), random(), z], k);
  }
  return places;
}

/** Radii are multiplied by e^(spread z), and all of them such that the sum of areas is the same. */
function circlesOf(places: Float64Array, spread: number, { x, y, width, height }: Panel) {
  const xyr = new Float64Array(places.length);
  let area = 0;
  for (let k = 0; k < xyr.length; k += 3) {
    xyr[k] = x + width * places[k];
    xyr[k + 1] = y + height * places[k + 1];
    xyr[k + 2] = Math.exp(spread * places[k + 2]);
    area += Math.PI * xyr[k + 2] ** 2;
  }
  const factor = Math.sqrt((kCovered * width * height) / area);
  for (let k = 2; k < xyr.length; k += 3) xyr[k] *= factor;
  return xyr;
}

function setSpread(state: State, spread: number) {
  state.spread = spread;
  state.xyr = circlesOf(state.places, spread, state.picture);
  state.diagram.dispose();
  state.diagram = new Diagram(state.xyr);
}

/** The radius that a tenth of the circles exceed, divided by that which a tenth do not reach. */
function ratioOf({ xyr }: State) {
  const radii = xyr.filter((_, k) => k % 3 === 2).sort();
  return radii[Math.floor(0.9 * kCount)] / radii[Math.floor(0.1 * kCount)];
}

const ratioText = (ratio: number) => ratio.toFixed(ratio < 10 ? 1 : 0);
const percent = (share: number) => `${Math.round(100 * share)} %`;

function drawCurve(pen: Pen, state: State) {
  const { curve, shares, spread, diagram } = state;
  const top = Math.ceil(10 * Math.max(...shares)) / 10;
  const left = (value: number) => curve.x + (curve.width * value) / kMost;
  const up = (share: number) => curve.y + curve.height * (1 - share / top);
  for (const share of [0, top / 2, top]) {
    pen.line(curve.x, up(share), curve.x + curve.width, up(share), "frame");
    pen.text(percent(share), curve.x - 8, up(share), "quiet", { size: 12, align: "end" });
  }
  const points = shares.map((share, k) => `${left((kMost * k) / (kSpreads - 1))},${up(share)}`);
  pen.path(`M${points.join("L")}`, "hiddenLine");
  const share = diagram.hiddenSize / kCount;
  pen.line(left(spread), up(0), left(spread), up(share), "hiddenLine");
  pen.circle(left(spread), up(share), 5, "hiddenDot");
  const align = spread > 0.2 * kMost ? "end" : "start"; // the curve rises
  const x = left(spread) - (align === "end" ? 4 : 0);
  pen.text(percent(share), x, up(share) - 14, "hiddenDot", { align, isBold: true });
  pen.text("hidden", curve.x, curve.y - 20, "quiet", { size: 13 });
  const end = { size: 12, align: "end" } as const;
  pen.text("all equal", curve.x, curve.y + curve.height + 16, "quiet", { size: 12 });
  pen.text("unequal", curve.x + curve.width, curve.y + curve.height + 16, "quiet", end);
}

export default figure<State>({
  size: { wide: [740, 380], narrow: [370, 480] },
  start(_: Size, isNarrow) {
    const picture = isNarrow
      ? { x: 0, y: 0, width: 370, height: 300 }
      : { x: 0, y: 0, width: 450, height: 380 };
    const curve = isNarrow
      ? { x: 54, y: 344, width: 296, height: 100 }
      : { x: 514, y: 70, width: 200, height: 250 };
    const places = randomPlaces();
    const shares = Array.from({ length: kSpreads }, (_, k) => {
      using diagram = new Diagram(circlesOf(places, (kMost * k) / (kSpreads - 1), picture));
      return diagram.hiddenSize / kCount;
    });
    const [xyr, diagram] = [new Float64Array(), new Diagram()];
    const state = { picture, curve, places, shares, spread: 0, xyr, diagram };
    setSpread(state, 0.9);
    return state;
  },
  draw(pen, state) {
    const { x, y, width, height } = state.picture;
    const { diagram, xyr } = state;
    pen.inside(x, y, width, height, () => {
      pen.path(diagram.voronoi([0, 0, width, height]).render(null, { digits: 1 }), "quietEdge");
      for (let id = 0; id < kCount; id++) {
        const isHidden = diagram.isHidden(id);
        const look = isHidden ? "hiddenSolid" : "circle";
        pen.circle(xyr[3 * id], xyr[3 * id + 1], xyr[3 * id + 2], look);
      }
    });
    pen.line(x + width, y, x + width, y + height, "frame");
    drawCurve(pen, state);
  },
  say(state) {
    const { hiddenSize } = state.diagram;
    const many: [string, "hidden"] = [`${hiddenSize} of ${kCount}`, "hidden"];
    const ratio = ratioOf(state);
    if (ratio === 1) return ["All circles are equal: ", many, " are hidden."];
    const times = ratioText(ratio);
    const are = hiddenSize === 1 ? "circles is" : "circles are";
    return [many, ` ${are} hidden where large ones have ${times} times the radius of small ones.`];
  },
  controls: [
    {
      kind: "slider",
      label: "Spread of sizes",
      min: 0,
      max: kMost,
      step: 0.02,
      get: ({ spread }) => spread,
      set: setSpread,
      show(state) {
        const ratio = ratioOf(state);
        return ratio === 1 ? "equal" : `${ratioText(ratio)} : 1`;
      },
    },
  ],
  circles: ({ xyr }) => xyr,
});
