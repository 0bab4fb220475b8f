// A run: a list of jobs whose parts come into a work folder. The folder is the truth, Redis only
// says who does what next: jobs without a part are in the queue, or are put there again. So a run
// goes on after anything that ends a process or a machine.
import { readFileSync } from "node:fs";
import { mkdir, rename, writeFile } from "node:fs/promises";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { Queue, QueueEvents } from "bullmq";
import { SingleBar } from "cli-progress";
import { connect } from "./connection.mjs";
import { hasPart, listParts, removePart } from "./parts.mjs";
import { hashOf, putSnapshot } from "./snapshots.mjs";

export const kQueue = "apollonius";
const kAttempts = 3;
const kAtOnce = 1000; // jobs that are added in one call
const kFarewell = 50; // tenths of a second that workers have to say that they are done
const kLook = 500; // milliseconds between two looks at the folder

const planFile = (folder) => path.join(folder, "plan.json");

/** The plan of a folder; undefined if it has none. */
export function readPlan(folder) {
  try {
    return JSON.parse(readFileSync(planFile(folder), "utf8"));
  } catch (error) {
    if (error.code === "ENOENT") return undefined;
    throw error instanceof SyntaxError ? new Error(`${planFile(folder)} is damaged`) : error;
  }
}

/** Keeps the plan in the folder; refuses a folder that belongs to another one. */
async function keepPlan(folder, plan) {
  const kept = readPlan(folder);
  if (kept?.run === plan.run) return;
  if (kept)
    throw new Error(`${folder} belongs to another run: choose another folder, or empty this one`);
  await mkdir(folder, { recursive: true });
  await writeFile(`${planFile(folder)}.new`, JSON.stringify(plan));
  await rename(`${planFile(folder)}.new`, planFile(folder));
}

/** The jobs that have no part; one that is not as long as it says is removed. */
async function missing(folder, { run, jobs }) {
  const there = new Set(await listParts(folder));
  for (const index of there) {
    if (await hasPart(folder, run, index)) continue;
    await removePart(folder, index);
    there.delete(index);
  }
  return [...jobs.keys()].filter((index) => !there.has(index));
}

/** Puts jobs into the queue; those that are there already stay as they are. */
async function enqueue(queue, { kind, run, common, jobs }, indices) {
  for (let at = 0; at < indices.length; at += kAtOnce) {
    await queue.addBulk(
      indices.slice(at, at + kAtOnce).map((index) => ({
        name: kind,
        data: { run, index, ...common, ...jobs[index] },
        opts: {
          jobId: `${run}-${index}`,
          attempts: kAttempts,
          backoff: 1000,
          removeOnComplete: true,
          removeOnFail: true,
        },
      })),
    );
  }
}

/** The identity of a run: two with the same facts give the same parts. */
export const runOf = (facts) => hashOf(JSON.stringify(facts)).slice(0, 16);

function progressBar({ unit, jobs }) {
  const sizes = jobs.map(({ size }) => size ?? 1);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  const short = (value) => Intl.NumberFormat("en", { notation: "compact" }).format(value);
  const bar = new SingleBar({
    format:
      `{bar} {percentage} %  {done} of {all} ${unit}  {rate} ${unit}/s  {eta_formatted} left  ` +
      "workers: {workers}",
    noTTYOutput: true,
    notTTYSchedule: 5000,
    hideCursor: true,
  });
  let first, began;
  const done = (indices) => indices.reduce((sum, index) => sum + sizes[index], 0);
  return {
    show(indices, workers) {
      const value = done(indices);
      const shown = (rate) => ({
        done: short(value),
        all: short(total),
        rate: short(rate),
        workers,
      });
      if (first === undefined) {
        [first, began] = [value, performance.now()];
        bar.start(total, value, shown(0));
      }
      bar.update(value, shown((1000 * (value - first)) / (performance.now() - began + 1)));
    },
    stop: () => bar.stop(),
  };
}

/**
 * Has all jobs of a plan done by the workers that there are, and shows how far they are. A plan is
 * {kind, run, unit, common, jobs}: `common` goes with every job; `size` of a job is in the unit.
 * Returns when every part is there; throws if a job has failed for good, or Redis has been away for
 * `patience` seconds. `snapshot` is put into Redis under its hash, again if it is lost there.
 */
export async function perform(folder, plan, { patience, snapshot }) {
  if (plan.jobs.length === 0)
    throw new Error("there is nothing to do: the input or the window is empty");
  await keepPlan(folder, plan);
  const { redis, lost, close } = await connect(folder, { patience });
  const bar = progressBar(plan);
  const queue = new Queue(kQueue, { connection: redis });
  const reading = redis.duplicate({ socketTimeout: undefined }); // no event is no failure
  const events = new QueueEvents(kQueue, { connection: reading });
  for (const each of [queue, events, reading]) each.on("error", () => {}); // `lost` tells
  let failure;
  events.on("failed", ({ jobId, failedReason }) => {
    if (jobId.startsWith(`${plan.run}-`)) failure = `job ${jobId.split("-")[1]}: ${failedReason}`;
  });

  async function seeThrough() {
    await events.waitUntilReady();
    for (let todo = await missing(folder, plan); todo.length > 0; ) {
      if (snapshot) await putSnapshot(redis, plan.common.snapshot, snapshot);
      await enqueue(queue, plan, todo);
      // until the queue is empty, or holds only what other runs have there
      for (let there = -1; failure === undefined; await setTimeout(kLook)) {
        const parts = await listParts(folder);
        bar.show(parts, await queue.getWorkersCount());
        if (snapshot) await putSnapshot(redis, plan.common.snapshot, snapshot);
        const idle = (await queue.getJobCountByTypes("wait", "active", "delayed")) === 0;
        if (parts.length >= plan.jobs.length || (idle && parts.length === there)) break;
        there = parts.length;
      }
      if (failure) throw new Error(failure);
      todo = await missing(folder, plan);
    }
    // The parts are there; workers that are about to say so to Redis may.
    for (let k = 0; k < kFarewell && (await queue.getActiveCount()) > 0; ++k) await setTimeout(100);
  }

  try {
    await Promise.race([seeThrough(), lost]);
  } finally {
    bar.stop();
    reading.disconnect();
    // These may wait for a Redis that is away, so nobody waits for them.
    for (const each of [queue, events]) each.close().catch(() => {});
    await close();
  }
}
