// One new circle: the walk to the nearest one, what of the diagram it takes, and its own cell.
import { Diagram } from "apollonius-diagram";
import { figure, type Said, type Size } from "../figure/figure.js";
import { drawDot, type Pen } from "../figure/pen.js";
import {
  type Circle,
  conflicts,
  cutEdges,
  distanceTo,
  kStepping,
  someCircles,
  stepChoice,
  triples,
  walk,
} from "./changing.js";

const kSteps = ["Place", "Walk", "Conflict", "Hole", "Star"];

type State = {
  size: Size;
  circles: Circle[];
  diagram: Diagram;
  added: Circle;
  start: number; // of the walk
  step: number;
};

const isHidden = ({ diagram, added }: State) =>
  distanceTo(diagram.site(diagram.find(added.x, added.y)), added.x, added.y) <= -added.r;

/** The new circle's cell, its neighbours and the circles that it will hide. */
function afterwards({ diagram, added, size }: State) {
  const id = diagram.insert(added.x, added.y, added.r);
  const cell = diagram.voronoi([0, 0, ...size]).renderCell(id);
  const neighbors = [...diagram.neighbors(id)];
  const hidden = [...diagram.ids()].filter((other) => other !== id && diagram.isHidden(other));
  diagram.remove(id);
  return { cell, neighbors, hidden };
}

function drawWalk(pen: Pen, { diagram, added, start }: State) {
  const path = walk(diagram, added.x, added.y, start).map((id) => diagram.site(id));
  for (const [k, { x, y }] of path.slice(1).entries()) {
    pen.line(path[k].x, path[k].y, x, y, "pointer");
  }
  const nearest = path[path.length - 1];
  pen.circle(nearest.x, nearest.y, nearest.r, "nearest");
  for (const [k, { x, y }] of path.entries()) {
    drawDot(pen, x, y, "centre", 4);
    const label = k === 0 ? "start" : String(k);
    pen.text(label, x, y - 14 / pen.scale, "name", { align: "middle", isBold: true, size: 13 });
  }
}

function drawConflict(pen: Pen, state: State) {
  const found = conflicts(state.diagram, state.added);
  if (found.length > 0) pen.circle(found[0].x, found[0].y, found[0].r, "empty");
  pen.path(cutEdges(state.diagram, state.size, state.added).lost, "conflict");
  for (const { x, y } of found) drawDot(pen, x, y, "alarm", 4.5);
}

export default figure<State>({
  size: { wide: [640, 420], narrow: [360, 300] },
  start(size, isNarrow) {
    const circles = someCircles(isNarrow ? 16 : 26, 11, size);
    const diagram = new Diagram(triples(circles));
    const added = { x: 0.72 * size[0], y: 0.57 * size[1], r: isNarrow ? 13 : 20 };
    const start = diagram.find(0, size[1]);
    return { size, circles, diagram, added, start, step: 0 };
  },
  draw(pen, state) {
    const { size, circles, diagram, added, step } = state;
    const { cell, neighbors, hidden } = afterwards(state);
    const isOpen = step >= 3 && cell;
    if (isOpen) pen.path(cell, step === 3 ? "window" : "neighbor");
    for (const { x, y, r } of circles) pen.circle(x, y, r, "circle");
    const edges = isOpen
      ? cutEdges(diagram, size, added).kept
      : diagram.voronoi([0, 0, ...size]).render();
    pen.path(edges, "edge");
    if (step === 1) drawWalk(pen, state);
    if (step === 2 && cell) drawConflict(pen, state);
    if (step === 4 && cell) {
      pen.path(cell, "fresh");
      for (const id of neighbors) {
        pen.line(added.x, added.y, circles[id].x, circles[id].y, "dual");
        drawDot(pen, circles[id].x, circles[id].y, "ok", 3.5);
      }
    }
    pen.circle(added.x, added.y, added.r, "paper");
    pen.circle(added.x, added.y, added.r, isHidden(state) ? "hidden" : "added");
    drawDot(pen, added.x, added.y, "ok", 3.5);
    if (isOpen)
      for (const id of hidden) pen.circle(circles[id].x, circles[id].y, circles[id].r, "hidden");
  },
  say(state): Said[] {
    const { diagram, added, circles, start, step } = state;
    if (step === 1) {
      const steps = walk(diagram, added.x, added.y, start).length - 1;
      const many = steps === 1 ? "1 step" : `${steps} steps`;
      return [`${many} from the start to the `, ["nearest circle", "nearest"], "."];
    }
    if (step > 1 && isHidden(state))
      return ["It lies inside another circle: it is ", ["hidden", "hidden"], ", nothing changes."];
    const { neighbors, hidden } = afterwards(state);
    const lost = conflicts(diagram, added).length;
    const all = diagram.vertices().clearance.length;
    if (step === 2)
      return [[`${lost} of ${all} vertices`, "wrong"], " are in conflict with the new circle."];
    if (step === 3) return ["The hole: everything outside it stays as it was."];
    if (step === 4) {
      const others = circles.length - neighbors.length - hidden.length;
      return [
        [`${neighbors.length} neighbours`, "dual"],
        ` give a part of their cells; ${others} cells are as before.`,
        hidden.length > 0 ? ([` Now hidden: ${hidden.length}.`, "hidden"] as const) : "",
      ];
    }
    return [`${circles.length} circles, ${all} vertices, and a new circle to place.`];
  },
  steps: kStepping,
  controls: [
    stepChoice(kSteps),
    {
      kind: "slider",
      label: "Size",
      min: 2,
      max: 90,
      step: 1,
      get: ({ added }) => added.r,
      set: ({ added }, value) => {
        added.r = value;
      },
    },
  ],
  handles: ({ added, size }) => [
    {
      label: "The new circle: move it",
      x: added.x,
      y: added.y,
      r: added.r,
      move(x, y) {
        added.x = Math.max(4, Math.min(size[0] - 4, x));
        added.y = Math.max(4, Math.min(size[1] - 4, y));
      },
    },
  ],
  circles: ({ circles, added }) => triples([...circles, added]),
});
