// Four circles that almost touch one circle, and one of them moved by the smallest steps there are:
// what plain doubles say of it, asked in two ways, and what the package says.
import { Diagram } from "apollonius-diagram";
import { predicateCounts } from "apollonius-diagram/diagnostics";
import { figure, type Said, type Size } from "../figure/figure.js";
import { drawDot, type LookName, type Pen } from "../figure/pen.js";

type Circle = readonly [x: number, y: number, r: number];

const kMost = 25; // steps to each side
const kUlp = 2 ** -53; // between doubles from 1/2 to 1, where the circle's x is
const kNames = ["A", "B", "C", "D"];
const kBase: readonly Circle[] = [
  [0.24810766388900501, 2.87321452147779, 0.11],
  [0.3708701265487281, 3.212979531515138, 0.07],
  [0.765134221798073, 3.2056920350996925, 0.13],
  [0.6999805307122311, 2.785507555926686, 0.09],
];
const kTouched: Circle = [0.52, 3, 0.19]; // the circle that all four touch, about

/** Answers at one place of D; `ask` is which diagonal each question leads to. */
type Answer = { first: Diagonal; second: Diagonal; exact: Diagonal; stages: readonly number[] };
type Diagonal = "AC" | "BD";
type State = { size: Size; far: boolean; at: number; answers: Record<"near" | "far", Answer[]> };

/** The circle that touches three from outside, as textbooks compute it: in doubles. */
function touching(a: Circle, b: Circle, c: Circle): Circle {
  const row = (p: Circle) => [
    ...p.map((value, k) => 2 * (value - a[k])),
    p[0] ** 2 + p[1] ** 2 - p[2] ** 2 - (a[0] ** 2 + a[1] ** 2 - a[2] ** 2),
  ];
  const [p, q] = [row(b), row(c)];
  const d = p[0] * q[1] - p[1] * q[0];
  // The centre is linear in the radius: (x0 + u s, y0 + v s).
  const [x0, y0] = [(p[3] * q[1] - p[1] * q[3]) / d, (p[0] * q[3] - p[3] * q[0]) / d];
  const [u, v] = [(p[1] * q[2] - p[2] * q[1]) / d, (p[2] * q[0] - p[0] * q[2]) / d];
  const [dx, dy] = [x0 - a[0], y0 - a[1]];
  const [e, f, g] = [u * u + v * v - 1, dx * u + dy * v - a[2], dx * dx + dy * dy - a[2] * a[2]];
  const root = Math.sqrt(f * f - e * g);
  const roots = [(-f + root) / e, (-f - root) / e].filter((s) => s + a[2] > 0);
  const s = Math.min(...roots);
  return [x0 + u * s, y0 + v * s, s];
}

/** Whether a fourth circle reaches into the one that touches three. */
function reaches(three: readonly Circle[], [x, y, r]: Circle) {
  const [cx, cy, s] = touching(three[0], three[1], three[2]);
  return Math.hypot(cx - x, cy - y) - r < s;
}

function answerAt(move: number): Answer {
  const [a, b, c, [x, y, r]] = kBase;
  const d: Circle = [x + move * kUlp, y, r];
  const diagram = new Diagram([...a, ...b, ...c]);
  const before = predicateCounts().vertexConflict;
  diagram.insert(...d);
  const after = predicateCounts().vertexConflict;
  const { sites } = diagram.edges();
  const isAC = sites.some((id, k) => k % 2 === 0 && id + sites[k + 1] === 2 && id !== 1);
  diagram.dispose();
  return {
    first: reaches([a, b, c], d) ? "BD" : "AC",
    second: reaches([b, c, d], a) ? "AC" : "BD",
    exact: isAC ? "AC" : "BD",
    stages: (["filter", "middle", "exact"] as const).map((key) => after[key] - before[key]),
  };
}

const kLabel = 62; // units left of a strip
type Strip = {
  width: number;
  y: number;
  name: string;
  of: (answer: Answer) => Diagonal | "wrong" | "right";
};
const kLarge = 1_000_000; // units in the last place
const answersFor = (step: number) =>
  Array.from({ length: 2 * kMost + 1 }, (_, k) => answerAt((k - kMost) * step));
const answersOf = ({ answers, far }: State) => answers[far ? "far" : "near"];

function drawCircles(pen: Pen, side: number, diagonals: readonly Diagonal[], isWrong: boolean) {
  const scale = side / 0.92;
  const at = ([x, y]: Circle) => [side / 2 + (x - 0.51) * scale, side / 2 + (y - 3) * scale];
  const [cx, cy] = at(kTouched);
  pen.circle(cx, cy, kTouched[2] * scale, "empty");
  for (const circle of kBase) {
    const [x, y] = at(circle);
    pen.circle(x, y, circle[2] * scale, "circle");
  }
  const line = (from: number, to: number, look: LookName) => {
    const [[x0, y0], [x1, y1]] = [at(kBase[from]), at(kBase[to])];
    pen.line(x0, y0, x1, y1, look);
  };
  for (const k of [0, 1, 2, 3]) line(k, (k + 1) % 4, "edge");
  if (diagonals.includes("AC")) line(0, 2, isWrong ? "conflict" : "secondEdge");
  if (diagonals.includes("BD")) line(1, 3, isWrong ? "conflict" : "firstEdge");
  for (const [k, circle] of kBase.entries()) {
    const [x, y] = at(circle);
    pen.text(kNames[k], x, y, "name", { align: "middle", isBold: true });
  }
}

/** An answer for each place of D: the upper line is B–D, the lower one A–C. */
function drawStrip(pen: Pen, state: State, strip: Strip) {
  const { width, y, name, of } = strip;
  pen.text(name, 0, y + 10, "name", { size: 12 });
  const step = (width - kLabel) / (2 * kMost + 1);
  for (const [k, answer] of answersOf(state).entries()) {
    const what = of(answer);
    const x = kLabel + k * step;
    if (what === "BD") pen.rectangle(x, y, step, 9, "bar");
    if (what === "AC") pen.rectangle(x, y + 11, step, 9, "thirdBar");
    if (what === "wrong") pen.rectangle(x, y + 4, step - 1, 12, "alarm");
  }
  const x = kLabel + (state.at + kMost + 0.5) * step;
  pen.line(x, y - 2, x, y + 22, "pointer");
}

/** Both questions lead to a diagonal each: crossing ones, or none. */
function diagonalsIn({ first, second }: Answer): Diagonal[] {
  if (first === second) return [first];
  return first === "BD" ? ["BD", "AC"] : [];
}

export default figure<State>({
  needs: [],
  size: { wide: [740, 400], narrow: [370, 296] },
  start: (size) => ({
    size,
    far: false,
    at: -5,
    answers: { near: answersFor(1), far: answersFor(kLarge) },
  }),
  draw(pen, state) {
    const [width, height] = state.size;
    const half = width / 2 - 22;
    const answer = answersOf(state)[state.at + kMost];
    const side = Math.min(half, height - 124);
    const isWrong = answer.first !== answer.second;
    const strips = side + 38;
    const panel = (x: number, title: string, draw: () => void) =>
      pen.inside(x, 0, half, height, () => {
        pen.text(title, 0, 18, "name", { isBold: true });
        draw();
      });
    panel(14, "Doubles", () => {
      pen.inside((half - side) / 2, 26, side, side, () =>
        drawCircles(pen, side, diagonalsIn(answer), isWrong),
      );
      drawDot(pen, half - 10, 18, isWrong ? "alarm" : "ok", 7);
      if (isWrong && half > 240)
        pen.text("contradiction", half - 24, 18, "alarm", { align: "end", size: 13 });
      const strip = (y: number, name: string, of: Strip["of"]) =>
        drawStrip(pen, state, { width: half, y: strips + y, name, of });
      strip(0, "D in ABC", ({ first }) => first);
      strip(26, "A in BCD", ({ second }) => second);
      strip(52, "differ", ({ first, second }) => (first === second ? "right" : "wrong"));
    });
    panel(width / 2 + 8, "This library", () => {
      pen.inside((half - side) / 2, 26, side, side, () =>
        drawCircles(pen, side, [answer.exact], false),
      );
      drawStrip(pen, state, { width: half, y: strips, name: "edge", of: ({ exact }) => exact });
      for (const [k, name] of ["filter", "middle", "exact"].entries()) {
        // Beside each other, or where that is too narrow, below each other.
        const isNarrow = half < 240;
        const x = 6 + (isNarrow ? 0 : (k * half) / 3);
        const lamp = strips + (isNarrow ? 34 + 17 * k : 46);
        const count = answer.stages[k];
        drawDot(pen, x, lamp, count > 0 ? "ok" : "off", 5);
        pen.text(`${name} ${count}`, x + 12, lamp, "name", { size: 12 });
      }
    });
  },
  say(state): Said[] {
    const answer = answersOf(state)[state.at + kMost];
    const wrong = answersOf(state).filter(({ first, second }) => first !== second).length;
    const found = diagonalsIn(answer);
    const edge = (name: Diagonal) => `${name[0]}–${name[1]}`;
    return [
      found.length === 1
        ? `Doubles: both questions give ${edge(found[0])}. `
        : [`Doubles: ${found.length === 2 ? "edges that cross" : "a hole"}. `, "wrong"],
      ["The library: ", "dual"],
      `${edge(answer.exact)}. Of ${2 * kMost + 1} places, `,
      [`${wrong} contradict themselves`, wrong > 0 ? "wrong" : "dual"],
      " in doubles.",
    ];
  },
  controls: [
    {
      kind: "slider",
      label: "Move D by",
      min: -kMost,
      max: kMost,
      step: 1,
      get: ({ at }) => at,
      set: (state, value) => {
        state.at = value;
      },
      show: ({ at, far }) => `${(at * 1.11).toFixed(1)} · 10${far ? "⁻¹⁰" : "⁻¹⁶"}`,
    },
    {
      kind: "choice",
      label: "Steps",
      options: [
        ["near", "smallest steps"],
        ["far", "a million times larger"],
      ],
      get: ({ far }) => (far ? "far" : "near"),
      set: (state, value) => {
        state.far = value === "far";
      },
    },
  ],
  circles: () => kBase.flatMap(([x, y, r]) => [500 * x, 500 * (y - 2.5), 500 * r]),
});
