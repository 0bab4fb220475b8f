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
const kCells = 520; // of the ground, in each direction
const kColumns = 740;
const kDepths = 620; // samples from front to back
const kLight = [-0.6, -0.8]; // where it comes from
const kSpan = kSide * 1.42; // so that each corner is seen, however it is turned
const kAbove = 88; // degrees from which on the cones look flat

/** By cell of the ground: the height of the surface, its light, and whether it is a seam. */
type Ground = { heights: Float64Array; lights: Float64Array; seams: Uint8Array };
type State = { size: Size; ground: Ground; turn: number; above: number };

/** The surface of the cones, asked for in one call. */
function makeGround(): Ground {
  const xy = new Float64Array(2 * kCells * kCells);
  for (let k = 0; k < kCells * kCells; k++) {
    xy[2 * k] = (((k % kCells) + 0.5) * kSide) / kCells;
    xy[2 * k + 1] = ((Math.floor(k / kCells) + 0.5) * kSide) / kCells;
  }
  const { ids, distances: heights } = new Diagram(flat(kCircles)).nearestMany(xy);
  const lights = new Float64Array(heights.length);
  const seams = new Uint8Array(heights.length);
  for (let k = 0; k < heights.length; k++) {
    const [cx, cy] = kCircles[ids[k]];
    const [dx, dy] = [xy[2 * k] - cx, xy[2 * k + 1] - cy];
    lights[k] = 0.86 + (0.16 * (kLight[0] * dx + kLight[1] * dy)) / (Math.hypot(dx, dy) || 1);
    heights[k] = -heights[k]; // positive inside the circle
    const isEnd = (k + 1) % kCells === 0;
    const isSeam = (!isEnd && ids[k] !== ids[k + 1]) || (ids[k + kCells] ?? ids[k]) !== ids[k];
    if (isSeam) for (const at of [k, k + 1, k - 1, k + kCells, k - kCells]) seams[at] = 1;
  }
  return { heights, lights, seams };
}

/** Draws columns from front to back, each place hiding what is lower behind it. */
function picture(pen: Pen, { ground, turn, above }: State, rows: number): Pixels {
  const { heights, lights, seams } = ground;
  const bytes = new Uint8ClampedArray(4 * kColumns * rows);
  const [disc, slope, seam] = [pen.tone("site"), pen.tone("coast"), pen.tone("ink")];
  const elevation = (above * Math.PI) / 180;
  const perUnit = kColumns / kSpan;
  const [rise, depth] = [Math.cos(elevation) * perUnit, Math.sin(elevation) * perUnit];
  const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
  const cellOf = (value: number) => Math.floor((value / kSide + 0.5) * kCells);
  for (let column = 0; column < kColumns; column++) {
    const u = (column / kColumns - 0.5) * kSpan;
    let top = rows;
    for (let row = 0; row < kDepths && top > 0; row++) {
      const v = (0.5 - row / kDepths) * kSpan; // front rows first, y downwards
      const [i, j] = [cellOf(u * cosine - v * sine), cellOf(u * sine + v * cosine)];
      if (i < 0 || j < 0 || i >= kCells || j >= kCells) continue;
      const k = j * kCells + i;
      const y = Math.max(0, Math.round(rows / 2 + v * depth - (heights[k] + 10) * rise));
      const color = seams[k] ? seam : heights[k] > 0 ? disc : slope;
      const light = seams[k] ? 1 : lights[k];
      for (let at = y; at < top; at++) {
        const pixel = 4 * (at * kColumns + column);
        for (let channel = 0; channel < 3; channel++)
          bytes[pixel + channel] = light * color[channel];
        bytes[pixel + 3] = 255;
      }
      top = Math.min(top, y);
    }
  }
  return { columns: kColumns, rows, bytes };
}

export default figure<State>({
  needs: [],
  size: { wide: [740, 520], narrow: [370, 300] },
  start: (size) => ({ size, ground: makeGround(), turn: 0.5, above: 38 }),
  draw(pen, state) {
    const [width, height] = state.size;
    const rows = Math.round((kColumns * height) / width);
    pen.pixels(0, 0, width, height, picture(pen, state, rows));
  },
  say({ above }) {
    if (above >= kAbove) return ["From straight above, the seams are the diagram of the circles."];
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
