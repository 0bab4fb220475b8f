// One set of circles twice, under one pointer: in the first picture the nearest centre is picked,
// in the second the circle under the pointer, else the nearest one, as `pick` does. Where they
// differ is computed, not drawn by hand.
import { Diagram } from "apollonius-diagram";
import { figure, type Point } from "../figure/figure.js";
import { drawPointer, type Pen } from "../figure/pen.js";
import { flat, kBubbles } from "./circles.js";

/** Width and height of each picture; on a phone, whose first screen holds both, parts of them. */
const kWide = [360, 360] as const;
const kNarrow = [212, 262] as const;
const kTitle = 26; // height of the title above each picture
const kGap = 20;
const kStep = 3; // units between the places that are asked
const kPause = 2.2; // seconds at each place
const kTravel = 1.1; // seconds on the way
const kLeg = kPause + kTravel;

type State = {
  centres: Diagram;
  circles: Diagram;
  size: readonly [number, number]; // of each picture
  shares: { inside: number; all: number }; // of places where the pick is wrong
  tour: Point[]; // where the ghost pointer goes, once: wrong picks and a right one
  time: number; // seconds of the tour
  at: Point;
  isLed: boolean; // by the reader
};

/** Where the picks differ: their shares, and the worst place: in one circle, another one picked. */
function compare(centres: Diagram, circles: Diagram, [width, height]: State["size"]) {
  const places: number[] = [];
  for (let y = kStep / 2; y < height; y += kStep)
    for (let x = kStep / 2; x < width; x += kStep) places.push(x, y);
  const xy = Float64Array.from(places);
  const byCentre = centres.findMany(xy);
  const picks = circles.pickMany(xy);
  const distance = (id: number, k: number) => {
    const { x, y, r } = circles.site(id);
    return Math.hypot(xy[2 * k] - x, xy[2 * k + 1] - y) - r;
  };
  let [inside, wrong, wrongInside] = [0, 0, 0];
  let worst: Point = [0, 0];
  let most = -Infinity;
  for (const [k, id] of byCentre.entries()) {
    const own = distance(picks[k], k);
    if (own <= 0) inside++;
    if (id === picks[k]) continue;
    wrong++;
    if (own <= 0) wrongInside++;
    const miss = distance(id, k) + 2 * Math.min(0, -own - 14);
    if (miss > most) [most, worst] = [miss, [xy[2 * k], xy[2 * k + 1]]];
  }
  return { shares: { inside: wrongInside / inside, all: wrong / byCentre.length }, worst };
}

/** The circle that each picture lights up. */
const chosenIn = ({ centres, circles, at }: State) => ({
  byCentre: centres.find(...at),
  byCircle: circles.pick(...at),
});

function drawSide(pen: Pen, state: State, isCentres: boolean) {
  const { centres, circles, at, size } = state;
  const { byCentre, byCircle } = chosenIn(state);
  const chosen = isCentres ? byCentre : byCircle;
  const isWrong = chosen !== byCircle;
  const view = (isCentres ? centres : circles).voronoi([0, 0, ...size]);
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
  pen.rectangle(0, 0, ...size, "frame");
}

/** Where the second picture begins. */
const secondOf = ([width]: State["size"]) => width + kGap;

function drawPicture(pen: Pen, state: State, isCentres: boolean) {
  const x = isCentres ? 0 : secondOf(state.size);
  const title = isCentres ? "Nearest centre" : "Nearest circle";
  pen.text(title, x + 10, kTitle / 2, isCentres ? "quiet" : "name", { size: 13, isBold: true });
  pen.inside(x, kTitle, ...state.size, () => drawSide(pen, state, isCentres));
}

const sizeOf = ([width, height]: State["size"]): [number, number] => [
  2 * width + kGap,
  kTitle + height,
];

export default figure<State>({
  size: { wide: sizeOf(kWide), narrow: sizeOf(kNarrow) },
  start(_, isNarrow) {
    const circles = new Diagram(flat(kBubbles));
    const centres = new Diagram(flat(kBubbles.map(([x, y]) => [x, y, 0])));
    const size = isNarrow ? kNarrow : kWide;
    const { shares, worst } = compare(centres, circles, size);
    const tour: Point[] = [worst, [60, 150], [200, 92], worst];
    return { centres, circles, size, shares, tour, time: 0, at: worst, isLed: false };
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
    const [width, height] = state.size;
    const second = secondOf(state.size);
    const inSide = (value: number, side: number) => Math.max(0, Math.min(side, value));
    const x = at[0] < second ? at[0] : at[0] - second;
    state.at = [inSide(x, width), inSide(at[1] - kTitle, height)];
  },
  draw(pen, state) {
    drawPicture(pen, state, true);
    drawPicture(pen, state, false);
  },
  say(state) {
    const { byCentre, byCircle } = chosenIn(state);
    const { inside, all } = state.shares;
    const percent = (share: number) => `${Math.round(100 * share)} %`;
    return [
      byCentre !== byCircle
        ? ["Nearest centre picks the wrong bubble here. ", "wrong"]
        : "Here both pick the same bubble. ",
      "Picking by centre is wrong on ",
      [percent(inside), "wrong"],
      " of the bubbles’ area, and on ",
      [percent(all), "wrong"],
      " of the whole picture.",
    ];
  },
  circles: () => flat(kBubbles),
});
