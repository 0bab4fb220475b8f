// Points by workers over a real Redis: whatever is killed or damaged on the way, the result is the
// single process's, byte for byte. REDIS_SERVER is empty where there is none (tests/run.mjs).
import { existsSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { makeVector, RecordBatchFileWriter, Table, tableFromIPC } from "apache-arrow";
import { Queue } from "bullmq";
import { asyncBufferFromFile, parquetReadObjects } from "hyparquet";
import { parquetWriteFile } from "hyparquet-writer";
import { partFile } from "../../web/examples/cluster/parts.mjs";
import { hashOf, putSnapshot } from "../../web/examples/cluster/snapshots.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator, randomCircles } from "../wasm/support/random.mjs";
import { bytesOf, damage, emptyFolder, writeArray } from "./support/files.mjs";
import { finish, start, stopAll, until } from "./support/processes.mjs";
import { connected, partsIn, planOf, startRedis, stopServers } from "./support/redis.mjs";

// `npm run check -- cluster` has 20 million points.
const pointCount = isThorough ? 20_000_000 : 2_000_000;
const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;

afterEach(async () => {
  stopAll();
  await stopServers();
});

/** Points in the square of the circles. */
function randomPoints(count, seed) {
  const random = generator(seed);
  return Float64Array.from({ length: 2 * count }, () => random() * 2200 - 1100);
}

/** A folder with a snapshot and points, and the answers of one process. */
function problem(name, { circles, points }) {
  const folder = emptyFolder(name);
  const diagram = new Diagram(randomCircles(circles, 1, 3));
  const bytes = diagram.toBytes();
  const snapshot = path.join(folder, "snapshot.bin");
  writeFileSync(snapshot, bytes);
  const xy = randomPoints(points, 2);
  const file = writeArray(path.join(folder, "points.f64"), xy);
  const { ids, distances } = diagram.nearestMany(xy);
  diagram.dispose();
  const work = path.join(folder, "work");
  return { folder, work, snapshot, bytes, hash: hashOf(bytes), file, xy, ids, distances };
}

const sameFile = (file, array) =>
  readFileSync(file).equals(Buffer.from(array.buffer, array.byteOffset, array.byteLength));

withRedis(
  "a killed worker, a killed Redis, a damaged snapshot and a damaged part change nothing",
  async () => {
    const jobs = 20;
    const { work, snapshot, bytes, hash, file, ids, distances, folder } = problem("failures", {
      circles: 50_000,
      points: pointCount,
    });
    const submission = [
      ...["--folder", work, "--snapshot", snapshot, "--points", file, "--distances"],
      ...["--per-job", String(pointCount / jobs)],
    ];
    const worker = ["--folder", work, "--lock", "2"];

    // A damaged snapshot is there under its hash when the workers come.
    const server = await startRedis({ folder: path.join(folder, "redis") });
    const shared = { env: { REDIS_URL: server.url } };
    const redis = connected(server.url);
    await putSnapshot(redis, hash, bytes);
    const key = `apollonius:snapshot:${hash}`;
    const piece = await redis.hgetBuffer(key, "0");
    piece[1000] ^= 4;
    await redis.hset(key, "0", piece);
    const submit = start("submit.mjs", submission, shared);
    const { run, queue: name } = await planOf(work);
    const queue = new Queue(name, { connection: redis });
    queue.on("error", () => {});

    // The first worker is stopped in the middle of a job, and killed.
    const first = start("worker.mjs", worker, shared);
    await until(async () => (await partsIn(work)).length >= 3);
    const inHand = await until(async () => {
      first.child.kill("SIGSTOP");
      const active = await queue.getActive();
      const parts = await partsIn(work);
      const unfinished = active.filter(({ data }) => !parts.includes(data.index));
      if (unfinished.length > 0) return unfinished.map(({ data }) => data.index);
      first.child.kill("SIGCONT");
      return null;
    });
    first.child.kill("SIGKILL");
    await first.ended;
    const before = await partsIn(work);
    for (const index of inHand) expect(before).not.toContain(index);
    expect(await redis.hgetBuffer(key, "0")).not.toEqual(piece); // it was written again

    // Redis is killed, and comes back with what its append-only file has; then others go on.
    await redis.set("before", "the end");
    await server.kill();
    await server.start();
    const others = [0, 1].map(() => start("worker.mjs", worker, shared));
    expect(await redis.get("before")).toBe("the end");
    await queue.close();
    // Submit leaves nothing; BullMQ's workers write a key or two again, as long as they look.
    await until(async () => (await partsIn(work)).length === jobs);
    for (const { child } of others) child.kill("SIGSTOP");
    expect(await submit.ended).toBe(0);
    expect((await partsIn(work)).sort((a, b) => a - b)).toEqual([...Array(jobs).keys()]);
    expect(await redis.keys(`*${name}*`)).toEqual([`${name}:alive`]); // which goes by itself
    for (const { child } of others) child.kill("SIGCONT");
    redis.disconnect();

    // A part is damaged: it is named, and nothing is written; done again, the rest is untouched.
    const collection = ["--folder", work, "--out", path.join(folder, "result")];
    damage(partFile(work, run, 7), 0.5);
    damage(partFile(work, run, 11), 0);
    const refused = start("collect.mjs", collection);
    expect(await refused.ended).toBe(1);
    expect(refused.output()).toContain(`2 of ${jobs} parts (7, 11)`);
    expect(readdirSync(folder).filter((each) => each.startsWith("result"))).toEqual([]);
    await finish("submit.mjs", submission, shared); // the workers are still there
    await finish("collect.mjs", collection);
    expect(sameFile(path.join(folder, "result.ids.i32"), ids)).toBe(true);
    expect(sameFile(path.join(folder, "result.distances.f64"), distances)).toBe(true);
    for (const { child } of others) child.kill("SIGTERM");
  },
);

withRedis("submit goes on after it was interrupted or killed, and does nothing twice", async () => {
  const { work, snapshot, file, ids, folder } = problem("resumed", {
    circles: 5000,
    points: 200_000,
  });
  const submission = [
    ...["--folder", work, "--snapshot", snapshot, "--points", file, "--per-job", "500"],
  ];
  const server = await startRedis({ folder: path.join(folder, "redis") });
  const shared = { env: { REDIS_URL: server.url } };
  const worker = start("worker.mjs", ["--folder", work], shared);
  for (const signal of ["SIGINT", "SIGKILL"]) {
    const { length } = await partsIn(work);
    const submit = start("submit.mjs", submission, shared);
    worker.child.kill("SIGCONT");
    // (all of them, if this process was not given any time for so long)
    await until(async () => (await partsIn(work)).length > Math.min(length + 5, 399));
    worker.child.kill("SIGSTOP"); // or it would end the run alone
    submit.child.kill(signal);
    await submit.ended;
  }
  const { run } = await planOf(work);
  const done = (await partsIn(work)).map((index) => partFile(work, run, index));
  const times = done.map((part) => [part, statSync(part).mtimeMs]);
  worker.child.kill("SIGCONT");
  await finish("submit.mjs", submission, shared);
  for (const [part, time] of times) expect(statSync(part).mtimeMs).toBe(time);
  await finish("collect.mjs", ["--folder", work, "--out", path.join(folder, "result")]);
  expect(sameFile(path.join(folder, "result.ids.i32"), ids)).toBe(true);
  expect(existsSync(path.join(folder, "result.distances.f64"))).toBe(false);
  await server.kill();
  worker.child.kill("SIGTERM");
  expect(await worker.ended).toBe(0); // although Redis has gone

  // The folder of one run is not another's.
  const other = start("submit.mjs", [...submission, "--distances"], shared);
  expect(await other.ended).toBe(1);
  expect(other.output()).toContain("belongs to another run");
});

withRedis("runs on one Redis, also of the same data, take no jobs from each other", async () => {
  const { work, snapshot, file, ids, folder } = problem("neighbours", {
    circles: 5000,
    points: 100_000,
  });
  const server = await startRedis({ folder: path.join(folder, "redis") });
  const shared = { env: { REDIS_URL: server.url } };
  const works = [1, 2, 3].map((k) => `${work}-${k}`);
  // Only the second one has a worker before it has parts; so the first one waits.
  const submissions = works.map((each, k) => {
    const perJob = k === 2 ? "400" : "500"; // the first two are the same run in two folders
    const args = ["--folder", each, "--snapshot", snapshot, "--points", file, "--per-job", perJob];
    return start("submit.mjs", args, shared);
  });
  const workerOf = (each) => start("worker.mjs", ["--folder", each], shared);
  const second = workerOf(works[1]);
  expect(await submissions[1].ended).toBe(0);
  expect(await partsIn(works[0])).toEqual([]);
  expect(await partsIn(works[2])).toEqual([]);
  const others = [workerOf(works[0]), workerOf(works[2])];
  expect(await submissions[0].ended).toBe(0);
  expect(await submissions[2].ended).toBe(0);
  for (const each of works) {
    await finish("collect.mjs", ["--folder", each, "--out", `${each}-result`]);
    expect(sameFile(`${each}-result.ids.i32`, ids)).toBe(true);
  }
  for (const { child, output } of [second, ...others]) {
    expect(output()).toBe("Waiting for jobs\n"); // and no job failed
    child.kill("SIGKILL");
  }
});

/** Empties a folder. Returns false if it does not stay empty: something was written to it. */
function tryToEmpty(folder) {
  try {
    for (const each of readdirSync(folder))
      rmSync(path.join(folder, each), { recursive: true, force: true });
    return true;
  } catch (error) {
    if (error.code !== "ENOTEMPTY") throw error;
    return false;
  }
}

withRedis("a worker whose folder is emptied goes on with the next plan in it", async () => {
  const { work, snapshot, file, ids, folder } = problem("emptied", {
    circles: 5000,
    points: 100_000,
  });
  const server = await startRedis({ folder: path.join(folder, "redis") });
  const shared = { env: { REDIS_URL: server.url } };
  const worker = start("worker.mjs", ["--folder", work], shared);
  for (const perJob of ["500", "700", "500"]) {
    const args = ["--folder", work, "--snapshot", snapshot, "--points", file, "--per-job", perJob];
    const submit = start("submit.mjs", args, shared);
    await until(async () => (await partsIn(work)).length > 5);
    submit.child.kill("SIGKILL"); // in the middle, with jobs in the queue and in hand
    await submit.ended;
    await until(() => tryToEmpty(work)); // the worker writes to it meanwhile
  }
  const args = ["--folder", work, "--snapshot", snapshot, "--points", file, "--per-job", "900"];
  await finish("submit.mjs", args, shared);
  await finish("collect.mjs", ["--folder", work, "--out", path.join(folder, "result")]);
  expect(sameFile(path.join(folder, "result.ids.i32"), ids)).toBe(true);
  worker.child.kill("SIGKILL");
});

withRedis("CSV, Arrow, Parquet and GeoJSON files, and a job that cannot be done", async () => {
  const { work, snapshot, xy, ids, distances, folder } = problem("formats-by-workers", {
    circles: 5000,
    points: 50_000,
  });
  const text = Array.from(ids, (_, k) => `${k},${xy[2 * k]},${xy[2 * k + 1]}\n`).join("");
  writeFileSync(path.join(folder, "points.csv"), `id,lon,lat\n${text}`);
  writeFileSync(path.join(folder, "bad.csv"), `id,lon,lat\n${text}7,1,north\n`);
  const axis = (k) => makeVector(Float64Array.from(ids, (_, row) => xy[2 * row + k]));
  const table = new Table({ lon: axis(0), lat: axis(1) });
  const batches = Array.from({ length: 10 }, (_, k) => table.slice(5000 * k, 5000 * (k + 1)));
  const arrow = RecordBatchFileWriter.writeAll(batches.flatMap((slice) => slice.batches));
  writeFileSync(path.join(folder, "points.arrow"), arrow.toUint8Array(true));
  const filename = path.join(folder, "points.parquet");
  const columnData = ["lon", "lat"].map((name, k) => ({ name, data: axis(k).toArray() }));
  parquetWriteFile({ filename, columnData, rowGroupSize: 5000 });
  const features = Array.from(ids, (_, k) => ({
    type: "Feature",
    geometry: { type: "Point", coordinates: [xy[2 * k], xy[2 * k + 1]] },
  }));
  const collection = JSON.stringify({ type: "FeatureCollection", features });
  writeFileSync(path.join(folder, "points.geojson.gz"), gzipSync(collection));

  const run = (name) => {
    const own = `${work}-${name}`;
    const submission = [
      ...["--folder", own, "--snapshot", snapshot, "--points", path.join(folder, name)],
      ...["--distances", "--columns", "lon,lat", "--per-job", "5000"],
    ];
    return { submission, collection: ["--folder", own, "--out", path.join(folder, "result")] };
  };
  const rows = Array.from(ids, (id, k) => `${id},${distances[k]}\n`);
  for (const name of ["points.csv", "points.arrow", "points.parquet", "points.geojson.gz"]) {
    const { submission, collection } = run(name);
    await finish("submit.mjs", submission);
    await finish("collect.mjs", collection);
    if (!/csv|geojson/.test(name)) continue;
    const csv = readFileSync(path.join(folder, "result.csv"), "utf8");
    expect(csv).toBe(`id,distance\n${rows.join("")}`);
  }
  const file = await asyncBufferFromFile(path.join(folder, "result.parquet"));
  const row = (id, k) => ({ id, distance: distances[k] });
  expect(await parquetReadObjects({ file })).toEqual(Array.from(ids, row));
  const found = tableFromIPC(readFileSync(path.join(folder, "result.arrow")));
  expect(found.batches).toHaveLength(10);
  expect(Buffer.compare(bytesOf(found.getChild("id").toArray()), bytesOf(ids))).toBe(0);
  const column = bytesOf(found.getChild("distance").toArray());
  expect(Buffer.compare(column, bytesOf(distances))).toBe(0);

  const bad = start("submit.mjs", run("bad.csv").submission);
  expect(await bad.ended).toBe(1);
  expect(bad.output()).toMatch(/job \d+: .*bad\.csv.* no number: 7,1,north/);
});

test("without redis-server it says what to install", async () => {
  const folder = emptyFolder("no-redis");
  writeFileSync(path.join(folder, "snapshot.bin"), new Diagram([0, 0, 1]).toBytes());
  writeArray(path.join(folder, "points.f64"), new Float64Array(2));
  const { ended, output } = start(
    "submit.mjs",
    [
      "--folder",
      folder,
      "--snapshot",
      `${folder}/snapshot.bin`,
      "--points",
      `${folder}/points.f64`,
    ],
    { env: { PATH: "" } },
  );
  expect(await ended).toBe(1);
  expect(output()).toContain("apt-get install redis-server");
});
