// Operations that are done and undone: at each place of the history, the diagram that has come this
// way is compared with one that is built afresh of the same circles.
import { Diagram } from "apollonius-diagram";
import { figure, type Size } from "../figure/figure.js";
import { drawDot } from "../figure/pen.js";
import { generator } from "../shared/random_sets.js";
import { type Circle, someCircles, triples } from "./changing.js";
import { byCircle, differing, edgeNames } from "./graphs.js";

const kOperations = 200;
const kSpeed = 40; // operations a second
const kUnit = 20; // centres are on a grid of this unit, so that many circles touch one

/** A circle that comes has no `before`, one that goes no `after`. */
type Operation = { key: number; before?: Circle; after?: Circle };
type State = {
  size: Size;
  operations: Operation[];
  diagram: Diagram;
  ids: Map<number, number>; // by the key of a circle
  done: number;
  compared: number;
  different: number;
  edges: number;
  going: number; // 1 forwards, -1 backwards, 0 not at all
  time: number;
};

/** Inserts, removes and moves, with the circles that there are then. */
function makeOperations(circles: readonly Circle[], [width, height]: Size) {
  const random = generator(5);
  const now = new Map(circles.map((circle, key) => [key, circle] as const));
  const operations: Operation[] = [];
  const place = (r: number): Circle => ({
    x: kUnit * Math.round((random() * width) / kUnit),
    y: kUnit * Math.round((random() * height) / kUnit),
    r,
  });
  for (let k = 0; k < kOperations; k++) {
    const keys = [...now.keys()];
    const choice = random();
    const old = keys[Math.floor(random() * keys.length)];
    const before = now.get(old);
    if (choice < 0.35 || !before) {
      const key = circles.length + k;
      const after = place([3, 6, 6, 10, 16][Math.floor(5 * random())]);
      operations.push({ key, after });
      now.set(key, after);
    } else if (choice < 0.65) {
      operations.push({ key: old, before });
      now.delete(old);
    } else {
      const after = place(before.r);
      operations.push({ key: old, before, after });
      now.set(old, after);
    }
  }
  return operations;
}

function change({ diagram, ids }: State, key: number, before?: Circle, after?: Circle) {
  const id = ids.get(key);
  if (before && after && id !== undefined) diagram.update(id, after.x, after.y, after.r);
  else if (after) ids.set(key, diagram.insert(after.x, after.y, after.r));
  else if (id !== undefined) {
    diagram.remove(id);
    ids.delete(key);
  }
}

/** Compares with the diagram that is built afresh. */
function compare(state: State) {
  const { diagram } = state;
  const fresh = Diagram.from([...diagram]);
  const edges = edgeNames(diagram, byCircle(diagram));
  const isSame = differing(edges, edgeNames(fresh, byCircle(fresh))) === 0;
  fresh.dispose();
  state.edges = edges.length;
  state.compared++;
  if (!isSame) state.different++;
}

function goTo(state: State, place: number) {
  const { operations } = state;
  while (state.done !== place) {
    if (state.done < place) {
      const { key, before, after } = operations[state.done++];
      change(state, key, before, after);
    } else {
      const { key, before, after } = operations[--state.done];
      change(state, key, after, before);
    }
    compare(state);
  }
}

const kEmpty = { done: 0, compared: 0, different: 0, edges: 0, going: 0, time: 0 };

export default figure<State>({
  size: { wide: [740, 360], narrow: [360, 320] },
  start(size, isNarrow) {
    const circles = someCircles(isNarrow ? 16 : 36, 3, size).map(({ x, y, r }) => ({
      x: kUnit * Math.round(x / kUnit),
      y: kUnit * Math.round(y / kUnit),
      r: Math.round(0.6 * r),
    }));
    const diagram = new Diagram(triples(circles));
    const ids = new Map(circles.map((_, key) => [key, key] as const));
    const state = { size, operations: makeOperations(circles, size), diagram, ids, ...kEmpty };
    compare(state);
    goTo(state, 60);
    return state;
  },
  draw(pen, { size, diagram, operations, done }) {
    for (const { x, y, r, hidden } of diagram) {
      pen.circle(x, y, r, hidden ? "hidden" : "circle");
      if (r < 4) drawDot(pen, x, y, "bar", 2.5);
    }
    pen.path(diagram.voronoi([0, 0, ...size]).render(), "edge");
    const last = operations[done - 1];
    if (!last) return;
    const { before, after } = last;
    if (before) pen.circle(before.x, before.y, Math.max(before.r, 5), "partEdge");
    if (after) pen.circle(after.x, after.y, Math.max(after.r, 5), "added");
    if (before && after) pen.line(before.x, before.y, after.x, after.y, "partEdge");
  },
  say({ done, edges, compared, different, diagram, operations }) {
    const last = operations[done - 1];
    const what = !last ? "" : !last.before ? " (added)" : !last.after ? " (removed)" : " (moved)";
    return [
      `After ${done} operations${what}: ${diagram.size} circles, ${edges} edges. `,
      different === 0
        ? [`The same as built afresh, edge for edge: ${compared} of ${compared} times.`, "dual"]
        : [`Different from what is built afresh: ${different} of ${compared} times.`, "wrong"],
    ];
  },
  tick(state, seconds) {
    if (state.going === 0) return false;
    state.time += seconds * kSpeed;
    const steps = Math.floor(state.time);
    state.time -= steps;
    const place = Math.max(0, Math.min(kOperations, state.done + state.going * steps));
    goTo(state, place);
    if (place === (state.going > 0 ? kOperations : 0)) state.going = 0;
    return true;
  },
  controls: [
    {
      kind: "slider",
      label: "Operations done",
      min: 0,
      max: kOperations,
      step: 1,
      get: ({ done }) => done,
      set: (state, value) => {
        state.going = 0;
        goTo(state, value);
      },
    },
    {
      kind: "button",
      label: ({ going }) => (going < 0 ? "Stop" : "Undo all"),
      act: (state) => {
        state.going = state.going < 0 ? 0 : -1;
      },
    },
    {
      kind: "button",
      label: ({ going }) => (going > 0 ? "Stop" : "Redo all"),
      act: (state) => {
        state.going = state.going > 0 ? 0 : 1;
      },
    },
  ],
  circles: ({ diagram }) => diagram.sites().xyr,
});
