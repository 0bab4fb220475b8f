// The programs that are compared: started once, kept warm, asked in turn. bench/native/contender.h
// describes their requests and answers.
import { spawn } from "node:child_process";
import path from "node:path";
import { createInterface } from "node:readline";
import { packed } from "../tests/wasm/support/install_packed.mjs";
import { native, root } from "./places.mjs";

/** The contenders, in the order of the report's columns. */
export const names = [
  "wasm",
  "native",
  "cgal",
  "delaunator",
  "d3-delaunay",
  "d3-voronoi-map",
  "flatbush",
  "d3-geo-voronoi",
  "d3-voronoi-treemap",
  "growth",
];

const node = (module, ...flags) => ({
  program: process.execPath,
  args: ["--max-old-space-size=8192", ...flags, path.join(root, "bench/js/contender.mjs"), module],
});
// One thread: the work of V8's collector and compiler beside it would count as the call's.
const kQuiet = ["--single-threaded", "--min-semi-space-size=64", "--max-semi-space-size=64"];
const commands = {
  wasm: node("ours"),
  native: { program: path.join(native, "native_bench"), args: [] },
  cgal: { program: path.join(native, "cgal_bench"), args: [] },
  delaunator: node("delaunator"),
  "d3-delaunay": node("d3_delaunay"),
  "d3-voronoi-map": node("d3_voronoi_map"),
  flatbush: node("flatbush"),
  "d3-geo-voronoi": node("d3_geo_voronoi"),
  "d3-voronoi-treemap": node("d3_voronoi_treemap"),
  growth: node("ours", ...kQuiet),
};

const running = new Map();
const kMostDeaths = 2;
// how often each ended by itself: one that keeps doing so is not started again
const deaths = new Map();

function start(name) {
  const { program, args } = commands[name];
  const child = spawn(program, args, {
    stdio: ["pipe", "pipe", "inherit"],
    env: { ...process.env, BENCH_PACKAGE: packed },
  });
  const contender = { child, receive: () => {} };
  createInterface({ input: child.stdout }).on("line", (line) => contender.receive(line));
  child.stdin.on("error", () => {}); // the child has ended, which "close" reports
  child.on("error", (error) => contender.receive(JSON.stringify({ error: error.message })));
  child.on("close", () => {
    if (running.get(name) !== contender) return; // it was stopped
    running.delete(name);
    deaths.set(name, (deaths.get(name) ?? 0) + 1);
    contender.receive(JSON.stringify({ error: "ended" }));
  });
  running.set(name, contender);
  return contender;
}

/**
 * One request, {op, set, ...}; resolves to the answer. After `timeout` seconds the contender is
 * stopped and started afresh.
 */
export function ask(name, request, timeout) {
  if (deaths.get(name) >= kMostDeaths) return Promise.resolve({ error: "ended" });
  const contender = running.get(name) ?? start(name);
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      stop(name);
      resolve({ error: `> ${timeout} s` });
    }, 1000 * timeout);
    contender.receive = (line) => {
      clearTimeout(timer);
      contender.receive = () => {};
      resolve(JSON.parse(line));
    };
    contender.child.stdin.write(
      `${Object.entries(request)
        .map(([key, value]) => `${key}=${value}`)
        .join(" ")}\n`,
    );
  });
}

/** Ends a contender; the next request starts it afresh. */
export function stop(name) {
  const contender = running.get(name);
  if (!contender) return;
  running.delete(name);
  contender.receive = () => {};
  contender.child.kill("SIGKILL");
}

export function stopAll() {
  for (const name of [...running.keys()]) stop(name);
}
