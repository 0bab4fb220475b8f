// One build at a time in a clone: `npm start` beside `npm test` would otherwise link the same files
// twice at once.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { root } from "./folders.mjs";
import { say } from "./process.mjs";

const file = path.join(root, "build/.lock");

function isAlive(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return error.code === "EPERM";
  }
}

function holder() {
  try {
    return Number(readFileSync(file, "utf8"));
  } catch {
    return null;
  }
}

/** Takes the lock if it is free, or if its holder is gone. */
function take() {
  try {
    writeFileSync(file, String(process.pid), { flag: "wx" });
    return true;
  } catch {
    const pid = holder();
    if (pid === 0 || pid === null || isAlive(pid)) return false;
    rmSync(file, { force: true });
    return false;
  }
}

/** Runs an action while no other build in this clone runs. */
export async function withBuildLock(action) {
  mkdirSync(path.dirname(file), { recursive: true });
  for (let isFirst = true; !take(); isFirst = false) {
    if (isFirst) say(`waiting for another build (process ${holder()}) to end`);
    await setTimeout(200);
  }
  try {
    return await action();
  } finally {
    rmSync(file, { force: true });
  }
}
