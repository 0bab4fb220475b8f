// Does jobs until it is stopped; start as many as there are processors, on any machines:
//
//   node worker.mjs --folder work       REDIS_URL, or the Redis that submit.mjs has started
//
// Ctrl-C ends it after the jobs that it is at. Nothing is lost if it dies: its locks expire after
// `--lock` seconds, and others do its jobs again.
import { parseArgs } from "node:util";
import { DelayedError, Worker } from "bullmq";
import { Redis } from "ioredis";
import { assign } from "./assign.mjs";
import { buildTile } from "./build_tile.mjs";
import { hasPart, writePart } from "./parts.mjs";
import { redisAddress } from "./redis.mjs";
import { kQueue } from "./run.mjs";
import { CurrentDiagram, NoSnapshot } from "./snapshots.mjs";

const { values: options } = parseArgs({
  options: {
    folder: { type: "string" },
    lock: { type: "string", default: "30" },
    concurrency: { type: "string", default: "2" }, // one computes while another reads or writes
  },
});
const { folder } = options;
if (!folder) throw new Error("--folder is missing");

const redis = new Redis(await redisAddress(folder), { maxRetriesPerRequest: null });
const context = { folder, diagram: new CurrentDiagram(redis), seconds: 0, items: 0 };
const kinds = { assign, tile: buildTile };
const lock = 1000 * Number(options.lock);

async function perform(job, token) {
  const { run, index } = job.data;
  if (await hasPart(folder, run, index)) return; // by someone whose lock had expired
  try {
    await writePart(folder, run, index, await kinds[job.name](job.data, context));
  } catch (error) {
    if (!(error instanceof NoSnapshot)) throw error;
    // the one who submitted it will put it there (again)
    await job.moveToDelayed(Date.now() + 1000, token);
    throw new DelayedError();
  }
}

let since, last; // the first job began, the last one ended
let memory = 0; // at the end of a job, at most; the system's own maximum counts our parent's
const worker = new Worker(
  kQueue,
  async (job, token) => {
    since ??= performance.now();
    try {
      await perform(job, token);
    } finally {
      last = performance.now();
      memory = Math.max(memory, process.memoryUsage.rss());
    }
  },
  {
    connection: redis,
    concurrency: Number(options.concurrency),
    lockDuration: lock,
    stalledInterval: lock,
    maxStalledCount: 1000, // that its worker dies is no fault of the job
  },
);
worker.on("failed", (job, error) => console.error(`job ${job?.id}: ${error.message}`));
let isAway = false;
for (const each of [worker, redis]) {
  each.on("error", ({ message }) => {
    if (!isAway) console.error(`Redis: ${message}; it is tried again`);
    isAway = true;
  });
}
redis.on("ready", () => (isAway = false));
console.log("Waiting for jobs");

async function end() {
  // After what it is at; if Redis is gone, or goes meanwhile, there is nobody to tell.
  const gone = new Promise((resolve) => redis.once("close", resolve));
  if (redis.status === "ready") await Promise.race([worker.close(), gone]);
  const { seconds, items } = context;
  console.log(
    JSON.stringify({
      items,
      inFindMany: +seconds.toFixed(3), // seconds
      busy: +((last - since) / 1000 || 0).toFixed(3), // from the first job to the last
      peakMegabytes: Math.round(memory / 1e6),
    }),
  );
  process.exit();
}
for (const signal of ["SIGINT", "SIGTERM"]) process.once(signal, end);
