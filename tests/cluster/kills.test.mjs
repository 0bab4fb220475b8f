// kill -9 of Redis, of workers, of submit, and of all of them: the result is byte for byte that of
// an undisturbed run, or submit says why not, ends with 1, and goes on when it is started again.
// Without REDIS_URL, all that a run has started ends with it.
import { readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { partFile } from "../../web/examples/cluster/parts.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator, randomCircles } from "../wasm/support/random.mjs";
import { emptyFolder, writeArray } from "./support/files.mjs";
import {
  childrenOf,
  finish,
  isAlive,
  isStack,
  start,
  stopAll,
  until,
} from "./support/processes.mjs";
import { connected, partsIn, planOf, startRedis, stopServers } from "./support/redis.mjs";

const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;
const kKills = isThorough ? 100 : 4;
const kPoints = 400_000;
const kJobs = 400;
const kLongest = 300; // seconds of a run, after which it counts as waiting for ever
const kPatience = 8; // seconds without an answer: a loaded machine keeps Redis waiting for some
const kSilence = new RegExp(
  `no answer for ${kPatience} s \\(.*\\)\nStart this again when Redis can run`,
);

const folder = emptyFolder("kills");
const inFolder = (name) => path.join(folder, name);
const work = inFolder("work");
const submission = [
  ...["--folder", work, "--snapshot", inFolder("snapshot.bin"), "--distances"],
  ...["--points", inFolder("points.f64"), "--per-job", String(kPoints / kJobs)],
];
const worker = ["--folder", work, "--lock", "1"];

afterEach(async () => {
  stopAll();
  await stopServers();
});

/** Makes the input, and gives the answers of one process by the names of the results. */
function problem() {
  const diagram = new Diagram(randomCircles(20_000, 1, 3));
  writeFileSync(inFolder("snapshot.bin"), diagram.toBytes());
  const random = generator(2);
  const xy = Float64Array.from({ length: 2 * kPoints }, () => random() * 2200 - 1100);
  writeArray(inFolder("points.f64"), xy);
  const { ids, distances } = diagram.nearestMany(xy);
  diagram.dispose();
  return { "result.ids.i32": ids, "result.distances.f64": distances };
}
const expected = Object.entries(problem()).map(([name, { buffer }]) => [name, Buffer.from(buffer)]);

/** Is the result of `collect` equal to that of one process? */
async function isRight() {
  await finish("collect.mjs", ["--folder", work, "--out", inFolder("result")]);
  return expected.every(([name, bytes]) => readFileSync(inFolder(name)).equals(bytes));
}

const sleep = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));

/** The exit code of `submit`, or null if it does not end. */
function outcome({ ended }) {
  let timer;
  const late = new Promise((resolve) => (timer = setTimeout(resolve, 1000 * kLongest, null)));
  return Promise.race([ended, late]).finally(() => clearTimeout(timer));
}

/**
 * A run in a new folder, in which `kill -9` ends some processes, each time when there are some
 * parts and some seconds have gone by. All of them are started again, as somebody would. Resolves
 * to how many times that was before the end, the seconds that the run took, and what submit said if
 * it gave up.
 */
async function killedRun(kills, settings) {
  rmSync(work, { recursive: true, force: true });
  rmSync(inFolder("redis"), { recursive: true, force: true });
  const redis = await startRedis({ folder: inFolder("redis"), settings });
  const shared = { env: { REDIS_URL: redis.url } };
  const startSubmit = () => start("submit.mjs", submission, shared);
  const startWorkers = () => [0, 1].map(() => start("worker.mjs", worker, shared));
  const began = performance.now();
  let workers = startWorkers();
  let submit = startSubmit();
  let killed = 0;
  const isOver = () => submit.child.exitCode !== null;
  for (const { victims, parts, after, pause } of kills) {
    await until(async () => isOver() || (await partsIn(work)).length >= parts);
    await sleep(after);
    if (isOver()) break;
    ++killed;
    if (victims.includes("redis")) await redis.kill();
    if (victims.includes("workers")) for (const { child } of workers) child.kill("SIGKILL");
    if (victims.includes("submit")) submit.child.kill("SIGKILL");
    await sleep(pause);
    if (victims.includes("redis")) await redis.start();
    if (victims.includes("workers")) workers = startWorkers();
    if (victims.includes("submit")) submit = startSubmit();
  }
  let code = await outcome(submit);
  const seconds = (performance.now() - began) / 1000;
  const message = code === 1 ? submit.output() : null;
  if (code === 1) {
    submit = startSubmit();
    code = await outcome(submit);
  }
  stopAll();
  await Promise.all(workers.map(({ ended }) => ended));
  await redis.kill();
  const text = [message ?? "", ...[submit, ...workers].map(({ output }) => output())].join("\n");
  if (code !== 0) throw new Error(`submit ended with ${code}:\n${text}`);
  if (isStack(text)) throw new Error(`a stack:\n${text}`);
  if (!(await isRight())) throw new Error(`another result:\n${text}`);
  return { killed, seconds, message };
}

const groups = [["redis"], ["workers"], ["submit"], ["redis", "workers", "submit"]];
const kKeeps = [["appendonly yes"], []]; // a Redis that has lost all comes back, too

withRedis(
  `${kKills} kills at random moments change nothing`,
  async () => {
    const random = generator(3);
    const { seconds } = await killedRun([]);
    const counts = { kills: 0, runs: 0, gaveUp: 0 };
    while (counts.kills < kKills) {
      const victims = groups[counts.runs % groups.length];
      const settings = kKeeps[Math.floor(2 * random())];
      const pause = random() / 2;
      // At any moment of the run; or of the work, which is a part of it.
      const kills = [
        isThorough && random() < 0.5
          ? { victims, parts: 0, after: seconds * random(), pause }
          : { victims, parts: Math.floor(0.9 * kJobs * random()), after: 0, pause },
      ];
      if (isThorough && random() < 0.5) {
        const others = groups[Math.floor(groups.length * random())];
        kills.push({ victims: others, parts: 0, after: 2 * random(), pause });
      }
      const what = JSON.stringify([kills, settings]);
      const { killed, message } = await killedRun(kills, settings).catch((error) => {
        throw new Error(`${what}: ${error.message}`);
      });
      counts.kills += killed;
      ++counts.runs;
      if (message === null) continue;
      ++counts.gaveUp;
      console.log(`${what}:\n${message}`);
    }
    if (isThorough) console.log(JSON.stringify({ ...counts, seconds }));
  },
  isThorough ? 3_600_000 : undefined,
);

const isRedis = ({ command }) => command.startsWith("redis-server");
const isWorker = ({ command }) => command.includes("worker.mjs");
const isSubmit = ({ command }) => command.includes("submit.mjs");

withRedis.each([
  ["Redis", isRedis, "SIGKILL", /redis-server ended with SIGKILL/],
  ["a worker", isWorker, "SIGKILL", /A worker ended with SIGKILL/],
  ["submit", isSubmit, "SIGKILL", /^$/],
  ["submit", isSubmit, "SIGINT", /^$/],
  ["a Redis that hangs", isRedis, "SIGSTOP", kSilence],
])(
  "one machine, %s ends (%#): all that the run has started ends, and it goes on when started again",
  async (_, isVictim, signal, words) => {
    rmSync(work, { recursive: true, force: true });
    const args = [...submission, "--workers", "2"];
    const submit = start("submit.mjs", [...args, "--patience", String(kPatience)]);
    await until(async () => (await partsIn(work)).length > 10);
    const { pid } = submit.child;
    const all = [{ pid, command: "submit.mjs" }, ...childrenOf(pid)];
    expect(all.filter(isWorker)).toHaveLength(2);
    expect(all.filter(isRedis)).toHaveLength(1);
    process.kill(all.find(isVictim).pid, signal);
    const code = await outcome(submit);
    expect([code, submit.child.signalCode]).toEqual(
      isVictim === isSubmit ? [null, signal] : [1, null],
    );
    expect(
      submit
        .output()
        .split("\n")
        .filter((line) => !line.includes(" of "))
        .join("\n")
        .trim(),
    ).toMatch(words);
    expect(isStack(submit.output())).toBe(false);
    await until(() => !all.some((each) => isAlive(each.pid)));
    const done = await partsIn(work);
    const { run } = await planOf(work);
    const timeOf = (index) => statSync(partFile(work, run, index)).mtimeMs;
    const times = done.map(timeOf);
    await finish("submit.mjs", args);
    expect(done.map(timeOf)).toEqual(times); // nothing was done again
    expect(await isRight()).toBe(true);
  },
);

withRedis("a folder that is removed in the middle of a run: submit says so and ends", async () => {
  rmSync(work, { recursive: true, force: true });
  const submit = start("submit.mjs", submission);
  await until(async () => (await partsIn(work)).length > 10);
  rmSync(path.join(work, "plan.json"));
  expect(await outcome(submit)).toBe(1);
  expect(submit.output()).toContain(`${work} has been emptied, or has another plan`);
  expect(isStack(submit.output())).toBe(false);
  await finish("submit.mjs", submission);
  expect(await isRight()).toBe(true);
});

withRedis(
  "a Redis of REDIS_URL that ends: submit says so, gives up, and goes on when it is back",
  async () => {
    rmSync(work, { recursive: true, force: true });
    const redis = await startRedis({ folder: inFolder("elsewhere") });
    const remote = { env: { REDIS_URL: redis.url } };
    const submit = start("submit.mjs", [...submission, "--patience", String(kPatience)], remote);
    const worker = start("worker.mjs", ["--folder", work, "--lock", "1"], remote);
    await until(async () => (await partsIn(work)).length > 10);
    worker.child.kill("SIGSTOP"); // or it would end the run
    await redis.kill();
    expect(await outcome(submit)).toBe(1);
    const { host } = new URL(redis.url);
    expect(submit.output()).toContain(`Redis at ${host} is away (`);
    expect(submit.output()).toMatch(kSilence);
    worker.child.kill("SIGCONT");
    await redis.start();
    await finish("submit.mjs", submission, remote);
    expect(await isRight()).toBe(true);
    expect(isStack(submit.output() + worker.output())).toBe(false);
  },
);

withRedis.each([
  ["a memory that is full", ["maxmemory", "1"], "OOM"],
  ["a disk that is full (by another rule)", ["min-replicas-to-write", "1"], "NOREPLICAS"],
])("a Redis that takes no data, %s: submit ends with its words", async (_, settings, words) => {
  rmSync(work, { recursive: true, force: true });
  const redis = await startRedis({ folder: inFolder("elsewhere") });
  const remote = { env: { REDIS_URL: redis.url } };
  const submit = start("submit.mjs", submission, remote);
  const worker = start("worker.mjs", ["--folder", work, "--lock", "1"], remote);
  await until(async () => (await partsIn(work)).length > 10);
  const client = connected(redis.url);
  await client.config("SET", ...settings);
  expect(await outcome(submit)).toBe(1);
  expect(submit.output()).toContain(words);
  expect(submit.output()).toContain("Start this again");
  expect(isStack(submit.output())).toBe(false);
  await client.config("SET", settings[0], "0");
  client.disconnect();
  await finish("submit.mjs", submission, remote);
  worker.child.kill("SIGKILL");
  expect(await isRight()).toBe(true);
});

withRedis("a Redis that cannot be reached, or does not let us in, is named", async () => {
  const { url } = await startRedis({ folder: inFolder("locked") });
  for (const [address, why] of [
    ["redis://127.0.0.1:1", "ECONNREFUSED"],
    [`redis://:wrong@${new URL(url).host}`, "WRONGPASS"],
    [`redis://${new URL(url).host}`, "NOAUTH"],
  ]) {
    rmSync(work, { recursive: true, force: true });
    const submit = start("submit.mjs", [...submission, "--patience", "4"], {
      env: { REDIS_URL: address },
    });
    expect(await outcome(submit)).toBe(1);
    expect(submit.output()).toContain(`Redis at ${new URL(address).host}`);
    expect(submit.output()).toContain(why);
    expect(isStack(submit.output())).toBe(false);
  }
});
