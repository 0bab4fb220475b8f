// The connection of submit and build to Redis, for as long as a run takes.
import { setTimeout } from "node:timers/promises";
import { Redis } from "ioredis";
import { wordsOf } from "./command_line.mjs";

const kLook = 500; // milliseconds between two looks at whether it is there
const kMemory = 60; // seconds that Redis keeps what was written to see whether it can
const kGoOn = "Start this again when Redis can run: what is done is kept.";

/**
 * Connects to the Redis of a run. `lost` rejects when that has not answered for `patience` seconds,
 * whatever is the reason, or takes no data: its disk may be full. Commands wait until it answers.
 */
export function connect(url, { patience, key }) {
  // Commands wait until it is back, as BullMQ asks for. A connection that says nothing is tried
  // once more before patience ends.
  const redis = new Redis(url, { maxRetriesPerRequest: null, socketTimeout: 500 * patience });
  const { host, port, path: place = `${host}:${port}` } = redis.options;
  let why = "it says nothing";
  let isThere = false;
  redis.on("error", (error) => (why = wordsOf(error)));
  redis.on("ready", () => (isThere = true));
  redis.on("close", () => {
    if (isThere && isOpen) console.error(`\nRedis at ${place} is away (${why})`);
    isThere = false;
  });

  let isOpen = true;
  async function watch() {
    while (isOpen) {
      const late = new AbortController();
      const { signal } = late;
      const silence = setTimeout(1000 * patience, undefined, { signal }).then(() => {
        throw new Error(`no answer for ${patience} s (${why})`);
      });
      try {
        await Promise.race([redis.set(key, "", "EX", kMemory), silence]);
      } finally {
        silence.catch(() => {});
        late.abort();
      }
      await setTimeout(kLook);
    }
  }
  const lost = new Promise((_, reject) => {
    watch().catch((error) => {
      if (isOpen) reject(new Error(`Redis at ${place}: ${wordsOf(error)}\n${kGoOn}`));
    });
  });
  lost.catch(() => {}); // until somebody waits for it

  function close() {
    isOpen = false;
    redis.disconnect();
  }
  return { redis, lost, close };
}
