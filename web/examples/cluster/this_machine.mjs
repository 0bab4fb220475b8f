// Without REDIS_URL: a Redis and workers on this machine, for as long as the program that starts
// them. They hold pipes to it, so they end with it however it ends; nothing of that Redis is kept.
import { fork, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

const missing =
  "redis-server is not installed. Debian, Ubuntu: apt-get install redis-server; macOS: brew " +
  "install redis; or set REDIS_URL to a Redis that runs somewhere (rediss://… with TLS).";
const kGoOn = "Start this again: what is done is kept.";

// Becomes Redis; beside it waits, whatever Ctrl-C ends, what ends it when the pipe from here is
// closed.
const script = `
exec 3<&0
{ trap '' INT HUP TERM; read -r nothing <&3; kill -9 $$; rm -rf "$0"; } >/dev/null 2>&1 &
exec redis-server "$@" 3<&- </dev/null`;
const settings = {
  port: "0", // a socket in a folder of its own, which nobody else may enter
  save: "",
  "maxmemory-policy": "noeviction", // BullMQ asks for that
  loglevel: "warning",
};
const worker = fileURLToPath(new URL("worker.mjs", import.meta.url));

/** The last words of a process, and a promise that it ends. */
function watched(child, streams) {
  let log = "";
  for (const stream of streams) stream.on("data", (text) => (log = (log + text).slice(-1000)));
  const ended = new Promise((resolve) => {
    child.once("error", ({ code }) => resolve({ code, log }));
    child.once("close", (code, signal) => resolve({ code: code ?? signal, log: log.trim() }));
  });
  return ended;
}

function startRedis() {
  const dir = mkdtempSync(path.join(tmpdir(), "apollonius-"));
  const url = path.join(dir, "redis.sock");
  const words = Object.entries({ ...settings, dir, unixsocket: url }).flatMap(([name, value]) => [
    `--${name}`,
    value,
  ]);
  const server = spawn("sh", ["-c", script, dir, ...words]);
  server.stdin.on("error", () => {}); // that it has ended is told by `ended`
  const ended = watched(server, [server.stdout, server.stderr]);
  ended.then(() => rmSync(dir, { recursive: true, force: true })); // if there was no `sh`
  return { url, ended, stop: () => server.stdin.end() };
}

function startWorker(folder, url) {
  const env = { ...process.env, REDIS_URL: url };
  const stdio = ["ignore", "ignore", "pipe", "ipc"];
  const child = fork(worker, ["--folder", folder], { env, stdio });
  const ended = watched(child, [child.stderr]);
  return { ended, stop: () => child.kill("SIGKILL") };
}

/**
 * Starts Redis and workers. `lost` rejects when one of them ends before `close`, which ends them
 * all.
 */
export function startHere(folder, count = availableParallelism()) {
  const redis = startRedis();
  const workers = Array.from({ length: count }, () => startWorker(folder, redis.url));
  const lost = Promise.race([
    redis.ended.then(({ code, log }) => {
      if (code === "ENOENT" || code === 127) throw new Error(missing);
      throw new Error(`redis-server ended with ${code}:\n${log}\n${kGoOn}`);
    }),
    ...workers.map(async ({ ended }) => {
      const { code, log } = await ended;
      throw new Error(`A worker ended with ${code}:\n${log}\n${kGoOn}`);
    }),
  ]);
  lost.catch(() => {}); // until somebody waits for it
  async function close() {
    for (const each of [redis, ...workers]) each.stop();
    await Promise.all([redis, ...workers].map(({ ended }) => ended));
  }
  return { url: redis.url, lost, close };
}
