// One circle goes: its neighbours, the hole, and their small diagram that fills it.
import { Diagram } from "apollonius-diagram";
import { figure, type Said, type Size } from "../figure/figure.js";
import { drawDot, drawPointer, type Pen } from "../figure/pen.js";
import {
  type Circle,
  cutEdges,
  distanceTo,
  kStepping,
  someCircles,
  stepChoice,
  triples,
} from "./changing.js";

const kSteps = ["Choose", "Star", "Hole", "Small diagram", "Sewn in"];

type State = {
  size: Size;
  circles: Circle[];
  diagram: Diagram;
  chosen: number;
  step: number;
  pointer: readonly [number, number] | null;
};

/** The circles that are hidden by this one alone. */
function covered({ diagram, circles }: State, id: number) {
  const { x, y, r } = circles[id];
  return [...diagram.within(x, y, r)].filter(
    (k) =>
      diagram.isHidden(k) && distanceTo(circles[id], circles[k].x, circles[k].y) <= -circles[k].r,
  );
}

/** The diagram of the neighbours, and of what the chosen circle had hidden. */
function smallDiagram(state: State) {
  const { diagram, circles, chosen } = state;
  const ids = [...diagram.neighbors(chosen), ...covered(state, chosen)];
  return { ids, small: new Diagram(triples(ids.map((id) => circles[id]))) };
}

function drawStar(pen: Pen, { diagram, circles, chosen }: State) {
  const { x, y } = circles[chosen];
  for (const id of diagram.neighbors(chosen)) {
    pen.line(x, y, circles[id].x, circles[id].y, "dual");
    drawDot(pen, circles[id].x, circles[id].y, "ok", 3.5);
  }
  drawDot(pen, x, y, "ok", 3.5);
}

export default figure<State>({
  size: { wide: [640, 420], narrow: [360, 300] },
  start(size, isNarrow) {
    const circles = someCircles(isNarrow ? 18 : 28, 23, size);
    // The largest has two hidden ones in it.
    const large = circles.reduce((a, b) => (b.r > a.r ? b : a));
    for (const side of [-0.45, 0.4])
      circles.push({ x: large.x + side * large.r, y: large.y + 0.2 * large.r, r: 0.3 * large.r });
    const diagram = new Diagram(triples(circles));
    const chosen = diagram.find(0.45 * size[0], 0.5 * size[1]);
    return { size, circles, diagram, chosen, step: 0, pointer: null };
  },
  draw(pen, state) {
    const { size, circles, diagram, chosen, step, pointer } = state;
    const gone = circles[chosen];
    const view = diagram.voronoi([0, 0, ...size]);
    const cell = view.renderCell(chosen);
    const isOpen = step >= 2;
    if (step < 4) pen.path(cell, isOpen ? "window" : "neighbor");
    const { ids, small } = smallDiagram(state);
    const isTold = (id: number) => step === 3 && !ids.includes(id);
    for (const [id, { x, y, r }] of circles.entries()) {
      if (id === chosen && isOpen) continue;
      const isHidden = diagram.isHidden(id) && !(step >= 3 && ids.includes(id));
      pen.circle(x, y, r, isTold(id) ? "quietEdge" : isHidden ? "hidden" : "circle");
    }
    if (step === 4) {
      const after = new Diagram(triples(circles.filter((_, id) => id !== chosen)));
      pen.path(after.voronoi([0, 0, ...size]).render(), "edge");
    } else pen.path(view.render(), "edge");
    if (step >= 3) {
      const { lost, kept } = cutEdges(small, size, gone);
      if (step === 3) pen.path(kept, "partEdge");
      pen.path(lost, "fresh");
    }
    if (step === 1) drawStar(pen, state);
    if (!isOpen) pen.circle(gone.x, gone.y, gone.r, "added");
    if (step === 0 && pointer) drawPointer(pen, ...pointer);
  },
  say(state): Said[] {
    const { diagram, circles, chosen, step } = state;
    const count = diagram.neighbors(chosen).length;
    const revived = covered(state, chosen).length;
    const more = revived === 0 ? "" : ` and of ${revived} that it had hidden`;
    if (step === 0)
      return [`${circles.length} circles. Press one of them to choose which one goes.`];
    if (step === 1) return ["It has ", [`${count} neighbours`, "dual"], "."];
    if (step === 2) return ["Its cell is open. No other cell has changed."];
    if (step === 3)
      return ["The ", ["small diagram", "dual"], ` of the ${count} neighbours${more}.`];
    const copy = Diagram.fromBytes(diagram.toBytes());
    copy.remove(chosen);
    const edges = copy.edges().sites.length / 2;
    copy.dispose();
    return [`The whole diagram again: ${circles.length - 1} circles, ${edges} edges.`];
  },
  press(state, at) {
    const id = state.diagram.pick(...at);
    // A hidden one has no cell: its going changes nothing.
    state.chosen = state.diagram.isHidden(id) ? state.diagram.coverOf(id) : id;
  },
  hover(state, at) {
    state.pointer = at;
  },
  steps: kStepping,
  controls: [
    stepChoice(kSteps),
    {
      kind: "button",
      label: "Another circle",
      act(state) {
        const { diagram, circles } = state;
        do state.chosen = (state.chosen + 1) % circles.length;
        while (diagram.isHidden(state.chosen));
      },
    },
  ],
  circles: ({ circles }) => triples(circles),
});
