// Two workers in network namespaces of their own: nothing but REDIS_URL and the folder connects
// them with Redis, as on two machines. Where the machine allows no namespaces it is skipped,
// loudly.
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { afterAll, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { generator, randomCircles } from "../wasm/support/random.mjs";
import { emptyFolder, writeArray } from "./support/files.mjs";
import { finish, start, stopAll, until } from "./support/processes.mjs";
import { partsIn, startRedis, stopServers } from "./support/redis.mjs";

const names = [1, 2].map((k) => `apollonius-${process.pid}-${k}`);
const bridge = `ap${process.pid}`;
const net = `10.${213 + (process.pid % 40)}.${process.pid % 251}`;

const ip = (...words) => spawnSync("ip", words, { encoding: "utf8" });

/** A bridge with an address, and two namespaces on it; false if that cannot be had. */
function makeNetwork() {
  const commands = [`link add ${bridge} type bridge`, `addr add ${net}.1/24 dev ${bridge}`];
  commands.push(`link set ${bridge} up`);
  names.forEach((name, k) => {
    const [outer, inner] = [`${bridge}o${k}`, `${bridge}i${k}`];
    commands.push(`netns add ${name}`, `link add ${outer} type veth peer name ${inner}`);
    commands.push(`link set ${inner} netns ${name}`, `link set ${outer} master ${bridge} up`);
    commands.push(`-n ${name} addr add ${net}.${k + 2}/24 dev ${inner}`);
    commands.push(`-n ${name} link set ${inner} up`);
  });
  return commands.every((command) => ip(...command.split(" ")).status === 0);
}

function removeNetwork() {
  for (const name of names) ip("netns", "del", name);
  ip("link", "del", bridge);
}

/** Can a network be made here? It is removed again, as this runs even if no test does. */
function canMakeNetwork() {
  const made = makeNetwork();
  removeNetwork();
  return made;
}

const isPossible = process.env.REDIS_SERVER !== "" && canMakeNetwork();
const withNetwork = isPossible ? test : test.skip;
if (!isPossible) console.warn("WITHOUT NETWORK NAMESPACES: they need Redis, `ip` and root");

const folder = emptyFolder("machines");

afterAll(async () => {
  stopAll();
  await stopServers();
  removeNetwork();
});

withNetwork("two workers in two network namespaces", async () => {
  expect(makeNetwork()).toBe(true);
  const random = generator(9);
  const diagram = new Diagram(randomCircles(5000, 1, 3));
  const snapshot = path.join(folder, "snapshot.bin");
  writeFileSync(snapshot, diagram.toBytes());
  const xy = Float64Array.from({ length: 400_000 }, () => random() * 2000 - 1000);
  const file = writeArray(path.join(folder, "points.f64"), xy);
  const redis = await startRedis({ folder: path.join(folder, "redis"), bind: `${net}.1` });
  const env = { REDIS_URL: redis.url };
  // The loopback device of a new namespace is down. One that is up would be the machine's, and the
  // workers would not be apart.
  const loopback = ip("-n", names[0], "-o", "link", "show", "up", "dev", "lo");
  expect(loopback.stdout).toBe("");

  // Each has a folder of its own: of one folder's jobs a single worker may take all.
  const machines = names.map((name) => {
    const work = path.join(folder, name);
    const before = ["ip", "netns", "exec", name];
    const worker = start("worker.mjs", ["--folder", work, "--concurrency", "1"], { env, before });
    return { work, worker };
  });
  await until(() => machines.every(({ worker }) => worker.output().includes("Waiting for jobs")));
  const ids = diagram.findMany(xy);
  for (const { work, worker } of machines) {
    const submission = ["--folder", work, "--snapshot", snapshot, "--points", file];
    await finish("submit.mjs", [...submission, "--per-job", "2000"], { env });
    expect(await partsIn(work)).toHaveLength(100);
    const result = path.join(work, "result");
    await finish("collect.mjs", ["--folder", work, "--out", result]);
    expect(readFileSync(`${result}.ids.i32`).equals(Buffer.from(ids.buffer))).toBe(true);
    worker.child.kill("SIGTERM");
    await worker.ended;
    expect(Number(/"items":(\d+)/.exec(worker.output())[1])).toBe(200_000);
  }
});
