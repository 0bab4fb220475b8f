// One set of circles, inserted in two orders: on the way the diagrams differ, at the end not in one
// edge, although the circles are on a grid, where many edges could be chosen in two ways.
import { Diagram } from "apollonius-diagram";
import { figure, type Said, type Size } from "../figure/figure.js";
import type { Pen } from "../figure/pen.js";
import { generator } from "../shared/random_sets.js";
import { differing, edgeNames } from "./graphs.js";

const kColumns = 6;
const kRows = 4;
const kCount = kColumns * kRows;
const kSide: Size = [350, 236]; // of each picture
const kGap = 30;
const kSpacing = 57;
const kRadius = 13;
const kSpeed = 4; // circles a second

type State = {
  right: readonly [number, number]; // where the second picture begins
  seed: number;
  orders: [number[], number[]]; // places on the grid
  inserted: number;
  tried: number;
  different: number; // pairs of orders with another graph at the end
  isGoing: boolean;
  time: number;
};

const centreOf = (place: number): [number, number] => [
  kSide[0] / 2 + ((place % kColumns) - (kColumns - 1) / 2) * kSpacing,
  kSide[1] / 2 + (Math.floor(place / kColumns) - (kRows - 1) / 2) * kSpacing,
];

function shuffled(seed: number) {
  const random = generator(seed);
  const places = Array.from({ length: kCount }, (_, k) => k);
  for (let k = kCount - 1; k > 0; k--) {
    const other = Math.floor(random() * (k + 1));
    [places[k], places[other]] = [places[other], places[k]];
  }
  return places;
}

/** The diagram of the first places of an order, inserted one by one. */
function inserted(order: readonly number[], count: number) {
  const diagram = new Diagram();
  for (const place of order.slice(0, count)) diagram.insert(...centreOf(place), kRadius);
  return diagram;
}

const edgesOf = (order: readonly number[], count: number) =>
  edgeNames(inserted(order, count), (id) => order[id]);

function take(state: State, seed: number) {
  state.seed = seed;
  state.orders = [shuffled(2 * seed), shuffled(2 * seed + 1)];
  state.tried++;
  const [a, b] = state.orders.map((order) => edgesOf(order, kCount));
  if (differing(a, b) > 0) state.different++;
}

/** Edges whose two ends are at one place. */
function lengthless(diagram: Diagram) {
  const { vertices } = diagram.edges();
  const { xy } = diagram.vertices();
  let count = 0;
  for (let k = 0; k < vertices.length; k += 2) {
    const [a, b] = [2 * vertices[k], 2 * vertices[k + 1]];
    const isOne = xy[a] === xy[b] && xy[a + 1] === xy[b + 1];
    if (a >= 0 && b >= 0 && isOne) count++;
  }
  return count;
}

function drawSide(pen: Pen, order: readonly number[], count: number, others: readonly string[]) {
  const diagram = inserted(order, count);
  const known = new Set(others);
  pen.path(diagram.voronoi([0, 0, ...kSide]).render(), "edge");
  for (const edge of edgeNames(diagram, (id) => order[id])) {
    const [a, b] = edge.split(" ").map(Number);
    pen.line(...centreOf(a), ...centreOf(b), known.has(edge) ? "dual" : "partEdge");
  }
  for (let place = 0; place < kCount; place++) {
    const [x, y] = centreOf(place);
    const at = order.indexOf(place);
    if (at >= count) {
      pen.circle(x, y, kRadius, "frame");
      continue;
    }
    pen.circle(x, y, kRadius, "paper");
    pen.circle(x, y, kRadius, at === count - 1 && count < kCount ? "added" : "circle");
    pen.text(String(at + 1), x, y, "name", { align: "middle", size: 12 });
  }
  pen.rectangle(0, 0, ...kSide, "frame");
}

export default figure<State>({
  size: {
    wide: [2 * kSide[0] + kGap + 10, kSide[1] + 10],
    narrow: [kSide[0] + 10, 2 * kSide[1] + kGap],
  },
  start(_, isNarrow) {
    const state: State = {
      right: isNarrow ? [5, kSide[1] + kGap - 5] : [kSide[0] + kGap + 5, 5],
      seed: 0,
      orders: [[], []],
      inserted: 11,
      tried: 0,
      different: 0,
      isGoing: false,
      time: 0,
    };
    take(state, 1);
    return state;
  },
  draw(pen, { right, orders: [a, b], inserted: count }) {
    pen.inside(5, 5, ...kSide, () => drawSide(pen, a, count, edgesOf(b, count)));
    pen.inside(...right, ...kSide, () => drawSide(pen, b, count, edgesOf(a, count)));
  },
  say({ orders, inserted: count, tried, different }): Said[] {
    const [a, b] = orders.map((order) => edgesOf(order, count));
    const unlike = differing(a, b);
    const common = (a.length + b.length - unlike) / 2;
    if (count < kCount)
      return [
        `${count} of ${kCount} circles: ${a.length} edges left, ${b.length} right, `,
        [`${common} in common`, "dual"],
        ".",
      ];
    const free = lengthless(inserted(orders[0], count));
    return [
      unlike === 0
        ? [`All ${common} edges are the same`, "dual"]
        : [`${unlike} edges differ`, "wrong"],
      `; ${free} of them have the length 0, and only a rule can choose them. `,
      `Tried ${tried === 1 ? "1 pair" : `${tried} pairs`} of orders: `,
      different === 0 ? "always the same." : `${different} differ.`,
    ];
  },
  tick(state, seconds) {
    if (!state.isGoing) return false;
    state.time += kSpeed * seconds;
    const steps = Math.floor(state.time);
    state.time -= steps;
    state.inserted = Math.min(kCount, state.inserted + steps);
    state.isGoing = state.inserted < kCount;
    return true;
  },
  controls: [
    {
      kind: "slider",
      label: "Inserted",
      min: 1,
      max: kCount,
      step: 1,
      get: ({ inserted: count }) => count,
      set: (state, value) => {
        state.inserted = value;
        state.isGoing = false;
      },
    },
    {
      kind: "button",
      label: ({ isGoing }) => (isGoing ? "Stop" : "Insert all"),
      act: (state) => {
        state.isGoing = !state.isGoing;
        if (state.isGoing && state.inserted === kCount) state.inserted = 1;
      },
    },
    { kind: "button", label: "Other orders", act: (state) => take(state, state.seed + 1) },
  ],
  circles: ({ orders }) => orders[0].flatMap((place) => [...centreOf(place), kRadius]),
});
