// The distance as a height: each circle is a cone, and the diagram is what is seen from above.
import { Diagram } from "apollonius-diagram";
import { figure, type Size } from "../figure/figure.js";
import type { Pen, Pixels } from "../figure/pen.js";
import { flat } from "./circles.js";

const kSide = 300; // units of the ground
const kCircles = [
  [95, 110, 62],
  [215, 80, 30],
  [235, 190, 44],
  [120, 225, 26],
  [175, 150, 12],
  [60, 190, 10],
  [110, 120, 18],
  [270, 120, 8],
  [190, 255, 16],
] as const;
const kColumns = 370;
const kDepths = 300; // samples from front to back
const kLight = [-0.6, -0.8]; // where it comes from

type Ground = { ids: Int32Array; heights: Float64Array; slopes: Float64Array };
type State = { size: Size; diagram: Diagram; turn: number; above: number };

/** Heights of the cones over places in rows from front to back, turned by an angle. */
function groundOf({ diagram, turn }: State): Ground {
  const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
  const xy = new Float64Array(2 * kColumns * kDepths);
  for (let row = 0; row < kDepths; row++)
    for (let column = 0; column < kColumns; column++) {
      const u = (column / kColumns - 0.5) * kSide * 1.42;
      const v = (0.5 - row / kDepths) * kSide * 1.42; // front rows first, y downwards
      const k = row * kColumns + column;
      xy[2 * k] = kSide / 2 + u * cosine - v * sine;
      xy[2 * k + 1] = kSide / 2 + u * sine + v * cosine;
    }
  const heights = new Float64Array(kColumns * kDepths);
  const ids = diagram.findMany(xy, heights);
  const slopes = new Float64Array(heights.length);
  for (let k = 0; k < heights.length; k++) {
    const [x, y] = [xy[2 * k], xy[2 * k + 1]];
    if (x < 0 || y < 0 || x > kSide || y > kSide) {
      ids[k] = -1;
      continue;
    }
    const [cx, cy] = kCircles[ids[k]];
    const length = Math.hypot(x - cx, y - cy) || 1;
    slopes[k] = (kLight[0] * (x - cx) + kLight[1] * (y - cy)) / length;
    heights[k] = -heights[k]; // positive inside the circle
  }
  return { ids, heights, slopes };
}

/** What is seen: columns from front to back, each place hiding what is lower behind it. */
function picture(pen: Pen, state: State, rows: number): Pixels {
  const { ids, heights, slopes } = groundOf(state);
  const bytes = new Uint8ClampedArray(4 * kColumns * rows);
  const [disc, slope, seam] = [pen.tone("site"), pen.tone("land"), pen.tone("ink")];
  const elevation = (state.above * Math.PI) / 180;
  const perUnit = kColumns / (kSide * 1.42);
  const [rise, depth] = [Math.cos(elevation) * perUnit, Math.sin(elevation) * perUnit];
  for (let column = 0; column < kColumns; column++) {
    let top = rows;
    for (let row = 0; row < kDepths; row++) {
      const k = row * kColumns + column;
      if (ids[k] < 0) continue;
      const v = (0.5 - row / kDepths) * kSide * 1.42;
      const y = Math.round(rows / 2 + v * depth - (heights[k] + 10) * rise);
      const isSeam =
        (ids[k] !== ids[k + 1] && ids[k + 1] >= 0 && column + 1 < kColumns) ||
        (row > 0 && ids[k] !== ids[k - kColumns] && ids[k - kColumns] >= 0);
      const color = isSeam ? seam : heights[k] > 0 ? disc : slope;
      const light = isSeam ? 1 : 0.86 + 0.16 * slopes[k];
      for (let at = Math.max(0, y); at < top; at++) {
        const pixel = 4 * (at * kColumns + column);
        for (let channel = 0; channel < 3; channel++)
          bytes[pixel + channel] = light * color[channel];
        bytes[pixel + 3] = 255;
      }
      top = Math.min(top, Math.max(0, y));
    }
  }
  return { columns: kColumns, rows, bytes };
}

export default figure<State>({
  size: { wide: [740, 520], narrow: [370, 300] },
  start: (size) => ({ size, diagram: new Diagram(flat(kCircles)), turn: 0.5, above: 38 }),
  draw(pen, state) {
    const [width, height] = state.size;
    const rows = Math.round((kColumns * height) / width);
    pen.pixels(0, 0, width, height, picture(pen, state, rows));
  },
  say({ above }) {
    if (above >= 88) return ["From straight above, the seams are the diagram of the circles."];
    return [
      "Blue is inside a circle, ",
      ["dark lines", "edge"],
      " are the seams between two cones.",
    ];
  },
  controls: [
    {
      kind: "slider",
      label: "Turn",
      min: 0,
      max: 6.28,
      step: 0.01,
      get: ({ turn }) => turn,
      set: (state, value) => {
        state.turn = value;
      },
      show: ({ turn }) => `${Math.round((turn * 180) / Math.PI)}°`,
    },
    {
      kind: "slider",
      label: "Look from",
      min: 15,
      max: 90,
      step: 1,
      get: ({ above }) => above,
      set: (state, value) => {
        state.above = value;
      },
      show: ({ above }) => (above >= 90 ? "above" : `${above}°`),
    },
  ],
  circles: () => flat(kCircles),
});
