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
const takenPort = (folder, port) =>
  `\nAnother program may have port ${port}. If so, end it; or remove ${addressFile(folder)}, ` +
  "which names the port, and start workers again.";
const kAttempts = 3;

const addressFile = (folder) => path.join(folder, "redis/url");

/** The address of the folder's own Redis; undefined if it never had one. */
function ownAddress(folder) {
  try {
    return readFileSync(addressFile(folder), "utf8").trim() || undefined;
  } catch {
    return undefined;
  }
}

/**
 * Leaves an address in the folder before a Redis is started there, so that no second one, with
 * another port, ever writes to its files. Returns the one that is there.
 */
function keepAddress(folder, url) {
  try {
    writeFileSync(addressFile(folder), `${url}\n`, { mode: 0o600, flag: "wx" });
  } catch (error) {
    if (error.code !== "EEXIST") throw error;
    const other = ownAddress(folder); // by someone who started at the same time
    if (other) return other;
    writeFileSync(addressFile(folder), `${url}\n`); // by someone who was killed meanwhile
  }
  return url;
}

/** REDIS_URL, if it is set. */
function givenAddress() {
  const url = process.env.REDIS_URL;
  if (url?.includes("://") && !URL.canParse(url))
    throw new Error("REDIS_URL cannot be read: it is like redis://:password@host:6379");
  return url;
}

/** REDIS_URL, or the address of the folder's own Redis as soon as that runs. */
export async function redisAddress(folder) {
  const given = givenAddress();
  if (given) return given;
  for (let isFirst = true; ; isFirst = false) {
    const own = ownAddress(folder);
    if (own && (await answers(own))) return own;
    if (isFirst) console.error(`Waiting for submit.mjs or build.mjs to start Redis in ${folder}`);
    await setTimeout(500);
  }
}

/**
 * REDIS_URL, or the folder's own Redis, which is started if it does not run. `stop` ends only the
 * latter.
 */
export async function openRedis(folder) {
  const given = givenAddress();
  if (given) return { url: given, isOwn: false, async stop() {} };
  for (let attempt = 1; ; ++attempt) {
    const known = ownAddress(folder);
    if (known && (await answers(known)))
      return { url: known, isOwn: true, stop: () => stopRedis(folder) };
    try {
      await startRedis({ folder });
    } catch (error) {
      // It may have been killed, or another one starts, or still reads its file.
      if (error.message === missing || attempt === kAttempts) throw error;
      await setTimeout(1000);
    }
  }
}

/**
 * Starts a Redis with a password and an append-only file in `folder`/redis, on the port that it had
 * or a free one, and returns its address once it answers. The settings go through its standard
 * input, so that no list of processes shows the password.
 */
export async function startRedis({ folder, bind = "127.0.0.1" }) {
  const home = path.resolve(folder, "redis");
  mkdirSync(home, { recursive: true });
  const password = randomBytes(24).toString("base64url");
  const url =
    ownAddress(folder) ??
    keepAddress(folder, `redis://:${password}@${bind}:${await freePort(bind)}`);
  const { hostname, port, password: kept } = new URL(url);
  const settings = [
    `port ${port}`,
    `bind ${hostname}`,
    `requirepass ${kept}`,
    `dir ${JSON.stringify(home)}`,
    "appendonly yes",
    'save ""',
    "maxmemory-policy noeviction", // BullMQ asks for that
  ];
  const server = spawn("redis-server", ["-"], { stdio: "pipe" });
  let log = "";
  for (const stream of [server.stdout, server.stderr])
    stream.on("data", (text) => (log = (log + text).slice(-1000)));
  const ended = new Promise((_, reject) => {
    server.once("error", ({ code }) =>
      reject(new Error(code === "ENOENT" ? missing : `redis-server cannot be started: ${code}`)),
    );
    server.once("close", (code, signal) => {
      const hint = log.includes("Address already in use") ? takenPort(folder, port) : "";
      reject(new Error(`redis-server ended with ${code ?? signal}:\n${log.trim()}${hint}`));
    });
  });
  ended.catch(() => {}); // after it has answered, its end is noticed by those who are connected
  server.stdin.on("error", () => {}); // "error" and "close" tell
  server.stdin.end(`${settings.join("\n")}\n`);
  let hasEnded = false;
  const untilItAnswers = async () => {
    while (!hasEnded && !(await answers(url))) await setTimeout(50);
  };
  await Promise.race([ended, untilItAnswers()]).finally(() => (hasEnded = true));
  for (const each of [server, server.stdout, server.stderr]) each.unref(); // it may outlive us
  return url;
}

/** What an action gives for a connection of its own; undefined if there is none, or it ends. */
async function connected(url, action) {
  const client = new Redis(url, { lazyConnect: true, retryStrategy: null, socketTimeout: 10_000 });
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
