// A large circle to drag over others: which circle is hidden in which, as a tree that changes with
// it. Circles that are visible again are marked for a moment.
import { Diagram } from "apollonius-diagram";
import { figure, type Handle, type Size } from "../figure/figure.js";
import { drawDot, type Pen } from "../figure/pen.js";

/** x, y, r; each stands beside those that it contains, so that lines of the tree do not cross. */
const kCircles = [
  [74, 66, 30],
  [66, 74, 14],
  [82, 262, 46],
  [72, 272, 30],
  [64, 276, 14],
  [206, 312, 22],
  [196, 190, 58],
  [180, 176, 28],
  [174, 172, 12],
  [218, 218, 18],
  [330, 258, 34],
  [338, 266, 13],
  [300, 60, 20],
  [366, 350, 15],
] as const;
const kCover = 10; // the cover's place among the columns of the tree
const kPulse = 1.3; // seconds that a mark lasts
const kLevels = 4; // rows of the tree: circles are nested no deeper
const kLeast = 8; // units of the cover's radius

type Circle = { x: number; y: number; r: number };
type Tree = { parents: number[]; levels: number[] };
type State = {
  size: Size;
  side: number; // of the picture
  tree: { x: number; y: number; width: number; height: number };
  circles: Circle[]; // by id
  diagram: Diagram;
  hasCover: boolean;
  now: Tree;
  shown: number[]; // levels as drawn, on the way to what they are
  pulses: Map<number, number>; // seconds since circles became visible again, by id
};

/** Leaves out the visible circles, then those that are visible now, and so on. */
function treeOf({ circles, diagram }: State): Tree {
  const parents = circles.map(() => -1);
  const levels = circles.map(() => 0);
  let ids = [...diagram.ids()];
  for (let level = 0; ids.length > 0; level++) {
    using rest = new Diagram(ids.flatMap((id) => [circles[id].x, circles[id].y, circles[id].r]));
    const hidden = ids.filter((_, k) => rest.isHidden(k));
    for (const [k, id] of ids.entries()) {
      if (!rest.isHidden(k)) levels[id] = level;
      else parents[id] = ids[rest.coverOf(k)];
    }
    ids = hidden;
  }
  return { parents, levels };
}

function renew(state: State) {
  const { now } = state;
  state.now = treeOf(state);
  for (const [id, level] of state.now.levels.entries())
    if (id !== kCover && level === 0 && now.levels[id] > 0) state.pulses.set(id, 0);
    else if (level > 0) state.pulses.delete(id);
}

function setCover(state: State, { x, y, r }: Circle) {
  const [cover, side] = [state.circles[kCover], state.side];
  cover.x = Math.max(0, Math.min(side, x));
  cover.y = Math.max(0, Math.min(side, y));
  cover.r = Math.max(kLeast, Math.min(0.55 * side, r));
  state.diagram.update(kCover, cover.x, cover.y, cover.r);
  renew(state);
}

function toggleCover(state: State) {
  const { x, y, r } = state.circles[kCover];
  state.hasCover = !state.hasCover;
  if (!state.hasCover) state.diagram.remove(kCover);
  else state.diagram.insert(x, y, r); // the only free id is the cover's
  renew(state);
}

/** Where a circle stands in the tree, by its column and its level. */
function placeOf({ tree, circles }: State, id: number, level: number): [number, number] {
  const column = (id + 0.5) / circles.length;
  return [tree.x + column * tree.width, tree.y + (level * tree.height) / (kLevels - 1)];
}

/** A ring that grows thinner as it grows larger. */
function drawPulse(pen: Pen, { x, y, r }: Circle, seconds: number) {
  const t = seconds / kPulse;
  const outer = r + 3 + 26 * Math.sqrt(t);
  const ring = (radius: number) =>
    `M${x + radius},${y}A${radius},${radius} 0 1 1 ${x - radius},${y}` +
    `A${radius},${radius} 0 1 1 ${x + radius},${y}Z`;
  pen.path(ring(outer) + ring(outer - 6 * (1 - t)), "ok");
}

function drawPicture(pen: Pen, { circles, diagram, side, hasCover, pulses }: State) {
  const bySize = [...circles.keys()].sort((a, b) => circles[b].r - circles[a].r);
  for (const id of bySize) {
    if (id === kCover && !hasCover) continue;
    const { x, y, r } = circles[id];
    pen.circle(x, y, r, diagram.isHidden(id) ? "hidden" : "circle");
  }
  pen.path(diagram.voronoi([0, 0, side, side]).render(), "edge");
  for (const [id, seconds] of pulses) drawPulse(pen, circles[id], seconds);
  for (const [id, { x, y }] of circles.entries())
    if (id !== kCover) drawDot(pen, x, y, "centre", 2);
  if (!hasCover) return;
  const { x, y, r } = circles[kCover];
  drawDot(pen, x, y, "bar", 5);
  drawDot(pen, x + r, y, "bar", 5);
}

function drawTree(pen: Pen, state: State) {
  const { circles, now, shown, hasCover, pulses, tree, diagram } = state;
  const most = Math.max(...circles.map(({ r }) => r));
  for (const [id, parent] of now.parents.entries())
    if (parent >= 0)
      pen.line(
        ...placeOf(state, id, shown[id]),
        ...placeOf(state, parent, shown[parent]),
        "treeEdge",
      );
  for (const [id, { r }] of circles.entries()) {
    if (id === kCover && !hasCover) continue;
    const [x, y] = placeOf(state, id, shown[id]);
    const size = 3 + 7 * Math.sqrt(r / most);
    pen.circle(x, y, size, "paper");
    pen.circle(x, y, size, diagram.isHidden(id) ? "hidden" : "circle");
    const seconds = pulses.get(id);
    if (seconds !== undefined) drawPulse(pen, { x, y, r: size - 3 }, seconds);
  }
  const half = tree.height / (kLevels - 1) / 2;
  const right = tree.x + tree.width;
  const options = { size: 13, align: "end" } as const;
  pen.text("visible", right, tree.y - 24, "quiet", options);
  pen.line(tree.x, tree.y + half, right, tree.y + half, "frame");
  pen.text("hidden", right, tree.y + half + 14, "quiet", options);
}

export default figure<State>({
  size: { wide: [740, 400], narrow: [370, 590] },
  start(size, isNarrow) {
    const side = isNarrow ? 370 : 400;
    const f = side / 400;
    const others = kCircles.map(([x, y, r]) => ({ x: x * f, y: y * f, r: r * f }));
    const cover = { x: 148 * f, y: 236 * f, r: 140 * f };
    const circles = [...others.slice(0, kCover), cover, ...others.slice(kCover)];
    const tree = isNarrow
      ? { x: 14, y: 424, width: 342, height: 150 }
      : { x: 432, y: 76, width: 290, height: 272 };
    const diagram = new Diagram(circles.flatMap(({ x, y, r }) => [x, y, r]));
    const now = { parents: [], levels: [] };
    const pulses = new Map<number, number>();
    const state = { size, side, tree, circles, diagram, hasCover: true, now, shown: [0], pulses };
    renew(state);
    state.shown = [...state.now.levels];
    return state;
  },
  draw(pen, state) {
    pen.inside(0, 0, state.side, state.side, () => drawPicture(pen, state));
    const { side } = state;
    if (side < pen.width) pen.line(side, 0, side, side, "frame");
    else pen.line(0, side, side, side, "frame");
    drawTree(pen, state);
  },
  tick(state, seconds, isReduced) {
    const { pulses, shown, now } = state;
    for (const [id, age] of pulses)
      if (isReduced || age + seconds > kPulse) pulses.delete(id);
      else pulses.set(id, age + seconds);
    let moves = pulses.size > 0;
    for (const [id, level] of now.levels.entries()) {
      const gap = level - shown[id];
      const isThere = isReduced || Math.abs(gap) < 0.01;
      shown[id] = isThere ? level : level - gap * Math.exp(-seconds / 0.08);
      moves ||= !isThere;
    }
    return moves;
  },
  say({ diagram, now, hasCover }) {
    const count: [string, "hidden"] = [`${diagram.hiddenSize} of ${diagram.size}`, "hidden"];
    const deep = Math.max(...now.levels);
    const direct = now.parents.filter((parent) => parent === kCover).length;
    const levels = deep === 1 ? "one level" : `up to ${deep} levels`;
    if (!hasCover) return ["Without the cover ", count, ` circles are hidden, ${levels} deep.`];
    if (diagram.isHidden(kCover)) return [count, " circles are hidden, the one to drag too."];
    const under = direct === 1 ? "one hangs" : `${direct} hang`;
    return [count, ` circles are hidden, ${levels} deep; ${under} directly on the cover.`];
  },
  controls: [
    {
      kind: "button",
      label: ({ hasCover }) => (hasCover ? "Take the cover away" : "Bring the cover back"),
      act: toggleCover,
    },
  ],
  handles(state) {
    if (!state.hasCover) return [];
    const cover = state.circles[kCover];
    const centre: Handle = {
      label: "The cover: move it",
      ...cover,
      r: 0.85 * cover.r,
      move: (x, y) => setCover(state, { ...cover, x, y }),
    };
    const rim: Handle = {
      label: `The cover: its radius, ${Math.round(cover.r)}`,
      x: cover.x + cover.r,
      y: cover.y,
      move: (x) => setCover(state, { ...cover, r: x - cover.x }),
    };
    return [centre, rim];
  },
  circles: ({ diagram }) => diagram.sites().xyr,
});
