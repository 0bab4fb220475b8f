// Each format: jobs hold every point once and in order, and what does not fit is named.
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { expect, test } from "@jest/globals";
import * as Arrow from "apache-arrow";
import { formatOf, formats } from "../../web/examples/cluster/formats/index.mjs";
import { bytesOf, emptyFolder, readDoubles } from "./support/files.mjs";

const folder = emptyFolder("formats");
const xy = Float64Array.from({ length: 2000 }, (_, k) => (k % 2 ? -k : k) / 7);

function file(name, content) {
  writeFileSync(path.join(folder, name), content);
  return path.join(folder, name);
}

/** All points of a file by its jobs of about `perJob`, one job after the other. */
async function throughJobs(input, perJob, columns) {
  const { split, read } = formats[formatOf(input)];
  const ranges = JSON.parse(JSON.stringify(await split(input, { perJob, columns }))); // as in Redis
  const points = [];
  for (const range of ranges) points.push(...(await read(input, range)));
  return { points, jobs: ranges.length };
}

function lines(end, row = (x, y) => `${x},${y}`) {
  return Array.from({ length: 1000 }, (_, k) => row(xy[2 * k], xy[2 * k + 1], k) + end).join("");
}

/** An Arrow file of columns, in batches of this many rows. */
function arrowFile(name, columns, rows) {
  const table = new Arrow.Table(columns);
  const batches = [];
  for (let k = 0; k < table.numRows; k += rows) batches.push(...table.slice(k, k + rows).batches);
  return file(name, Arrow.RecordBatchFileWriter.writeAll(batches).toUint8Array(true));
}
const axis = (k) =>
  Arrow.makeVector(Float64Array.from({ length: 1000 }, (_, row) => xy[2 * row + k]));

test.each([1, 7, 999, 1000, 5000])("binary: jobs of %i", async (perJob) => {
  const { points, jobs } = await throughJobs(file("points.f64", bytesOf(xy)), perJob);
  expect(points).toEqual([...xy]);
  expect(jobs).toBe(Math.ceil(1000 / perJob));
});

const csv = {
  "with a heading": `x,y\n${lines("\n")}`,
  "without one": lines("\n"),
  "with CRLF": `x,y\r\n${lines("\r\n")}`,
  "without an end": lines("\n").trimEnd(),
  "with blank lines": lines("\n", (x, y, k) => `${x},${y}${k % 10 ? "" : "\n"}`),
  "with more columns": `name,y,x\n${lines("\n", (x, y) => `"a, ""b""",${y},${x}`)}`,
  "with a byte order mark": `\ufeffx,y\n${lines("\n")}`,
};
test.each(Object.keys(csv))("CSV %s", async (name) => {
  const input = file("points.csv", csv[name]);
  for (const perJob of [1, 10, 33, 1e6])
    expect((await throughJobs(input, perJob)).points).toEqual([...xy]);
  expect((await throughJobs(input, 10)).jobs).toBeGreaterThan(20);
});

test("CSV: columns by their names, and what is no number", async () => {
  const named = file("named.csv", `lat,lon\n${lines("\n", (x, y) => `${y},${x}`)}`);
  expect((await throughJobs(named, 100, ["lon", "lat"])).points).toEqual([...xy]);
  await expect(throughJobs(named, 100)).rejects.toThrow("no columns x, y among lat, lon");
  for (const bad of ["1,", "1", ",", "1,b", "1,Infinity", "1,NaN"]) {
    const input = file("bad.csv", `x,y\n1,2\n${bad}\n`);
    await expect(throughJobs(input, 100)).rejects.toThrow("row 1");
  }
});

test.each([10, 64, 1000])("Arrow: batches of %i", async (rows) => {
  const input = arrowFile("points.arrow", { x: axis(0), y: axis(1) }, rows);
  for (const perJob of [1, 100, 1e6])
    expect((await throughJobs(input, perJob)).points).toEqual([...xy]);
  expect((await throughJobs(input, 1)).jobs).toBe(Math.ceil(1000 / rows));
});

test("Arrow: other numbers and names; no nulls, no texts", async () => {
  const whole = Arrow.vectorFromArray([1n, 2n], new Arrow.Int64());
  const single = Arrow.vectorFromArray([0.5, 1.5], new Arrow.Float32());
  const input = arrowFile("numbers.arrow", { lon: whole, lat: single }, 1);
  expect((await throughJobs(input, 1, ["lon", "lat"])).points).toEqual([1, 0.5, 2, 1.5]);
  await expect(throughJobs(input, 1)).rejects.toThrow("no column x");
  const holes = arrowFile("holes.arrow", { x: Arrow.vectorFromArray([1, null]), y: single }, 2);
  await expect(throughJobs(holes, 1)).rejects.toThrow("nulls in column x");
  const texts = arrowFile("texts.arrow", { x: Arrow.vectorFromArray(["a", "b"]), y: single }, 2);
  await expect(throughJobs(texts, 1)).rejects.toThrow("column x is");
});

test("what is no whole number of pairs, or of an unknown kind, is refused", async () => {
  await expect(throughJobs(file("odd.f64", new Uint8Array(24)), 1)).rejects.toThrow("24 bytes");
  expect(() => formatOf("points.txt")).toThrow("points.txt: expected one of");
});

test.each(
  Object.keys(formats),
)("%s: joined parts are what one part of all would be", async (name) => {
  const { encode, join } = formats[name];
  const ids = Int32Array.from({ length: 100 }, (_, k) => k * 3);
  const distances = Float64Array.from(ids, (id) => id / 3.7);
  for (const isAsked of [true, false]) {
    const part = (from, to) =>
      encode(ids.slice(from, to), isAsked ? distances.slice(from, to) : undefined);
    const parts = [part(0, 30), part(30, 30), part(30, 100)];
    const out = path.join(folder, `joined-${name}`);
    const written = await join(
      out,
      async function* () {
        yield* parts;
      },
      { distances: isAsked },
    );
    if (name === "binary") {
      expect(readFileSync(written[0]).equals(Buffer.from(bytesOf(ids)))).toBe(true);
      if (isAsked) expect([...readDoubles(written[1])]).toEqual([...distances]);
      expect(written).toHaveLength(isAsked ? 2 : 1);
    } else if (name === "csv") {
      const rows = Array.from(ids, (id, k) => (isAsked ? `${id},${distances[k]}` : `${id}`));
      const text = [isAsked ? "id,distance" : "id", ...rows, ""].join("\n");
      expect(readFileSync(written[0], "utf8")).toBe(text);
    } else {
      const table = Arrow.tableFromIPC(readFileSync(written[0]));
      expect([...table.getChild("id")]).toEqual([...ids]);
      expect([...(table.getChild("distance") ?? [])]).toEqual(isAsked ? [...distances] : []);
    }
  }
});
