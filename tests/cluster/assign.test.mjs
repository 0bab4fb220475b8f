// Points by workers over a real Redis: whatever is killed or damaged on the way, the result is the
// single process's, byte for byte. REDIS_SERVER is empty where there is none (tests/run.mjs).
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { makeVector, RecordBatchFileWriter, Table, tableFromIPC } from "apache-arrow";
import { Queue } from "bullmq";
import { asyncBufferFromFile, parquetReadObjects } from "hyparquet";
import { parquetWriteFile } from "hyparquet-writer";
import { Redis } from "ioredis";
import { listParts, partFile } from "../../web/examples/cluster/parts.mjs";
import { openRedis, stopRedis } from "../../web/examples/cluster/redis.mjs";
import { kQueue } from "../../web/examples/cluster/run.mjs";
import { hashOf, putSnapshot } from "../../web/examples/cluster/snapshots.mjs";
import { isThorough } from "../support/effort.mjs";
import { generator, randomCircles } from "../wasm/support/random.mjs";
import { bytesOf, damage, emptyFolder, writeArray } from "./support/files.mjs";
import { finish, start, stopAll, until } from "./support/processes.mjs";

// `npm run check -- cluster` has 20 million points.
const pointCount = isThorough ? 20_000_000 : 2_000_000;
const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;

let works = []; // folders of the test, in which a Redis may be left over
afterEach(async () => {
  stopAll();
  for (const work of works) await stopRedis(work);
  works = [];
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
  const distances = new Float64Array(points);
  const ids = diagram.findMany(xy, distances);
  diagram.dispose();
  const work = path.join(folder, "work");
  works.push(work);
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
    const { url } = await openRedis(work);
    const redis = new Redis(url, { maxRetriesPerRequest: null });
    redis.on("error", () => {});
    await putSnapshot(redis, hash, bytes);
    const key = `apollonius:snapshot:${hash}`;
    const piece = await redis.hgetBuffer(key, "0");
    piece[1000] ^= 4;
    await redis.hset(key, "0", piece);
    const queue = new Queue(kQueue, { connection: redis });
    queue.on("error", () => {});
    const submit = start("submit.mjs", submission);

    // The first worker is stopped in the middle of a job, and killed.
    const first = start("worker.mjs", worker);
    await until(async () => (await listParts(work)).length >= 3);
    const inHand = await until(async () => {
      first.child.kill("SIGSTOP");
      const active = await queue.getActive();
      const parts = await listParts(work);
      const unfinished = active.filter(({ data }) => !parts.includes(data.index));
      if (unfinished.length > 0) return unfinished.map(({ data }) => data.index);
      first.child.kill("SIGCONT");
      return null;
    });
    first.child.kill("SIGKILL");
    await first.ended;
    const before = await listParts(work);
    for (const index of inHand) expect(before).not.toContain(index);
    expect(await redis.hgetBuffer(key, "0")).not.toEqual(piece); // it was put there anew

    // Redis is killed, and submit starts it with what its append-only file has; then others go on.
    await redis.set("before", "the end");
    const [, pid] = /process_id:(\d+)/.exec(await redis.info("server"));
    process.kill(Number(pid), "SIGKILL");
    await until(async () => redis.status !== "ready");
    const others = [start("worker.mjs", worker), start("worker.mjs", worker)];
    expect(await redis.get("before")).toBe("the end");
    await queue.close();
    redis.disconnect();
    expect(await submit.ended).toBe(0);
    expect((await listParts(work)).sort((a, b) => a - b)).toEqual([...Array(jobs).keys()]);

    // A part is damaged: it is named, and nothing is written; done again, the rest is untouched.
    const collection = ["--folder", work, "--out", path.join(folder, "result")];
    damage(partFile(work, 7), 0.5);
    damage(partFile(work, 11), 0);
    const refused = start("collect.mjs", collection);
    expect(await refused.ended).toBe(1);
    expect(refused.output()).toContain(`2 of ${jobs} parts (7, 11)`);
    expect(readdirSync(folder).filter((name) => name.startsWith("result"))).toEqual([]);
    await finish("submit.mjs", submission);
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
  const worker = start("worker.mjs", ["--folder", work]);
  for (const signal of ["SIGINT", "SIGKILL"]) {
    const { length } = await listParts(work);
    const submit = start("submit.mjs", submission);
    worker.child.kill("SIGCONT");
    // (all of them, if this process was not given any time for so long)
    await until(async () => (await listParts(work)).length > Math.min(length + 5, 399));
    worker.child.kill("SIGSTOP"); // or it would end the run alone
    submit.child.kill(signal);
    await submit.ended;
    await stopRedis(work); // as Ctrl-C does, which reaches it, too
  }
  const done = (await listParts(work)).map((index) => partFile(work, index));
  const times = done.map((part) => [part, readFileSync(part, "latin1")]);
  worker.child.kill("SIGCONT");
  await finish("submit.mjs", submission);
  for (const [part, text] of times) expect(readFileSync(part, "latin1")).toBe(text);
  await finish("collect.mjs", ["--folder", work, "--out", path.join(folder, "result")]);
  expect(sameFile(path.join(folder, "result.ids.i32"), ids)).toBe(true);
  expect(existsSync(path.join(folder, "result.distances.f64"))).toBe(false);
  worker.child.kill("SIGTERM");
  expect(await worker.ended).toBe(0); // although Redis has gone with submit

  // The folder of one run is not another's.
  const other = start("submit.mjs", [...submission, "--distances"]);
  expect(await other.ended).toBe(1);
  expect(other.output()).toContain("belongs to another run");
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

  const workers = [];
  const run = (name) => {
    const own = `${work}-${name}`;
    works.push(own);
    workers.push(start("worker.mjs", ["--folder", own]));
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
  for (const { child } of workers) child.kill("SIGTERM");
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
