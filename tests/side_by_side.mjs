// The steps of a whole `npm test` in two lanes, each step a process of its own. The programs that
// steps need are installed at the same time, in the order in which they are needed. A lane that
// waits (for a browser, for Redis, for apt) leaves the processors to the other one.
import { fork } from "node:child_process";
import path from "node:path";
import { createInterface } from "node:readline";
import { root } from "../tools/toolchain/folders.mjs";
import { SetUpError } from "../tools/toolchain/process.mjs";
import { runLanes } from "./steps.mjs";

const build = ["npm", "native", "boost", "emscripten"];
/** Parts of tools/toolchain/setup.mjs that a step asks for. */
const needs = {
  lint: ["npm"],
  native: ["native", "boost"],
  wasm: ["native", "boost", "emscripten"],
  package: [...build, "browser", "firefox"],
  cluster: [...build, "redis"],
  web: [...build, "browser", "firefox"],
};
const apt = ["native", "boost", "emscripten", "browser", "firefox", "redis"]; // one at a time
const lanes = [
  ["native", "wasm", "web"],
  ["lint", "package", "cluster"],
];

/** Runs a script with its lines shown behind a name; resolves to its exit code and last message. */
function runScript(name, script, args) {
  return new Promise((resolve, reject) => {
    const child = fork(path.join(root, script), args, { cwd: root, silent: true });
    let message;
    child.on("message", (sent) => (message = sent));
    for (const [stream, sink] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      createInterface({ input: stream }).on("line", (line) => sink.write(`${name} | ${line}\n`));
    }
    child.on("error", reject);
    child.on("close", (code) => resolve({ code, message }));
  });
}

/** Starts to install what these steps need; by part, a promise that never rejects. */
function startSetUp(names) {
  const wanted = new Set(names.flatMap((name) => needs[name]));
  const set = (part) => runScript(`set-up ${part}`, "tools/toolchain/setup.mjs", [part]);
  // A failure here comes again, and says why, in the step that needs it.
  const ready = { npm: wanted.has("npm") ? set("npm") : undefined };
  let last = Promise.resolve();
  for (const part of apt.filter((name) => wanted.has(name))) {
    last = last.then(() => set(part));
    ready[part] = last;
  }
  return ready;
}

/** @param {string[]} names of steps @param {string[]} more arguments for each of them */
export function runSideBySide(names, more) {
  const ready = startSetUp(names);
  const inProcess = async (name) => {
    await Promise.all(needs[name].map((part) => ready[part]));
    const { code, message } = await runScript(name, "tests/run.mjs", [name, ...more]);
    if (code !== 0) throw new SetUpError(message ?? `ended with ${code}`);
    return message;
  };
  const chosen = lanes.map((lane) => lane.filter((name) => names.includes(name)));
  return runLanes(chosen.map((lane) => lane.map((name) => [name, () => inProcess(name)])));
}
