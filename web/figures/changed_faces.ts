// How many cells one insertion changes, against the number of circles: it does not grow.
import { Diagram } from "apollonius-diagram";
import { figure, type Size } from "../figure/figure.js";
import { randomCircles } from "../shared/random_sets.js";

const kCounts = [10, 100, 1_000, 10_000];
const kMore = 100_000;
const kInsertions = 100;
const kRounds = 5;
const kMost = 10; // cells on the scale

type Measured = { count: number; cells: number; micros: number | null };
type State = { size: Size; seed: number; rows: Measured[]; xyrs: Float64Array[] };

/** Circles, and behind them those that come one by one. */
const circlesOf = (count: number, seed: number) =>
  randomCircles({ count: count + kInsertions, hiddenShare: 0, seed, width: 1000, height: 1000 });

/** The mean number of cells that change when one circle comes: its neighbours, and its own. */
function changedCells(xyr: Float64Array, count: number) {
  const diagram = new Diagram(xyr.subarray(0, 3 * count));
  let sum = 0;
  for (let k = count; k < count + kInsertions; k++) {
    const id = diagram.insert(xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]);
    sum += diagram.neighbors(id).length + 1;
    diagram.remove(id);
  }
  diagram.dispose();
  return sum / kInsertions;
}

/** Microseconds to insert a circle and to remove it again, here and now: the best round. */
function timeOf(xyr: Float64Array, count: number) {
  const diagram = new Diagram(xyr.subarray(0, 3 * count));
  let best = Infinity;
  for (let round = 0; round < kRounds; round++) {
    const begin = performance.now();
    for (let k = count; k < count + kInsertions; k++)
      diagram.remove(diagram.insert(xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]));
    best = Math.min(best, performance.now() - begin);
  }
  diagram.dispose();
  return (1000 * best) / kInsertions;
}

function add(state: State, count: number) {
  const xyr = circlesOf(count, state.seed);
  state.rows.push({ count, cells: changedCells(xyr, count), micros: null });
  state.xyrs.push(xyr);
}

function restart(state: State) {
  state.rows = [];
  state.xyrs = [];
  for (const count of kCounts) add(state, count);
}

const named = (count: number) => String(count).replace(/\B(?=(\d{3})+$)/g, " ");

export default figure<State>({
  size: { wide: [740, 260], narrow: [370, 270] },
  start(size) {
    const state: State = { size, seed: 1, rows: [], xyrs: [] };
    restart(state);
    return state;
  },
  draw(pen, { size, rows }) {
    const [left, right] = [size[0] < 500 ? 80 : 110, size[0] < 500 ? 84 : 120];
    const unit = (size[0] - left - right) / kMost;
    const top = 40;
    const step = (size[1] - top - 8) / 5;
    pen.text("circles", left - 12, 18, "quiet", { align: "end", size: 13 });
    pen.text("cells that change", left, 18, "quiet", { size: 13 });
    pen.text("in and out", size[0] - 12, 18, "quiet", { align: "end", size: 13 });
    for (let k = 0; k <= kMost; k += 2) {
      const x = left + k * unit;
      pen.line(x, top - 6, x, size[1] - 12, "frame");
    }
    for (const [k, { count, cells, micros }] of rows.entries()) {
      const y = top + k * step;
      const middle = y + step / 2;
      pen.text(named(count), left - 12, middle, "name", { align: "end" });
      pen.rectangle(left, y + 0.15 * step, cells * unit, 0.7 * step, "bar");
      pen.text(cells.toFixed(1), left + cells * unit + 8, middle, "name", { isBold: true });
      if (micros !== null)
        pen.text(`${micros.toFixed(0)} µs`, size[0] - 12, middle, "name", { align: "end" });
    }
  },
  say({ rows }) {
    const [first, last] = [rows[0], rows[rows.length - 1]];
    return [
      `From ${named(first.count)} to ${named(last.count)} circles: `,
      [`${first.cells.toFixed(1)} to ${last.cells.toFixed(1)} cells`, "neighbor"],
      ` change for one circle that comes (mean of ${kInsertions}).`,
      last.micros === null ? "" : ` One in and out again: ${last.micros.toFixed(0)} µs here.`,
    ];
  },
  tick(state) {
    // Once, when the figure is seen: the time depends on the machine, so no poster has it.
    for (const [k, row] of state.rows.entries()) row.micros ??= timeOf(state.xyrs[k], row.count);
    return false;
  },
  controls: [
    {
      kind: "button",
      label: "Other circles",
      act(state) {
        state.seed++;
        restart(state);
      },
    },
    {
      kind: "button",
      label: `Add ${named(kMore)}`,
      act: (state) => add(state, kMore),
      isDisabled: ({ rows }) => rows.length > kCounts.length,
    },
  ],
});
