// A Redis as a site has one: a port with a password, for any machine that may reach it.
import { spawn } from "node:child_process";
import { randomBytes } from "node:crypto";
import { mkdirSync } from "node:fs";
import { createServer } from "node:net";
import { Redis } from "ioredis";
import { listParts } from "../../../web/examples/cluster/parts.mjs";
import { readPlan } from "../../../web/examples/cluster/run.mjs";
import { until } from "./processes.mjs";

const servers = new Set();

/** A free port. */
function freePort(host) {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.once("error", reject);
    server.listen(0, host, () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/**
 * Starts a server with its files in a folder: {url, kill(), start(), pause()}. `kill` is -9; it
 * comes back at the same address with what its append-only file has, if it has one.
 */
export async function startRedis({ folder, bind = "127.0.0.1", settings = ["appendonly yes"] }) {
  mkdirSync(folder, { recursive: true });
  const password = randomBytes(12).toString("hex");
  const port = await freePort(bind);
  const url = `redis://:${password}@${bind}:${port}`;
  const lines = [`port ${port}`, `bind ${bind}`, `requirepass ${password}`, 'save ""', ...settings];
  let child;
  async function start() {
    child = spawn("redis-server", ["-"], { stdio: ["pipe", "ignore", "ignore"], cwd: folder });
    child.stdin.end(`${lines.join("\n")}\n`);
    const client = connected(url);
    await client.ping();
    client.disconnect();
  }
  async function kill() {
    if (child.exitCode !== null || child.signalCode !== null) return;
    child.kill("SIGKILL");
    await new Promise((resolve) => child.once("exit", resolve));
  }
  const server = { url, start, kill, pause: () => child.kill("SIGSTOP") };
  servers.add(server);
  await start();
  return server;
}

/** A client that waits for its Redis. */
export function connected(url) {
  const client = new Redis(url, { maxRetriesPerRequest: null });
  client.on("error", () => {});
  return client;
}

/** Ends all that a test has left running. */
export async function stopServers() {
  for (const { kill } of servers) await kill();
  servers.clear();
}

/** The plan of a work folder, as soon as it has one. */
export function planOf(work) {
  return until(() => readPlan(work));
}

/** The jobs of a work folder that have left a part. */
export async function partsIn(work) {
  const plan = await readPlan(work);
  return plan ? listParts(work, plan.run) : [];
}
