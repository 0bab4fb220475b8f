// kill -9 of Redis, of workers, of submit, and of all of them: the result is byte for byte that of
// an undisturbed run, or submit says why not, ends with 1, and goes on when it is started again.
import { chmodSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { listParts } from "../../web/examples/cluster/parts.mjs";
import { startRedis, stopRedis } from "../../web/examples/cluster/redis.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator, randomCircles } from "../wasm/support/random.mjs";
import { emptyFolder, writeArray } from "./support/files.mjs";
import { finish, isStack, start, stopAll, until } from "./support/processes.mjs";

const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;
const kKills = isThorough ? 100 : 4;
const kPoints = 400_000;
const kJobs = 400;
const kLongest = 300; // seconds of a run, after which it counts as waiting for ever

const folder = emptyFolder("kills");
const inFolder = (name) => path.join(folder, name);
const work = inFolder("work");
const submission = [
  ...["--folder", work, "--snapshot", inFolder("snapshot.bin"), "--distances"],
  ...["--points", inFolder("points.f64"), "--per-job", String(kPoints / kJobs)],
];
const worker = ["--folder", work, "--lock", "1"];

let servers = []; // folders in which a Redis may be left over
afterEach(async () => {
  stopAll();
  for (const each of servers) await stopRedis(each);
  servers = [];
});

/** Makes the input, and gives the answers of one process by the names of the results. */
function problem() {
  const diagram = new Diagram(randomCircles(20_000, 1, 3));
  writeFileSync(inFolder("snapshot.bin"), diagram.toBytes());
  const random = generator(2);
  const xy = Float64Array.from({ length: 2 * kPoints }, () => random() * 2200 - 1100);
  writeArray(inFolder("points.f64"), xy);
  const distances = new Float64Array(kPoints);
  const ids = diagram.findMany(xy, distances);
  diagram.dispose();
  return { "result.ids.i32": ids, "result.distances.f64": distances };
}
const expected = Object.entries(problem()).map(([name, { buffer }]) => [name, Buffer.from(buffer)]);

/** Whether what collect makes is what one process gives. */
async function isRight() {
  await finish("collect.mjs", ["--folder", work, "--out", inFolder("result")]);
  return expected.every(([name, bytes]) => readFileSync(inFolder(name)).equals(bytes));
}

// Redis is started by a script that says which process it is, from its first moment on.
const pidFile = inFolder("redis.pid");
mkdirSync(inFolder("bin"));
const script = `#!/bin/sh\necho $$ > '${pidFile}'\nexec '${process.env.REDIS_SERVER}' "$@"\n`;
writeFileSync(inFolder("bin/redis-server"), script);
chmodSync(inFolder("bin/redis-server"), 0o755);
const env = { PATH: `${inFolder("bin")}${path.delimiter}${process.env.PATH}` };

function redisProcess() {
  try {
    return Number(readFileSync(pidFile, "utf8")); // 0: it is about to say
  } catch {
    return 0;
  }
}

/** Kills Redis if there is one. */
function killRedis() {
  const pid = redisProcess();
  if (pid === 0) return;
  rmSync(pidFile); // another process may get the number
  try {
    process.kill(pid, "SIGKILL");
  } catch {} // it has just ended
}

const startSubmit = () => start("submit.mjs", submission, { env });
const startWorkers = () => [0, 1].map(() => start("worker.mjs", worker, { env }));

/** How submit ends: its exit code, or null if it does not. */
function outcome({ ended }) {
  let timer;
  const late = new Promise((resolve) => (timer = setTimeout(resolve, 1000 * kLongest, null)));
  return Promise.race([ended, late]).finally(() => clearTimeout(timer));
}

const sleep = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));

/**
 * A run in a new folder, in which `kill -9` ends some processes, each time when there are some
 * parts and some seconds have gone by. Workers and submit are started again, as somebody would;
 * Redis is not. Resolves to how many times that was before the end, the seconds that the run took,
 * and what submit said if it gave up.
 */
async function killedRun(kills) {
  rmSync(work, { recursive: true, force: true });
  rmSync(pidFile, { force: true });
  servers.push(work);
  const began = performance.now();
  let workers = startWorkers();
  let submit = startSubmit();
  let killed = 0;
  const isOver = () => submit.child.exitCode !== null;
  for (const { victims, parts, after, pause } of kills) {
    await until(async () => isOver() || (await listParts(work)).length >= parts);
    await sleep(after);
    if (isOver()) break;
    ++killed;
    if (victims.includes("redis")) killRedis();
    if (victims.includes("workers")) for (const { child } of workers) child.kill("SIGKILL");
    if (victims.includes("submit")) submit.child.kill("SIGKILL");
    await sleep(pause);
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
  const text = [message ?? "", ...[submit, ...workers].map(({ output }) => output())].join("\n");
  if (code !== 0) throw new Error(`submit ended with ${code}:\n${text}`);
  if (isStack(text)) throw new Error(`a stack:\n${text}`);
  if (!(await isRight())) throw new Error(`another result:\n${text}`);
  return { killed, seconds, message };
}

const groups = [["redis"], ["workers"], ["submit"], ["redis", "workers", "submit"]];

withRedis(
  `${kKills} kills at random moments change nothing`,
  async () => {
    const random = generator(3);
    const { seconds } = await killedRun([]);
    const counts = { kills: 0, runs: 0, gaveUp: 0 };
    while (counts.kills < kKills) {
      const victims = groups[counts.runs % groups.length];
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
      const what = JSON.stringify(kills);
      const { killed, message } = await killedRun(kills).catch((error) => {
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

withRedis(
  "a Redis of REDIS_URL that ends: submit says so, gives up, and goes on when it is back",
  async () => {
    rmSync(work, { recursive: true, force: true });
    const elsewhere = inFolder("elsewhere");
    servers.push(elsewhere);
    const url = await startRedis({ folder: elsewhere });
    const remote = { env: { ...env, REDIS_URL: url } };
    const submit = start("submit.mjs", [...submission, "--patience", "2"], remote);
    const worker = start("worker.mjs", ["--folder", work, "--lock", "1"], remote);
    await until(async () => (await listParts(work)).length > 10);
    worker.child.kill("SIGSTOP"); // or it would end the run
    await stopRedis(elsewhere);
    expect(await outcome(submit)).toBe(1);
    const { host } = new URL(url);
    expect(submit.output()).toContain(`Redis at ${host} is away (`);
    expect(submit.output()).toMatch(
      /no answer for 2 s \(.*\)\nStart this again when Redis can run/,
    );
    expect(submit.output()).not.toContain("started again");
    worker.child.kill("SIGCONT");
    await startRedis({ folder: elsewhere });
    await finish("submit.mjs", submission, remote);
    expect(await isRight()).toBe(true);
    expect(isStack(submit.output() + worker.output())).toBe(false);
  },
);

withRedis("a Redis that cannot be reached, or does not let us in, is named", async () => {
  servers.push(inFolder("locked"));
  const url = await startRedis({ folder: inFolder("locked") });
  for (const [address, why] of [
    ["redis://127.0.0.1:1", "ECONNREFUSED"],
    [`redis://:wrong@${new URL(url).host}`, "WRONGPASS"],
    [`redis://${new URL(url).host}`, "NOAUTH"],
  ]) {
    rmSync(work, { recursive: true, force: true });
    const submit = start("submit.mjs", [...submission, "--patience", "1"], {
      env: { REDIS_URL: address },
    });
    expect(await outcome(submit)).toBe(1);
    expect(submit.output()).toContain(`Redis at ${new URL(address).host}`);
    expect(submit.output()).toContain(why);
    expect(isStack(submit.output())).toBe(false);
  }
});

withRedis(
  "a Redis of the folder's own whose files are damaged: submit says what to do",
  async () => {
    rmSync(work, { recursive: true, force: true });
    mkdirSync(path.join(work, "redis/appendonlydir"), { recursive: true });
    writeFileSync(path.join(work, "redis/appendonlydir/appendonly.aof.manifest"), "nonsense\n");
    const submit = startSubmit();
    expect(await outcome(submit)).toBe(1);
    expect(submit.output()).toMatch(/redis-server ended with 1:.*manifest/s);
    expect(submit.output()).toContain("Start this again when Redis can run");
    expect(isStack(submit.output())).toBe(false);
  },
);
