// One set of circles twice, under one pointer: in the first picture the nearest centre is picked,
// in the second the nearest circle. Where they differ is computed, not drawn by hand.
import { Diagram } from "apollonius-diagram";
import { figure, type Point } from "../figure/figure.js";
import { drawPointer, type Pen } from "../figure/pen.js";
import { flat, kBubbles } from "./circles.js";

const kSide = 360; // of each picture
const kGap = 24;
const kStep = 3; // units between the places that are asked
const kPause = 2.2; // seconds at each place
const kTravel = 1.1; // seconds on the way
const kLeg = kPause + kTravel;

type State = {
  centres: Diagram;
  circles: Diagram;
  right: Point; // where the second picture begins
  share: number; // of places where the pick is wrong
  tour: Point[]; // where the ghost pointer goes, once: wrong picks and a right one
  time: number; // seconds of the tour
  at: Point;
  isLed: boolean; // by the reader
};

const windowOf = (): [number, number, number, number] => [0, 0, kSide, kSide];

/** Where the picks differ: their share, and the worst place: in one circle, another one picked. */
function compare(centres: Diagram, circles: Diagram) {
  const places: number[] = [];
  for (let y = kStep / 2; y < kSide; y += kStep)
    for (let x = kStep / 2; x < kSide; x += kStep) places.push(x, y);
  const xy = Float64Array.from(places);
  const picked = centres.findMany(xy);
  const { ids: nearest, distances } = circles.nearestMany(xy);
  let wrong = 0;
  let worst: Point = [0, 0];
  let most = -Infinity;
  for (const [k, id] of picked.entries()) {
    if (id === nearest[k]) continue;
    wrong++;
    const { x, y, r } = circles.site(id);
    const miss =
      Math.hypot(xy[2 * k] - x, xy[2 * k + 1] - y) - r + 2 * Math.min(0, -distances[k] - 14);
    if (miss > most) [most, worst] = [miss, [xy[2 * k], xy[2 * k + 1]]];
  }
  return { share: wrong / picked.length, worst };
}

function drawSide(pen: Pen, { circles, at }: State, picked: Diagram, isCentres: boolean) {
  const chosen = picked.find(...at);
  const isWrong = chosen !== circles.find(...at);
  const view = picked.voronoi(windowOf());
  pen.path(view.renderCell(chosen), isWrong ? "wrongArea" : "nearestCell");
  for (const [id, [x, y, r]] of kBubbles.entries())
    pen.circle(x, y, r, id !== chosen ? "circle" : isWrong ? "wrong" : "nearest");
  pen.path(view.render(), isCentres ? "centreEdge" : "edge");
  if (isCentres) for (const [x, y] of kBubbles) pen.circle(x, y, 1.8, "centre");
  const { x, y, r } = circles.site(chosen);
  const length = Math.hypot(x - at[0], y - at[1]) || 1;
  const stop = isCentres ? 1 : Math.max(0, 1 - r / length);
  pen.line(
    ...at,
    at[0] + stop * (x - at[0]),
    at[1] + stop * (y - at[1]),
    isWrong ? "conflict" : "ruler",
  );
  drawPointer(pen, ...at);
  pen.rectangle(0, 0, kSide, kSide, "frame");
}

export default figure<State>({
  size: { wide: [2 * kSide + kGap, kSide], narrow: [kSide, 2 * kSide + kGap] },
  start(_, isNarrow) {
    const circles = new Diagram(flat(kBubbles));
    const centres = new Diagram(flat(kBubbles.map(([x, y]) => [x, y, 0])));
    const { share, worst } = compare(centres, circles);
    const right: Point = isNarrow ? [0, kSide + kGap] : [kSide + kGap, 0];
    const tour: Point[] = [worst, [60, 150], [225, 92], worst];
    return { centres, circles, right, share, tour, time: 0, at: worst, isLed: false };
  },
  tick(state, seconds, isReduced) {
    if (isReduced || state.isLed) return false;
    const end = kLeg * (state.tour.length - 1);
    state.time = Math.min(state.time + seconds, end);
    const leg = Math.floor(state.time / kLeg);
    const t = Math.max(0, (state.time - leg * kLeg - kPause) / kTravel);
    const eased = t * t * (3 - 2 * t);
    const [from, to = from] = state.tour.slice(leg);
    state.at = [from[0] + eased * (to[0] - from[0]), from[1] + eased * (to[1] - from[1])];
    return state.time < end;
  },
  hover(state, at) {
    state.isLed = at !== null;
    if (!at) return;
    state.time = 0; // it sets out again when the reader has left
    const [dx, dy] = state.right;
    const isRight = at[0] >= dx && at[1] >= dy;
    const inSide = (value: number) => Math.max(0, Math.min(kSide, value));
    state.at = [inSide(at[0] - (isRight ? dx : 0)), inSide(at[1] - (isRight ? dy : 0))];
  },
  draw(pen, state) {
    pen.inside(0, 0, kSide, kSide, () => drawSide(pen, state, state.centres, true));
    pen.inside(...state.right, kSide, kSide, () => drawSide(pen, state, state.circles, false));
  },
  say({ centres, circles, at, share }) {
    const isWrong = centres.find(...at) !== circles.find(...at);
    const percent = `${Math.round(100 * share)} %`;
    return [
      isWrong
        ? ["Nearest centre picks the wrong bubble here. ", "wrong"]
        : "Here both pick the same circle. ",
      "Picking by centre is wrong on ",
      [percent, "wrong"],
      " of this picture.",
    ];
  },
  circles: () => flat(kBubbles),
});
