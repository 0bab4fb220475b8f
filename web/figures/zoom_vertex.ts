// A place where four cells meet, magnified by up to a million million: with one circle moved by as
// little as that, there are two vertices, and they are where they should be.
import { Diagram } from "apollonius-diagram";
import { figure, type Said, type Size } from "../figure/figure.js";
import { drawDot, type Pen } from "../figure/pen.js";

const kUnit = 92; // units of the picture from circle to circle, before it is magnified
const kRadius = 0.3;
const kMost = 12; // powers of ten
const kSpeed = 2; // powers of ten a second
const kMove = 1e-12; // in distances from circle to circle
const kMoves = { none: 0, right: kMove, left: -kMove };

type MoveName = keyof typeof kMoves;
type State = {
  size: Size;
  power: number;
  moved: MoveName;
  diagram: Diagram;
  isGoing: boolean;
};

/** Circles in rows, around 0, where doubles are finest; the one right below 0 is moved. */
function diagramFor(moved: MoveName) {
  const xyr: number[] = [];
  for (let y = -2.5; y < 3; y++)
    for (let x = -4.5; x < 5; x++)
      xyr.push(x === 0.5 && y === 0.5 ? x + kMoves[moved] : x, y, kRadius);
  return new Diagram(xyr);
}

/** The four circles around 0, from the left above on, with the sun. */
const around = (diagram: Diagram) =>
  [
    [-0.5, -0.5],
    [0.5, -0.5],
    [0.5, 0.5],
    [-0.5, 0.5],
  ].map(([x, y]) => diagram.find(x, y));

/** The vertices next to 0, and whether the first and the third cell share an edge. */
function splitOf({ diagram }: State) {
  const four = around(diagram);
  const { xy, sites } = diagram.vertices();
  const places: [number, number][] = [];
  for (let k = 0; k < sites.length; k += 3)
    if ([0, 1, 2].every((n) => four.includes(sites[k + n])))
      places.push([xy[(2 * k) / 3], xy[(2 * k) / 3 + 1]]);
  const isFirst = diagram.neighbors(four[0]).includes(four[2]);
  return { places, isFirst };
}

/** Collects a path in the picture's units: a window of 10^-12 would be lost in rounded numbers. */
function magnified(size: Size, scale: number) {
  let data = "";
  const at = (x: number, y: number) =>
    `${(size[0] / 2 + x * scale).toFixed(2)},${(size[1] / 2 + y * scale).toFixed(2)}`;
  return {
    moveTo: (x: number, y: number) => {
      data += `M${at(x, y)}`;
    },
    lineTo: (x: number, y: number) => {
      data += `L${at(x, y)}`;
    },
    bezierCurveTo: (a: number, b: number, c: number, d: number, x: number, y: number) => {
      data += `C${at(a, b)} ${at(c, d)} ${at(x, y)}`;
    },
    closePath: () => {
      data += "Z";
    },
    path: () => data,
  };
}

const superscript = (value: number) =>
  String(value).replace(/./g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);

function drawScale(pen: Pen, [width, height]: Size, power: number) {
  // A bar of a power of ten that is between a tenth of the unit and the unit long.
  const whole = Math.ceil(power);
  const length = kUnit * 10 ** (power - whole);
  const [x, y] = [width - 16, height - 16];
  pen.line(x - length, y, x, y, "pointer");
  const label = whole === 0 ? "1" : `10${superscript(-whole)}`;
  pen.text(label, x, y - 14, "name", { align: "end", size: 13 });
}

export default figure<State>({
  size: { wide: [740, 380], narrow: [360, 320] },
  start: (size) => ({
    size,
    power: 0,
    moved: "right",
    diagram: diagramFor("right"),
    isGoing: false,
  }),
  draw(pen, state) {
    const { size, power, diagram } = state;
    const scale = kUnit * 10 ** power;
    const [halfX, halfY] = [size[0] / 2 / scale, size[1] / 2 / scale];
    const view = diagram.voronoi([-halfX, -halfY, halfX, halfY]);
    const four = around(diagram);
    for (const id of [four[0], four[2]]) {
      const cell = magnified(size, scale);
      view.renderCell(id, cell);
      pen.path(cell.path(), "window");
    }
    if (kRadius * scale < 4 * size[0])
      for (const { x, y, r } of diagram)
        pen.circle(size[0] / 2 + x * scale, size[1] / 2 + y * scale, r * scale, "circle");
    const edges = magnified(size, scale);
    view.render(edges);
    pen.path(edges.path(), "strongEdge");
    const reach = Math.min(90, 0.5 * scale); // of the names, from the middle
    for (const [k, name] of ["A", "B", "C", "D"].entries()) {
      const x = size[0] / 2 + (k === 1 || k === 2 ? reach : -reach);
      const y = size[1] / 2 + (k > 1 ? reach : -reach);
      pen.text(name, x, y, "name", { align: "middle", isBold: true, size: 16 });
    }
    for (const [x, y] of splitOf(state).places)
      drawDot(pen, size[0] / 2 + x * scale, size[1] / 2 + y * scale, "vertex", 5);
    drawScale(pen, size, power);
  },
  say(state): Said[] {
    const { places, isFirst } = splitOf(state);
    const apart = Math.hypot(places[0][0] - places[1][0], places[0][1] - places[1][1]);
    const touch = isFirst ? "A and C" : "B and D";
    const times = state.power === 0 ? "Not magnified. " : `Magnified ${timesOf(state)} times. `;
    if (apart === 0)
      return [
        times,
        "All four cells meet in ",
        ["one point", "vertex"],
        ", however near you look.",
      ];
    return [
      times,
      ["Two vertices", "vertex"],
      `, ${scientific(apart)} apart; `,
      `${touch} share the edge between them.`,
    ];
  },
  tick(state, seconds) {
    if (!state.isGoing) return false;
    state.power = Math.min(kMost, state.power + kSpeed * seconds);
    state.isGoing = state.power < kMost;
    return true;
  },
  controls: [
    {
      kind: "slider",
      label: "Magnify",
      min: 0,
      max: kMost,
      step: 0.1,
      get: ({ power }) => power,
      set: (state, value) => {
        state.power = value;
        state.isGoing = false;
      },
      show: (state) => timesOf(state),
    },
    {
      kind: "button",
      label: ({ isGoing }) => (isGoing ? "Stop" : "Zoom in"),
      act: (state) => {
        state.isGoing = !state.isGoing;
        if (state.isGoing && state.power >= kMost) state.power = 0;
      },
    },
    {
      kind: "choice",
      label: "Move C by 10⁻¹²",
      options: [
        ["left", "left"],
        ["none", "0"],
        ["right", "right"],
      ],
      get: ({ moved }) => moved,
      set: (state, value) => {
        state.moved = value as MoveName;
        state.diagram.dispose();
        state.diagram = diagramFor(state.moved);
      },
    },
  ],
});

function scientific(value: number) {
  const [digits, power] = value.toExponential(1).split("e");
  const times = digits === "1.0" ? "" : `${digits} · `;
  return `${times}10${superscript(Number(power))}`;
}

const timesOf = ({ power }: State) =>
  power < 3 ? (10 ** power).toPrecision(2).replace(/\.0$/, "") : scientific(10 ** power);
