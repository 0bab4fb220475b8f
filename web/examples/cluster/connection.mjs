// The connection of submit and build to Redis, for as long as a run takes: the folder's own Redis
// is started again when it has ended; the one of REDIS_URL is waited for, but not for ever.
import { setTimeout } from "node:timers/promises";
import { Redis } from "ioredis";
import { wordsOf } from "./command_line.mjs";
import { openRedis } from "./redis.mjs";

const kLook = 500; // milliseconds between two looks at whether it is back
const kGoOn = "Start this again when Redis can run: what is done is kept.";

/**
 * Connects to the Redis of a run. `lost` rejects when that has been away for `patience` seconds, or
 * cannot be started again; commands wait until then. `close` also ends a Redis of the folder's own.
 */
export async function connect(folder, { patience }) {
  const { url, isOwn, stop } = await openRedis(folder).catch((error) => {
    throw new Error(`${wordsOf(error)}\n${kGoOn}`);
  });
  // Commands wait until it is back, as BullMQ asks for; one that says nothing is away, too.
  const redis = new Redis(url, { maxRetriesPerRequest: null, socketTimeout: 1000 * patience });
  const { host, port, path: place = `${host}:${port}` } = redis.options;
  let why = "the connection was closed";
  redis.on("error", (error) => (why = wordsOf(error)));

  let isOpen = true;
  async function bringBack() {
    console.error(`\nRedis at ${place} is away (${why})${isOwn ? ": it is started again" : ""}`);
    for (let waited = 0; isOpen && redis.status !== "ready"; waited += kLook) {
      if (waited >= 1000 * patience) throw new Error(`no answer for ${patience} s (${why})`);
      if (isOwn) await openRedis(folder);
      await setTimeout(kLook);
    }
  }

  let attempt; // to bring it back, if one is under way
  const lost = new Promise((_, reject) => {
    redis.on("close", () => {
      if (!isOpen) return;
      attempt ??= bringBack()
        .catch((error) => reject(new Error(`Redis at ${place}: ${wordsOf(error)}\n${kGoOn}`)))
        .finally(() => (attempt = undefined));
    });
  });
  lost.catch(() => {}); // who waits for something else waits for this, too

  async function close() {
    isOpen = false;
    redis.disconnect();
    await attempt;
    await stop();
  }
  return { redis, lost, close };
}
