// The example's programs as processes.
import { spawn, spawnSync } from "node:child_process";
import path from "node:path";
import { root } from "../../../tools/toolchain/folders.mjs";

const example = path.join(root, "web/examples/cluster");
const running = new Set();

/**
 * Starts a program of the example: {child, output(), ended}, of which the last resolves to its exit
 * code. `before` are words in front of the command.
 */
export function start(program, args, { env = {}, before = [] } = {}) {
  const words = [...before, process.execPath, path.join(example, program), ...args];
  const { REDIS_URL: _, NODE_OPTIONS: __, ...inherited } = process.env;
  const child = spawn(words[0], words.slice(1), { env: { ...inherited, ...env } });
  let text = "";
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (more) => (text += more));
  const ended = new Promise((resolve) => child.once("close", resolve));
  running.add(child);
  ended.then(() => running.delete(child));
  return { child, output: () => text, ended };
}

/** Runs a program to its end and returns its output; throws an error with that if it fails. */
export async function finish(program, args, options) {
  const { output, ended } = start(program, args, options);
  const code = await ended;
  if (code !== 0) throw new Error(`${program} ended with ${code}:\n${output()}`);
  return output();
}

/** Ends all that a test has left running. */
export function stopAll() {
  for (const child of running) child.kill("SIGKILL");
}

/** The processes below one, each {pid, command}. */
export function childrenOf(pid) {
  const { stdout } = spawnSync("ps", ["-A", "-o", "pid=,ppid=,args="], { encoding: "utf8" });
  const all = [...stdout.matchAll(/^ *(\d+) +(\d+) (.*)$/gm)].map(([, own, parent, command]) => ({
    pid: Number(own),
    parent: Number(parent),
    command,
  }));
  const below = all.filter(({ parent }) => parent === pid);
  for (const each of below) below.push(...all.filter(({ parent }) => parent === each.pid));
  return below;
}

/** Does a process run? (A zombie, whose parent has not waited for it, has ended.) */
export function isAlive(pid) {
  const { stdout } = spawnSync("ps", ["-p", String(pid), "-o", "stat="], { encoding: "utf8" });
  return stdout.trim() !== "" && !stdout.startsWith("Z");
}

/** Does a text have lines of a stack trace? */
export const isStack = (text) => /^\s+at .*[:)]/m.test(text);

/** Waits until an action gives something true, which is returned. */
export async function until(action) {
  for (;;) {
    const found = await action();
    if (found) return found;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}
