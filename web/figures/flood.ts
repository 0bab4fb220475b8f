// Each pixel asks for its nearest circle, all of them in one call, and that is measured.
import { Diagram } from "apollonius-diagram";
import { figure, type Size } from "../figure/figure.js";
import type { Pen, Pixels } from "../figure/pen.js";
import { generator } from "../shared/random_sets.js";

const kMost = 4.3; // log10 of the number of circles: 20 000
const kCovered = 0.3; // areas of all circles, as a share of the picture
const kRims = 600; // circles of which rims are drawn
const kShades = [0.12, 0.24, 0.36, 0.48, 0.6]; // of colour on paper
const kTones = ["site", "dual", "vertex"] as const; // neither orange nor red

type State = {
  size: Size;
  columns: number;
  rows: number;
  count: number;
  xyr: Float64Array;
  diagram: Diagram;
  pixels: Float64Array; // x, y of each
  ids: Int32Array; // of the nearest circle of each pixel
  milliseconds: number;
};

/** The call that is measured. */
function ask(state: State) {
  const start = performance.now();
  state.ids = state.diagram.findMany(state.pixels);
  state.milliseconds = performance.now() - start;
}

function setCount(state: State, count: number) {
  const [width, height] = state.size;
  const random = generator(11);
  const mean = Math.sqrt((kCovered * width * height) / (Math.PI * count));
  const xyr = new Float64Array(3 * count);
  for (let k = 0; k < xyr.length; k += 3)
    xyr.set([random() * width, random() * height, mean * (0.3 + 1.3 * random() ** 2)], k);
  Object.assign(state, { count, xyr });
  state.diagram.dispose();
  state.diagram = new Diagram(xyr);
  ask(state);
}

/** Centres of a grid's pixels. */
function centresOf([width, height]: Size, columns: number, rows: number) {
  const xy = new Float64Array(2 * columns * rows);
  for (let row = 0, k = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      xy[k++] = ((column + 0.5) * width) / columns;
      xy[k++] = ((row + 0.5) * height) / rows;
    }
  return xy;
}

/** A colour for each circle: three hues, five shades, neighbours mostly apart. */
function colorsOf(pen: Pen, count: number) {
  const paper = pen.tone("paper");
  const colors = new Uint8Array(3 * count);
  for (let id = 0; id < count; id++) {
    const mixed = Math.imul(id + 1, 0x9e3779b1) >>> 0;
    const tone = pen.tone(kTones[mixed % kTones.length]);
    const shade = kShades[(mixed >>> 8) % kShades.length];
    for (let channel = 0; channel < 3; channel++)
      colors[3 * id + channel] = paper[channel] + shade * (tone[channel] - paper[channel]);
  }
  return colors;
}

function picture(pen: Pen, { ids, count, columns, rows }: State): Pixels {
  const colors = colorsOf(pen, count);
  const bytes = new Uint8ClampedArray(4 * ids.length);
  for (const [k, id] of ids.entries()) {
    bytes[4 * k] = colors[3 * id];
    bytes[4 * k + 1] = colors[3 * id + 1];
    bytes[4 * k + 2] = colors[3 * id + 2];
    bytes[4 * k + 3] = 255;
  }
  return { columns, rows, bytes };
}

/** As 132 000. */
const grouped = (value: number) => String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, "\u202f");

export default figure<State>({
  needs: [],
  size: { wide: [740, 400], narrow: [370, 320] },
  start(size, isNarrow) {
    const [columns, rows] = isNarrow ? [370, 320] : [481, 260];
    const pixels = centresOf(size, columns, rows);
    const [ids, xyr, diagram] = [new Int32Array(), new Float64Array(), new Diagram()];
    const state = { size, columns, rows, count: 0, xyr, diagram, pixels, ids, milliseconds: 0 };
    setCount(state, 300);
    ask(state); // again: the engine has compiled by now what it runs often
    return state;
  },
  draw(pen, state) {
    const { size, count, xyr } = state;
    pen.pixels(0, 0, ...size, picture(pen, state));
    if (count > kRims) return;
    for (let k = 0; k < xyr.length; k += 3) pen.circle(xyr[k], xyr[k + 1], xyr[k + 2], "rim");
  },
  code: ({ count, ids }) =>
    `diagram.findMany(pixels)  // ${grouped(ids.length)} questions, ${grouped(count)} circles`,
  say({ ids, milliseconds }) {
    const time = milliseconds < 10 ? milliseconds.toFixed(1) : milliseconds.toFixed(0);
    const each = (1000 * milliseconds) / ids.length;
    return [
      [`${grouped(ids.length)} questions in ${time} ms`, "neighbor"],
      `, ${each.toFixed(2)} µs each, on your machine.`,
    ];
  },
  controls: [
    {
      kind: "slider",
      label: "Circles",
      min: 1,
      max: kMost,
      step: 0.05,
      get: ({ count }) => Math.log10(count),
      set: (state, value) => {
        const exact = 10 ** value;
        const digits = value >= kMost ? 1 : 2;
        setCount(state, Number(exact.toPrecision(digits)));
      },
      show: ({ count }) => grouped(count),
    },
    { kind: "button", label: "Ask again", act: ask },
  ],
  circles: ({ xyr }) => xyr,
});
