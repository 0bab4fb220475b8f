// Snapshots in Redis: each once, under the hash of its bytes, in pieces (a value of Redis holds 512
// MB at most, some nine million sites).
import { createHash } from "node:crypto";
import { Diagram } from "apollonius-diagram";

const kPiece = 16 << 20;
const kWeek = 7 * 24 * 3600;
const keyOf = (hash) => `apollonius:snapshot:${hash}`;

/** A snapshot that is not in Redis, or was damaged there: `putSnapshot` helps. */
export class NoSnapshot extends Error {}

export function hashOf(bytes) {
  return createHash("sha256").update(bytes).digest("hex");
}

/** Puts a snapshot into Redis, for a week, unless it is there; the length, of a whole one, last. */
export async function putSnapshot(redis, hash, bytes) {
  const key = keyOf(hash);
  if (await redis.hexists(key, "length")) return;
  for (let k = 0; k * kPiece < bytes.length; ++k)
    await redis.hset(key, String(k), Buffer.from(bytes.subarray(k * kPiece, (k + 1) * kPiece)));
  await redis.hset(key, "length", bytes.length);
  await redis.expire(key, kWeek);
}

async function getSnapshot(redis, hash) {
  const key = keyOf(hash);
  const length = Number((await redis.hget(key, "length")) ?? Number.NaN);
  const pieces = [];
  for (let k = 0; k * kPiece < length; ++k)
    pieces.push((await redis.hgetBuffer(key, String(k))) ?? Buffer.alloc(0));
  const bytes = Buffer.concat(pieces);
  if (Number.isNaN(length)) throw new NoSnapshot(`snapshot ${hash} is not in Redis`);
  if (hashOf(bytes) === hash) return bytes;
  await redis.del(key); // whoever submitted it sees that and puts it there again
  throw new NoSnapshot(`snapshot ${hash} was damaged in Redis`);
}

/** The diagram of the snapshot that was asked for last: fetched and restored once a hash. */
export class CurrentDiagram {
  #redis;
  #hash;
  #diagram;
  #loading = Promise.resolve();

  constructor(redis) {
    this.#redis = redis;
  }

  /**
   * Calls `action` with the diagram of a snapshot, and returns what it returns; `action` must not
   * wait, as the diagram is disposed of when another is asked for.
   */
  async use(hash, action) {
    while (this.#hash !== hash) {
      this.#loading = this.#loading.catch(() => {}).then(() => this.#load(hash));
      await this.#loading;
    }
    return action(this.#diagram);
  }

  async #load(hash) {
    if (this.#hash === hash) return;
    const bytes = await getSnapshot(this.#redis, hash);
    this.#diagram?.dispose();
    this.#hash = undefined;
    // Trusted: they have the hash that the submitter gave, so they are what `toBytes` wrote there.
    this.#diagram = Diagram.fromBytes(bytes, { trusted: true });
    this.#hash = hash;
  }
}
