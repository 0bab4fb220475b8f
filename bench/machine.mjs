// The machine that the numbers were measured on.
import { readFileSync } from "node:fs";
import { cpus, loadavg, release, totalmem } from "node:os";
import path from "node:path";
import { measuredCommit } from "../tools/figures.mjs";
import { ensureEmscripten } from "../tools/toolchain/emscripten.mjs";
import { capture } from "../tools/toolchain/process.mjs";
import { hasCgal } from "./prepare.mjs";
import { root } from "./places.mjs";

function attempt(action) {
  try {
    return action();
  } catch {
    return "unknown";
  }
}

const firstLine = (text) => text.split("\n")[0].trim();

function distribution() {
  return /^PRETTY_NAME="(.*)"$/m.exec(readFileSync("/etc/os-release", "utf8"))[1];
}

function compiler() {
  const cache = readFileSync(path.join(root, "build/bench/CMakeCache.txt"), "utf8");
  return firstLine(capture(/^CMAKE_CXX_COMPILER:\w+=(.*)$/m.exec(cache)[1], ["--version"]));
}

const installed = (name) =>
  JSON.parse(readFileSync(path.join(root, "node_modules", name, "package.json"), "utf8")).version;

function cgal() {
  return /CGAL_VERSION (\S+)/.exec(readFileSync("/usr/include/CGAL/version.h", "utf8"))[1];
}

export function machine() {
  const [{ model }] = cpus();
  return {
    cpu: model.trim(),
    cores: cpus().length,
    memory: `${Math.round(totalmem() / 2 ** 30)} GiB`,
    system: attempt(() => `${distribution()}, Linux ${release()}`),
    node: process.version,
    v8: process.versions.v8,
    emscripten: attempt(() =>
      readFileSync(path.join(ensureEmscripten(), "emscripten-version.txt"), "utf8")
        .replaceAll('"', "")
        .trim(),
    ),
    compiler: attempt(compiler),
    cgal: hasCgal ? attempt(cgal) : "not installed",
    delaunator: attempt(() => installed("delaunator")),
    "d3-delaunay": attempt(() => installed("d3-delaunay")),
    flatbush: attempt(() => installed("flatbush")),
    commit: attempt(measuredCommit),
    date: new Date().toISOString().slice(0, 10),
    load: loadavg()[0].toFixed(2), // by other programs, before the run
  };
}
