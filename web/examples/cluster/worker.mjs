// Does jobs until it is stopped. Nothing is lost if it dies: its locks expire, and others do its
// jobs again.
import { setTimeout } from "node:timers/promises";
import { DelayedError, Worker } from "bullmq";
import { Redis } from "ioredis";
import { assign } from "./assign.mjs";
import { buildTile } from "./build_tile.mjs";
import { count, givenRedis, readOptions, seconds, wordsOf } from "./command_line.mjs";
import { hasPart, writePart } from "./parts.mjs";
import { readPlan, stateOfPlan } from "./run.mjs";
import { CurrentDiagram, NoSnapshot } from "./snapshots.mjs";

const usage = `
node worker.mjs --folder work

Does jobs of submit.mjs and build.mjs until it is stopped; start as many as there are processors, on
any machines. Ctrl-C ends it after the jobs that it is at. Without REDIS_URL there is no need of it:
submit (build) has workers of its own.

  --folder        that of submit (build)
  --lock          seconds after which others do the jobs of a worker that has died, by default 30
  --concurrency   jobs at a time, by default 2: one computes while another reads or writes

REDIS_URL names the Redis that submit (build) has, too.`;

const options = readOptions(usage, {
  folder: { type: "string", required: true },
  lock: { type: "string", default: "30", as: seconds },
  concurrency: { type: "string", default: "2", as: count },
});
const { folder, concurrency } = options;
const url = givenRedis();
if (!url)
  throw new Error("REDIS_URL is missing: without it, submit.mjs and build.mjs start workers");
process.once("disconnect", () => process.exit()); // who has started it has ended

const redis = new Redis(url, { maxRetriesPerRequest: null });
const context = { folder, diagram: new CurrentDiagram(redis), seconds: 0, items: 0 };
const kinds = { assign, tile: buildTile };
const lock = 1000 * options.lock;
const kLook = 500; // milliseconds between two looks at which plan the folder has

async function perform({ kind, run, common, jobs }, job, token) {
  const { index } = job.data;
  if (await hasPart(folder, run, index)) return; // by someone whose lock had expired
  try {
    const sections = await kinds[kind]({ run, ...common, ...jobs[index] }, context);
    await writePart(folder, run, index, sections);
  } catch (error) {
    if (!(error instanceof NoSnapshot)) throw new Error(wordsOf(error));
    // the one who submitted it will put it there (again)
    await job.moveToDelayed(Date.now() + 1000, token);
    throw new DelayedError();
  }
}

let since, last; // the first job began, the last one ended
let memory = 0; // at the end of a job, at most; the system's own maximum counts our parent's
const say = (text) => {
  if (text !== said) console.error(text);
  said = text;
};
let said; // since Redis was there
const ofRedis = (error) => say(`Redis: ${wordsOf(error)}; it is tried again`);
redis.on("error", ofRedis);
redis.on("ready", () => (said = undefined));

/** A worker at the queue of a plan: others' jobs are not there. */
function workerOf(plan) {
  const worker = new Worker(
    plan.queue,
    async (job, token) => {
      since ??= performance.now();
      try {
        await perform(plan, job, token);
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
  worker.on("failed", (job, error) => console.error(`job ${job?.data.index}: ${error.message}`));
  worker.on("error", ofRedis);
  return worker;
}

let worker;
async function end() {
  // After what it is at; if Redis is gone, or goes meanwhile, there is nobody to tell.
  const gone = new Promise((resolve) => redis.once("close", resolve));
  if (redis.status === "ready") await Promise.race([worker?.close(), gone]);
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

console.log("Waiting for jobs");
for (let state = ""; ; await setTimeout(kLook)) {
  try {
    const now = await stateOfPlan(folder);
    if (now === state) continue;
    await worker?.close();
    const plan = await readPlan(folder);
    worker = plan && workerOf(plan);
    state = now;
  } catch (error) {
    say(`${wordsOf(error)}; it is tried again`);
  }
}
