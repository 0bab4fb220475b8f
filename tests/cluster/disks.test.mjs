// Disks that are full: whatever fits when a program ends with 0 is whole; otherwise it ends with 1,
// names the file, and leaves nothing behind. A limit of the size of files does what a full disk
// does: the write that reaches it is short, and the next one fails.
import { mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { afterEach, expect, test } from "@jest/globals";
import { Diagram } from "apollonius-diagram";
import { makeVector, RecordBatchFileWriter, Table } from "apache-arrow";
import { parquetWriteFile } from "hyparquet-writer";
import { withFile } from "../../web/examples/cluster/files.mjs";
import { generator, randomCircles } from "../wasm/support/random.mjs";
import { emptyFolder, writeArray } from "./support/files.mjs";
import { finish, isStack, start, stopAll } from "./support/processes.mjs";

const withRedis = process.env.REDIS_SERVER === "" ? test.skip : test;
const kBlock = 512; // bytes, in which the limit is given
afterEach(stopAll);

const folder = emptyFolder("disks");
const inFolder = (name) => path.join(folder, name);
const random = generator(1);
const xy = Float64Array.from({ length: 8000 }, random);
const circles = Float64Array.from({ length: 6000 }, (_, k) => random() * (k % 3 === 2 ? 0.01 : 1));
writeFileSync(inFolder("snapshot.bin"), new Diagram(randomCircles(100, 1, 3)).toBytes());
writeArray(inFolder("circles.f64"), circles);
writeArray(inFolder("points.f64"), xy);
const lines = Array.from({ length: 4000 }, (_, k) => `${xy[2 * k]},${xy[2 * k + 1]}\n`);
const text = `x,y\n${lines.join("")}`;
writeFileSync(inFolder("points.csv"), text);
writeFileSync(inFolder("points.csv.gz"), gzipSync(text));
const axis = (k) => Float64Array.from({ length: 4000 }, (_, row) => xy[2 * row + k]);
const columns = { x: axis(0), y: axis(1) };
const table = new Table({ x: makeVector(columns.x), y: makeVector(columns.y) });
writeFileSync(inFolder("points.arrow"), RecordBatchFileWriter.writeAll(table).toUint8Array(true));
parquetWriteFile({
  filename: inFolder("points.parquet"),
  columnData: Object.entries(columns).map(([name, data]) => ({ name, data })),
});

/** Words before a command whose files are to have this many blocks at most. */
const limited = (blocks) => [...["sh", "-c", `trap '' XFSZ; ulimit -f ${blocks}; exec "$@"`, "sh"]];

const submit = (work, points) => [
  ...["--folder", work, "--snapshot", inFolder("snapshot.bin"), "--points", inFolder(points)],
  ...["--distances", "--per-job", "1000", "--workers", "1"],
];
const build = (work) => [
  ...["--folder", work, "--circles", inFolder("circles.f64"), "--per-tile", "500"],
  ...["--geojson", "--flatgeobuf", "--geoparquet", "--workers", "1"],
];

/** The files of a folder with their bytes, by their names. */
function contentOf(home) {
  const names = readdirSync(home).sort();
  return names.map((name) => [name, readFileSync(path.join(home, name), "latin1")]);
}

withRedis.each([
  ["submit.mjs", "points.f64"],
  ["submit.mjs", "points.csv"],
  ["submit.mjs", "points.arrow"],
  ["submit.mjs", "points.parquet"],
  ["build.mjs", "circles.f64"],
])("collect, of a run of %s %s", async (program, input) => {
  const work = inFolder(`work-${input}`);
  await finish(program, program === "submit.mjs" ? submit(work, input) : build(work));
  const whole = inFolder(`whole-${input}`);
  mkdirSync(whole);
  await finish("collect.mjs", ["--folder", work, "--out", path.join(whole, "result")]);
  const names = readdirSync(whole);
  const sizes = names.map((name) => statSync(path.join(whole, name)).size / kBlock);
  // of each file: nothing, all but a block, and some in between
  const limits = new Set(sizes.flatMap((size) => [0, size / 3, size - 1].map(Math.floor)));
  for (const limit of [...limits, Math.ceil(Math.max(...sizes))]) {
    const home = emptyFolder("disks-collected");
    const out = path.join(home, "result");
    const before = limited(limit);
    const { ended, output } = start("collect.mjs", ["--folder", work, "--out", out], { before });
    const fits = limit >= Math.max(...sizes);
    expect([limit, await ended]).toEqual([limit, fits ? 0 : 1]);
    expect(contentOf(home)).toEqual(fits ? contentOf(whole) : []);
    if (fits) continue;
    expect(output()).toMatch(/disks-collected.*: file too large\n$/);
    expect(isStack(output())).toBe(false);
  }
});

withRedis.each([
  ["submit.mjs", "a part", (work) => submit(work, "points.f64"), 20, /job \d+: .*\.part: file too/],
  [
    "submit.mjs",
    "the copy of a .gz",
    (work) => submit(work, "points.csv.gz"),
    40,
    /points-\w+\.csv: file too/,
  ],
  ["build.mjs", "the store", build, 60, /store-.*circles\.f64: file too large/],
  ["build.mjs", "a part", build, 130, /job \d+: .*\.part: file too large/],
])(
  "%s, %s: it is named, and is there when it is started again with room",
  async (program, what, args, limit, words) => {
    const work = inFolder(`full-${what}-${program}`);
    const full = start(program, args(work), { before: limited(limit) });
    expect(await full.ended).toBe(1);
    expect(full.output()).toMatch(words);
    expect(isStack(full.output())).toBe(false);
    const known = /^(plan\.json|(points|store|parts)-\w+(\.csv|[/].*\.(part|f64|json))?)$/;
    const drafts = readdirSync(work, { recursive: true }).filter((name) => !known.test(name));
    expect(drafts).toEqual([]);
    await finish(program, args(work));
    await finish("collect.mjs", ["--folder", work, "--out", `${work}-result`]);
  },
);

test("all that was asked for is read, or the file is named", async () => {
  const file = writeArray(inFolder("short.f64"), Float64Array.of(1, 2, 3, 4));
  await withFile(file, "r", async (input) => {
    expect(await input.readAll(32, 0)).toEqual(readFileSync(file));
    expect(await input.readAll(8, 24)).toEqual(readFileSync(file).subarray(24));
    await expect(input.readAll(9, 24)).rejects.toThrow(`${file} has become shorter`);
    await expect(input.readAll(1, 100)).rejects.toThrow(`${file} has become shorter`);
  });
});
