// Building and asking, measured in the reader's browser: this library with circles, and two that
// know points only with their centres. The work is done in a worker, so that the page goes on.
import { figure, type Size } from "../figure/figure.js";
import type { LookName, Pen } from "../figure/pen.js";
import type { Measured, Told } from "./measure/measure_worker.js";

const kCounts = [100, 300, 1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000];
const kMostAtOnce = 100_000; // below it the slider measures by itself

type Name = keyof Measured;
const kRows: readonly (readonly [Name, string, LookName])[] = [
  ["build", "this, circles", "bar"],
  ["buildDelaunator", "delaunator, points", "otherBar"],
  ["buildFlatbush", "flatbush, points", "thirdBar"],
  ["findMany", "this, findMany", "bar"],
  ["find", "this, find", "bar"],
  ["findFlatbush", "flatbush, points", "thirdBar"],
];
const kTitles: Partial<Record<Name, string>> = {
  build: "Build: microseconds a circle",
  findMany: "Find the nearest: microseconds a query",
};

type State = {
  size: Size;
  isNarrow: boolean;
  level: number;
  /** The measurement that the rows show. */
  measured: { count: number; times: Measured } | null;
  running: { worker: Worker; what: string } | null;
  error: string;
  /** It has just ended, which the controls do not show yet. */
  hasEnded: boolean;
};

const grouped = (count: number) => String(count).replace(/\B(?=(\d{3})+$)/g, " ");

function stop(state: State) {
  state.running?.worker.terminate();
  state.hasEnded = state.running !== null;
  state.running = null;
}

function measure(state: State) {
  stop(state);
  state.error = "";
  const count = kCounts[state.level];
  const worker = new Worker(new URL("./measure/measure_worker.ts", import.meta.url), {
    type: "module",
  });
  const running = { worker, what: "Loading" };
  state.running = running;
  const fail = (message: string) => {
    state.error = message;
    stop(state);
  };
  worker.onerror = ({ message }) => fail(message || "its code cannot be loaded");
  worker.onmessage = ({ data: told }: MessageEvent<Told>) => {
    if (told.kind === "progress") running.what = told.what;
    else if (told.kind === "failed") fail(told.message);
    else {
      state.measured = { count, times: told.times };
      stop(state);
    }
  };
  worker.postMessage({ count });
}

function drawRows(pen: Pen, { size, isNarrow, measured }: State) {
  const [left, row] = isNarrow ? [138, 30] : [150, 32];
  const room = size[0] - left - (isNarrow ? 80 : 190);
  const times = measured?.times;
  let most = 1; // of the rows below one title
  let y = 6;
  for (const [name, label, look] of kRows) {
    const title = kTitles[name];
    if (title) {
      const isBuild = name === "build";
      const group = kRows.filter(([other]) => other.startsWith("build") === isBuild);
      if (times) most = Math.max(...group.map(([other]) => times[other]));
      y += isBuild ? 14 : 24;
      pen.text(title, 10, y, "name", { isBold: true, size: 14 });
      y += 28;
    }
    pen.text(label, left - 8, y, "name", { align: "end", size: 13 });
    const length = times ? Math.max(1, (room * times[name]) / most) : 1;
    pen.rectangle(left, y - 9, length, 18, look);
    if (measured && times) {
      const each = `${times[name].toPrecision(3)} µs`;
      const total = (times[name] * measured.count) / 1000;
      const all = name.startsWith("build") ? `, ${total.toPrecision(3)} ms in all` : "";
      const text = isNarrow ? each : each + all;
      pen.text(text, left + length + 8, y, "name", { size: 13 });
    }
    y += row;
  }
}

const brief = (ratio: number) => (ratio < 10 ? ratio.toFixed(1) : ratio.toFixed(0));
/** As "1.3 times as fast as", from the first one's point of view. */
const against = (own: number, other: number) =>
  own <= other
    ? `${brief(other / own)} times as fast as`
    : `${brief(own / other)} times as slow as`;

export default figure<State>({
  needs: [],
  size: { wide: [740, 300], narrow: [370, 292] },
  start: (size, isNarrow) => ({
    size,
    isNarrow,
    level: 6,
    measured: null,
    running: null,
    error: "",
    hasEnded: false,
  }),
  draw(pen, state) {
    drawRows(pen, state);
    if (state.measured) return;
    const x = state.isNarrow ? 230 : 300;
    pen.text("Press Measure.", x, state.size[1] / 2 - 6, "quiet", { size: 14 });
  },
  say({ measured, running, error, level }) {
    if (error) return [["Not measured: ", "wrong"], error];
    if (running) return [`${grouped(kCounts[level])} circles. ${running.what} …`];
    if (!measured) return ["Nothing has been measured yet."];
    const { count, times } = measured;
    return [
      `${grouped(count)} circles on this machine: building is `,
      [`${against(times.build, times.buildDelaunator)} delaunator`, "edge"],
      ` and ${against(times.build, times.buildFlatbush)} flatbush; a query of findMany is `,
      [`${against(times.findMany, times.findFlatbush)} flatbush's`, "edge"],
      `, one of find ${against(times.find, times.findFlatbush)} it.`,
    ];
  },
  tick(state) {
    const { hasEnded } = state;
    state.hasEnded = false;
    return state.running !== null || hasEnded;
  },
  controls: [
    {
      kind: "slider",
      label: "Circles",
      min: 0,
      max: kCounts.length - 1,
      step: 1,
      get: ({ level }) => level,
      set(state, level) {
        state.level = level;
        if (kCounts[level] < kMostAtOnce) measure(state);
        else stop(state);
      },
      show: ({ level }) => grouped(kCounts[level]),
    },
    {
      kind: "button",
      label: "Measure",
      act: measure,
      isDisabled: ({ running }) => running !== null,
    },
    {
      kind: "button",
      label: "Cancel",
      act: stop,
      isDisabled: ({ running }) => running === null,
    },
  ],
});
