// A run: a list of jobs whose parts come into a work folder. The folder is the truth, Redis only
// says who does what next: jobs without a part are in the queue, or are put there again. So a run
// goes on after anything that ends a process or a machine.
import { randomUUID } from "node:crypto";
import { mkdir, stat } from "node:fs/promises";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { Queue, QueueEvents } from "bullmq";
import { SingleBar } from "cli-progress";
import { givenRedis } from "./command_line.mjs";
import { connect } from "./connection.mjs";
import { readWhole, replaceFile } from "./files.mjs";
import { hasPart, listParts, removeDrafts, removePart } from "./parts.mjs";
import { hashOf, putSnapshot } from "./snapshots.mjs";
import { startHere } from "./this_machine.mjs";

const kAttempts = 3;
const kAtOnce = 1000; // jobs that are added in one call
const kFarewell = 50; // tenths of a second that workers have to say that they are done
const kLook = 500; // milliseconds between two looks at the folder

const planFile = (folder) => path.join(folder, "plan.json");

/** The plan of a folder; undefined if it has none. */
export async function readPlan(folder) {
  try {
    return JSON.parse(await readWhole(planFile(folder)));
  } catch (error) {
    if (error.code === "ENOENT") return undefined;
    throw error instanceof SyntaxError ? new Error(`${planFile(folder)} is damaged`) : error;
  }
}

/** Which plan a folder has, without reading it: another text for another one, "" for none. */
export async function stateOfPlan(folder) {
  try {
    const { ino, mtimeMs, size } = await stat(planFile(folder));
    return [ino, mtimeMs, size].join();
  } catch (error) {
    if (error.code === "ENOENT") return "";
    throw error;
  }
}

/**
 * Keeps the plan in the folder, with the name of its queue, which no other folder has; refuses a
 * folder that belongs to another plan. Returns the one in the folder.
 */
async function keepPlan(folder, plan) {
  const kept = await readPlan(folder);
  if (kept?.run === plan.run) return kept;
  if (kept)
    throw new Error(`${folder} belongs to another run: choose another folder, or empty this one`);
  await mkdir(folder, { recursive: true });
  const made = { ...plan, queue: `apollonius-${randomUUID()}` };
  await replaceFile(planFile(folder), (file) => file.writeAll(Buffer.from(JSON.stringify(made))));
  return made;
}

/** The jobs that have no part; one that is not as long as it says is removed. */
async function missing(folder, { run, jobs }) {
  const there = new Set(await listParts(folder, run));
  for (const index of there) {
    if (await hasPart(folder, run, index)) continue;
    await removePart(folder, run, index);
    there.delete(index);
  }
  return [...jobs.keys()].filter((index) => !there.has(index));
}

/**
 * Puts jobs into the queue by their numbers, as workers have the plan; those that are there already
 * stay as they are.
 */
async function enqueue(queue, { kind }, indices) {
  for (let at = 0; at < indices.length; at += kAtOnce) {
    await queue.addBulk(
      indices.slice(at, at + kAtOnce).map((index) => ({
        name: kind,
        data: { index },
        opts: {
          jobId: `job-${index}`,
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

/** Seconds in words, by the two largest units. */
export function duration(seconds) {
  const [s, min, h] = [1, 60, 3600].map((unit) => Math.ceil(seconds) / unit);
  if (min < 1) return `${s} s`;
  return h < 1
    ? `${Math.floor(min)} min ${s % 60} s`
    : `${Math.floor(h)} h ${Math.floor(min % 60)} min`;
}

function progressBar({ unit, jobs }) {
  const sizes = jobs.map(({ size }) => size ?? 1);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  const { format: short } = Intl.NumberFormat("en", {
    notation: "compact",
    maximumSignificantDigits: 3,
  });
  const bar = new SingleBar({
    format: `{bar} {percentage} %  {done} of {all} ${unit}{speed}  workers: {workers}`,
    noTTYOutput: true,
    notTTYSchedule: 5000,
    hideCursor: true,
  });
  let first, began;
  const done = (indices) => indices.reduce((sum, index) => sum + sizes[index], 0);
  return {
    show(indices, workers) {
      const value = done(indices);
      const isFirst = first === undefined;
      if (isFirst) [first, began] = [value, performance.now()];
      const rate = (1000 * (value - first)) / (performance.now() - began + 1);
      const left = rate > 0 && duration((total - value) / rate);
      const speed = left ? `  ${short(rate)} ${unit}/s  ${left} left` : "";
      const shown = { done: short(value), all: short(total), speed, workers };
      if (isFirst) bar.start(total, value, shown);
      else bar.update(value, shown);
    },
    stop: () => bar.stop(),
  };
}

/**
 * Has all jobs of a plan done by the workers that there are, and shows how far they are. A plan is
 * {kind, run, unit, common, jobs}: `common` goes with every job; `size` of a job is in the unit.
 * Returns when every part is there; throws if a job has failed for good, or Redis has not answered
 * for `patience` seconds. `snapshot` is put into Redis under its hash, again if it is lost there.
 * Without REDIS_URL, Redis and `workers` are started here, and end with the run.
 */
export async function perform(folder, asked, { patience, snapshot, workers }) {
  if (asked.jobs.length === 0)
    throw new Error("there is nothing to do: the input or the window is empty");
  const plan = await keepPlan(folder, asked);
  const todo = await missing(folder, plan);
  if (todo.length === 0) return;
  const given = givenRedis();
  const here = given ? undefined : startHere(folder, workers);
  const connection = connect(given ?? here.url, { patience, key: `${plan.queue}:alive` });
  try {
    const lost = here ? [here.lost, connection.lost] : [connection.lost];
    await seeThrough(folder, plan, { todo, redis: connection.redis, lost, snapshot });
  } finally {
    connection.close();
    if (here) {
      await here.close();
      await removeDrafts(folder, plan.run); // of workers that were at something
    }
  }
}

/** Puts jobs into the queue until all parts are there; throws what a job or `lost` says. */
async function seeThrough(folder, plan, { todo, redis, lost, snapshot }) {
  const queue = new Queue(plan.queue, { connection: redis });
  const reading = redis.duplicate({ socketTimeout: undefined }); // no event is no failure
  const events = new QueueEvents(plan.queue, { connection: reading });
  for (const each of [queue, events, reading]) each.on("error", () => {}); // `lost` tells
  let failure;
  events.on("failed", ({ jobId, failedReason }) => {
    failure = `${jobId.replace("-", " ")}: ${failedReason}`;
  });
  const bar = progressBar(plan);

  async function work() {
    const state = await stateOfPlan(folder);
    await events.waitUntilReady();
    for (let left = todo; left.length > 0; left = await missing(folder, plan)) {
      if (snapshot) await putSnapshot(redis, plan.common.snapshot, snapshot);
      await enqueue(queue, plan, left);
      // until the queue is empty
      for (let there = -1; ; await setTimeout(kLook)) {
        const parts = await listParts(folder, plan.run);
        bar.show(parts, await queue.getWorkersCount());
        if (failure) throw new Error(failure);
        if ((await stateOfPlan(folder)) !== state)
          throw new Error(`${folder} has been emptied, or has another plan: start this again`);
        if (snapshot) await putSnapshot(redis, plan.common.snapshot, snapshot);
        const idle = (await queue.getJobCountByTypes("wait", "active", "delayed")) === 0;
        if (parts.length >= plan.jobs.length || (idle && parts.length === there)) break;
        there = parts.length;
      }
    }
    // The parts are there; workers that are about to say so to Redis may.
    for (let k = 0; k < kFarewell && (await queue.getActiveCount()) > 0; ++k) await setTimeout(100);
    await queue.obliterate({ force: true });
  }

  try {
    await Promise.race([work(), ...lost]);
  } finally {
    bar.stop();
    reading.disconnect();
    // These may wait for a Redis that is away, so nobody waits for them.
    for (const each of [queue, events]) each.close().catch(() => {});
  }
}
