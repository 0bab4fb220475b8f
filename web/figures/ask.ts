// One picture and four calls: what each answers where the pointer is.
import { Diagram } from "apollonius-diagram";
import { figure, type Point, type Said } from "../figure/figure.js";
import { drawPointer, type LookName } from "../figure/pen.js";
import { flat } from "./circles.js";

const kWide = [
  [120, 120, 84],
  [330, 96, 52],
  [236, 246, 64],
  [448, 232, 90],
  [640, 108, 60],
  [654, 288, 38],
  [92, 128, 44],
  [146, 80, 16],
  [82, 136, 18],
  [416, 220, 40],
  [486, 262, 24],
  [488, 196, 14],
  [222, 258, 26],
  [540, 60, 14],
  [594, 142, 22],
  [352, 176, 12],
  [62, 290, 30],
  [340, 320, 18],
  [226, 44, 13],
  [560, 330, 15],
] as const;

const kNarrow = [
  [130, 112, 84],
  [106, 120, 46],
  [164, 70, 17],
  [96, 134, 18],
  [296, 92, 50],
  [314, 50, 15],
  [86, 300, 62],
  [74, 314, 28],
  [252, 262, 74],
  [224, 250, 32],
  [288, 298, 16],
  [28, 222, 13],
  [344, 178, 14],
  [178, 362, 16],
  [334, 366, 24],
] as const;

const kCalls = ["find", "pick", "within", "kNearest"] as const;
type Call = (typeof kCalls)[number];
type State = {
  diagram: Diagram;
  circles: readonly (readonly number[])[];
  call: Call;
  at: Point;
  distance: number;
  count: number;
};

function answerOf({ diagram, call, at, distance, count }: State): number[] {
  switch (call) {
    case "find":
      return [diagram.find(...at)];
    case "pick":
      return [diagram.pick(...at)];
    case "within":
      return [...diagram.within(...at, distance)];
    case "kNearest":
      return [...diagram.kNearest(...at, count)];
  }
}

const list = (ids: readonly number[]) =>
  ids.length < 2 ? ids.join() : `${ids.slice(0, -1).join(", ")} and ${ids.at(-1)}`;

/** Says what find and pick answer here, and why they differ. */
function compared(diagram: Diagram, at: Point): Said[] {
  const [found, picked] = [diagram.find(...at), diagram.pick(...at)];
  const under = [...diagram.within(...at, 0)];
  const deep = Math.round(-(diagram.nearest(...at)?.distance ?? 0));
  if (under.length === 0) return [`No circle is under the pointer: find and pick answer ${found}.`];
  if (under.length === 1) return [`Only ${found} is under the pointer: find and pick answer it.`];
  if (found === picked)
    return [
      `Circles ${list(under)} are under the pointer. It is deepest in ${found}, by ${deep}, ` +
        "which is the smallest, too: find and pick answer it.",
    ];
  const why: Said[] = diagram.isHidden(picked)
    ? [` Circle ${picked} is `, ["hidden", "hidden"], ", so find never answers it."]
    : [];
  return [
    `Circles ${list(under)} are under the pointer. It is deepest in ${found}, by ${deep}: find. `,
    `The smallest is ${picked}: pick.`,
    ...why,
  ];
}

export default figure<State>({
  size: { wide: [740, 370], narrow: [370, 400] },
  start(_, isNarrow) {
    const circles = isNarrow ? kNarrow : kWide;
    const at: Point = isNarrow ? [108, 96] : [92, 100];
    return {
      diagram: new Diagram(flat(circles)),
      circles,
      call: "find",
      at,
      distance: 40,
      count: 5,
    };
  },
  hover(state, at) {
    if (at) state.at = [Math.round(at[0]), Math.round(at[1])];
  },
  draw(pen, state) {
    const { diagram, circles, call, at, distance } = state;
    const answer = answerOf(state);
    const bySize = [...circles.keys()].sort((a, b) => circles[b][2] - circles[a][2]);
    if (call === "find")
      pen.path(diagram.voronoi([0, 0, pen.width, pen.height]).renderCell(answer[0]), "nearestCell");
    for (const id of bySize) {
      const [x, y, r] = circles[id];
      const look: LookName = diagram.isHidden(id) ? "hidden" : "circle";
      pen.circle(x, y, r, answer.includes(id) ? "nearest" : look);
    }
    if (call === "find") pen.path(diagram.voronoi([0, 0, pen.width, pen.height]).render(), "edge");
    if (call === "within" && distance > 0) pen.circle(...at, distance, "reach");
    for (const id of answer) {
      const [x, y, r] = circles[id];
      const length = Math.hypot(x - at[0], y - at[1]);
      if (length <= r) continue;
      const [rimX, rimY] = [x + (r / length) * (at[0] - x), y + (r / length) * (at[1] - y)];
      pen.line(...at, rimX, rimY, "ruler");
    }
    for (const [id, [x, y, r]] of circles.entries()) {
      const dy = r > 30 ? r - 12 : 0; // not on the circles inside
      pen.text(String(id), x, y + dy, "name", { size: 12, align: "middle" });
    }
    drawPointer(pen, ...at);
  },
  code(state) {
    const { call, at, distance, count } = state;
    const answer = answerOf(state);
    const isOne = call === "find" || call === "pick";
    const more = { find: "", pick: "", within: `, ${distance}`, kNearest: `, ${count}` }[call];
    const result = isOne ? answer.join() : `[${answer.join(", ")}]`;
    return `diagram.${call}(${at.join(", ")}${more})  // ${result}`;
  },
  say(state) {
    const { diagram, call, at, distance, count } = state;
    const answer = answerOf(state);
    if (call === "find" || call === "pick") return compared(diagram, at);
    const hidden = answer.filter((id) => diagram.isHidden(id)).length;
    const many: Said = [
      hidden === 1 ? "one of them is hidden" : `${hidden} of them are hidden`,
      "hidden",
    ];
    const also: Said[] = hidden > 0 ? ["; ", many] : [];
    if (call === "within" && distance === 0)
      return [`Under the pointer: ${answer.length} of ${diagram.size} circles`, ...also, "."];
    if (call === "within")
      return [
        [`${answer.length} ${answer.length === 1 ? "circle" : "circles"}`, "nearest"],
        ` within ${distance}`,
        ...also,
        ".",
      ];
    return [`The ${count} nearest of ${diagram.size}, the nearest first`, ...also, "."];
  },
  controls: [
    {
      kind: "choice",
      label: "Call",
      options: kCalls.map((call) => [call, call]),
      get: ({ call }) => call,
      set: (state, value) => {
        state.call = kCalls.find((call) => call === value) ?? "find";
      },
    },
    {
      kind: "slider",
      label: "Distance",
      min: 0,
      max: 150,
      step: 1,
      get: ({ distance }) => distance,
      set: (state, value) => {
        state.distance = value;
      },
      isShown: ({ call }) => call === "within",
    },
    {
      kind: "slider",
      label: "k",
      min: 1,
      max: 20,
      step: 1,
      get: ({ count }) => count,
      set: (state, value) => {
        state.count = value;
      },
      isShown: ({ call }) => call === "kNearest",
    },
  ],
  circles: ({ circles }) => flat(circles),
});
