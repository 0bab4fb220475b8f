// Which Redis: the one of REDIS_URL; else one of our own on this machine, which lives in the work
// folder and comes back as it was (append-only file, port, password).
import { spawn } from "node:child_process";
import { randomBytes } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { Redis } from "ioredis";

const missing =
  "redis-server is not installed. Debian, Ubuntu: apt-get install redis-server; macOS: brew " +
  "install redis; or set REDIS_URL to a Redis that runs somewhere (rediss://… with TLS).";

/** The address that `openRedis` left in the work folder; undefined if there is none. */
function ownAddress(folder) {
  try {
    return readFileSync(path.join(folder, "redis/url"), "utf8").trim();
  } catch {
    return undefined;
  }
}

/** REDIS_URL, or the address of the folder's own Redis as soon as there is one. */
export async function redisAddress(folder) {
  for (let isFirst = true; ; isFirst = false) {
    const address = process.env.REDIS_URL ?? ownAddress(folder);
    if (address) return address;
    if (isFirst) console.error(`Waiting for submit.mjs or build.mjs to start Redis in ${folder}`);
    await setTimeout(500);
  }
}

/**
 * REDIS_URL, or the folder's own Redis, which is started if it does not run. `stop` ends only the
 * latter.
 */
export async function openRedis(folder) {
  if (process.env.REDIS_URL) return { url: process.env.REDIS_URL, stop: async () => {} };
  const known = ownAddress(folder);
  const url = known && (await answers(known)) ? known : await startRedis({ folder, known });
  return { url, stop: () => stopRedis(folder) };
}

/**
 * Starts a Redis with a password and an append-only file in `folder`/redis, on the port that it had
 * or a free one, and returns its address once it answers. The settings go through its standard
 * input, so that no list of processes shows the password.
 */
export async function startRedis({ folder, known, bind = "127.0.0.1" }) {
  const home = path.resolve(folder, "redis");
  mkdirSync(home, { recursive: true });
  const { port, password } = known
    ? new URL(known)
    : { port: await freePort(bind), password: randomBytes(24).toString("base64url") };
  const settings = [
    `port ${port}`,
    `bind ${bind}`,
    `requirepass ${password}`,
    `dir ${JSON.stringify(home)}`,
    "appendonly yes",
    'save ""',
    "maxmemory-policy noeviction", // BullMQ asks for that
  ];
  const server = spawn("redis-server", ["-"], { stdio: "pipe" });
  let log = "";
  for (const stream of [server.stdout, server.stderr])
    stream.on("data", (text) => (log = (log + text).slice(-4000)));
  const ended = new Promise((_, reject) => {
    server.once("error", ({ code }) =>
      reject(new Error(code === "ENOENT" ? missing : `redis-server cannot be started: ${code}`)),
    );
    server.once("exit", (code) => reject(new Error(`redis-server ended with ${code}:\n${log}`)));
  });
  ended.catch(() => {}); // after it has answered, its end is noticed by those who are connected
  server.stdin.on("error", () => {}); // "error" and "exit" tell
  server.stdin.end(`${settings.join("\n")}\n`);
  const url = `redis://:${password}@${bind}:${port}`;
  await Promise.race([ended, untilItAnswers(url)]);
  for (const each of [server, server.stdout, server.stderr]) each.unref(); // it may outlive us
  writeFileSync(path.join(home, "url"), `${url}\n`, { mode: 0o600 });
  return url;
}

async function untilItAnswers(url) {
  while (!(await answers(url))) await setTimeout(50);
}

/** What an action gives for a connection of its own; undefined if there is none, or it ends. */
async function connected(url, action) {
  const client = new Redis(url, { lazyConnect: true, retryStrategy: null });
  client.on("error", () => {});
  try {
    await client.connect();
    return await action(client);
  } catch {
    return undefined;
  } finally {
    if (client.status !== "end") client.disconnect();
  }
}

/** Whether a Redis is there and has read its append-only file. */
async function answers(url) {
  return (await connected(url, (client) => client.ping())) === "PONG";
}

/** Ends the folder's own Redis, if it runs. */
export async function stopRedis(folder) {
  const url = ownAddress(folder);
  if (url) await connected(url, (client) => client.shutdown());
}

/** A port that nobody listens on. */
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
