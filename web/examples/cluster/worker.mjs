// Does jobs until it is stopped. Nothing is lost if it dies: its locks expire, and others do its
// jobs again.
import { DelayedError, Worker } from "bullmq";
import { Redis } from "ioredis";
import { assign } from "./assign.mjs";
import { buildTile } from "./build_tile.mjs";
import { count, readOptions, seconds, wordsOf } from "./command_line.mjs";
import { hasPart, writePart } from "./parts.mjs";
import { redisAddress } from "./redis.mjs";
import { kQueue } from "./run.mjs";
import { CurrentDiagram, NoSnapshot } from "./snapshots.mjs";

const usage = `
node worker.mjs --folder work

Does jobs of submit.mjs and build.mjs until it is stopped; start as many as there are processors, on
any machines. Ctrl-C ends it after the jobs that it is at.

  --folder        that of submit (build)
  --lock          seconds after which others do the jobs of a worker that has died, by default 30
  --concurrency   jobs at a time, by default 2: one computes while another reads or writes

REDIS_URL names the Redis that submit (build) has, too; without it, it is the one that they start.`;

const options = readOptions(usage, {
  folder: { type: "string", required: true },
  lock: { type: "string", default: "30", as: seconds },
  concurrency: { type: "string", default: "2", as: count },
});
const { folder, concurrency } = options;

const redis = new Redis(await redisAddress(folder), { maxRetriesPerRequest: null });
const context = { folder, diagram: new CurrentDiagram(redis), seconds: 0, items: 0 };
const kinds = { assign, tile: buildTile };
const lock = 1000 * options.lock;

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
    concurrency,
    lockDuration: lock,
    stalledInterval: lock,
    maxStalledCount: 1000, // that its worker dies is no fault of the job
  },
);
worker.on("failed", (job, error) => console.error(`job ${job?.id}: ${error.message}`));
let said; // since Redis was there
for (const each of [worker, redis]) {
  each.on("error", (error) => {
    const words = wordsOf(error);
    if (words !== said) console.error(`Redis: ${words}; it is tried again`);
    said = words;
  });
}
redis.on("ready", () => (said = undefined));
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
