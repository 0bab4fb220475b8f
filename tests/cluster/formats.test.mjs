// Each format: jobs hold every point once and in order, and what does not fit is named.
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import * as zlib from "node:zlib";
import { expect, test } from "@jest/globals";
import * as Arrow from "apache-arrow";
import { asyncBufferFromFile, parquetReadObjects } from "hyparquet";
import { geojsonToWkb, parquetWriteBuffer } from "hyparquet-writer";
import { formatOf, formats } from "../../web/examples/cluster/formats/index.mjs";
import { unpacked } from "../../web/examples/cluster/formats/unpack.mjs";
import { bytesOf, emptyFolder, readDoubles } from "./support/files.mjs";

const folder = emptyFolder("formats");
const xy = Float64Array.from({ length: 2000 }, (_, k) => (k % 2 ? -k : k) / 7);

function file(name, content) {
  writeFileSync(path.join(folder, name), content);
  return path.join(folder, name);
}

/** All points of a file by its jobs of about `perJob`, one job after the other. */
async function throughJobs(input, perJob, columns = ["x", "y"]) {
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

test.each([
  ["semicolons", ",", (k) => `stop${k},12;34;56;78;90`],
  ["cells with commas and tabs", ";", (k) => `a,b,c,d\te\tf${k};g,h,i`],
  ["tabs", "\t", (k) => `a;b;c,d,e,f|${k}\tg`],
  ["bars", "|", (k) => `a;b;c,d,e,f${k}|g`],
])("CSV: every job has the heading's delimiter, beside %s", async (_, to, cells) => {
  const heading = ["name", "lines", "x", "y"].join(to);
  // (where a job guessed for itself, it took another delimiter, and numbers of the second cell)
  const content = lines("\n", (x, y, k) => [cells(k), x, y].join(to));
  const input = file("delimiter.csv", `${heading}\n${content}`);
  for (const perJob of [1, 33, 1e6])
    expect((await throughJobs(input, perJob)).points).toEqual([...xy]);
  const bare = lines("\n", (x, y, k) => [x, y, cells(k)].join(to));
  expect((await throughJobs(file("bare.csv", bare), 33)).points).toEqual([...xy]);
});

test("CSV: lines that end by turns with LF and with CRLF, whatever a job begins with", async () => {
  const row = (x, y, k) => `${x},${y},"${k}"${k % 3 === 0 ? "\r" : ""}`;
  const input = file("ends.csv", `x,y,name\r\n${lines("\n", row)}`);
  for (const perJob of [1, 2, 7, 1e6])
    expect((await throughJobs(input, perJob)).points).toEqual([...xy]);
});

test("Arrow: what is no file of that kind is named", async () => {
  const table = new Arrow.Table({ x: axis(0), y: axis(1) });
  const whole = readFileSync(arrowFile("whole.arrow", { x: axis(0), y: axis(1) }, 100));
  const damaged = Uint8Array.from(whole).fill(7, whole.length - 400, whole.length - 300);
  for (const [name, bytes] of [
    ["stream.arrow", Arrow.tableToIPC(table, "stream")],
    ["text.arrow", "x,y\n1,2\n"],
    ["empty.arrow", ""],
    ["cut.arrow", whole.subarray(0, -100)],
    ["damaged.arrow", damaged],
  ]) {
    const input = file(name, bytes);
    await expect(throughJobs(input, 100)).rejects.toThrow(input);
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

const xs = Array.from({ length: 1000 }, (_, k) => xy[2 * k]);
const ys = Array.from({ length: 1000 }, (_, k) => xy[2 * k + 1]);
const radii = xs.map((x) => x / 3);
const xyr = xs.flatMap((x, k) => [x, ys[k], radii[k]]);
const point = (k) => ({ type: "Point", coordinates: [xs[k], ys[k]] });

/** A Parquet file; `geo` is its GeoParquet metadata. */
function parquetFile(name, columnData, { geo, ...options } = {}) {
  const kvMetadata = geo && [{ key: "geo", value: JSON.stringify(geo) }];
  const buffer = parquetWriteBuffer({ columnData, kvMetadata, rowGroupSize: 1000, ...options });
  return file(name, new Uint8Array(buffer));
}
const double = (name, data) => ({ name, data, type: "DOUBLE" });
const geoOf = (encoding) => ({
  version: "1.1.0",
  primary_column: "geometry",
  columns: { geometry: { encoding, geometry_types: ["Point"] } },
});
const wkb = xs.map((_, k) => geojsonToWkb(point(k)).slice());

test.each([10, 64, 1000])("Parquet: row groups of %i", async (rowGroupSize) => {
  const columns = [double("y", ys), double("r", radii), double("x", xs)];
  const input = parquetFile("points.parquet", columns, { rowGroupSize });
  for (const perJob of [1, 100, 1e6]) {
    expect((await throughJobs(input, perJob)).points).toEqual([...xy]);
    expect((await throughJobs(input, perJob, ["x", "y", "r"])).points).toEqual(xyr);
  }
  expect((await throughJobs(input, 1)).jobs).toBe(Math.ceil(1000 / rowGroupSize));
  expect((await throughJobs(input, 128)).jobs).toBe(rowGroupSize === 1000 ? 1 : 8);
});

test("Parquet: what Node can decompress, and no more", async () => {
  const columns = [double("x", xs), double("y", ys)];
  const codecs = {
    GZIP: zlib.gzipSync,
    BROTLI: zlib.brotliCompressSync,
    ZSTD: zlib.zstdCompressSync,
  };
  for (const [codec, compress] of Object.entries(codecs)) {
    const compressors = { [codec]: compress ?? ((bytes) => bytes) };
    const input = parquetFile(`${codec}.parquet`, columns, { codec, compressors });
    const found = throughJobs(input, 100);
    if (compress) expect((await found).points).toEqual([...xy]);
    else await expect(found).rejects.toThrow(`ZSTD needs Node 22.15, this is ${process.version}`);
  }
});

test("Parquet: other numbers; no nulls, no texts, no damage", async () => {
  const columns = [
    { name: "lon", data: [1n, 2n], type: "INT64" },
    { name: "lat", data: Float32Array.of(0.5, 1.5), type: "FLOAT" },
    { name: "part", data: [1.5, null], type: "DOUBLE" },
    { name: "text", data: ["1", "2"], type: "STRING" },
    { name: "wide", data: [1, Infinity], type: "DOUBLE" },
  ];
  const input = parquetFile("numbers.parquet", columns);
  expect((await throughJobs(input, 1, ["lon", "lat"])).points).toEqual([1, 0.5, 2, 1.5]);
  await expect(throughJobs(input, 1)).rejects.toThrow(/numbers\.parquet has no column x among lon/);
  for (const [name, row] of Object.entries({ part: 1, text: 0, wide: 1 }))
    await expect(throughJobs(input, 1, ["lon", name])).rejects.toThrow(
      `${input}, row ${row}: no number in column ${name}`,
    );
  const cut = file("cut.parquet", readFileSync(input).subarray(0, -9));
  await expect(throughJobs(cut, 1)).rejects.toThrow(`${cut}: `);
  const bytes = readFileSync(parquetFile("damaged.parquet", columns, { codec: "SNAPPY" }));
  bytes.fill(255, 4, 60);
  const damaged = file("damaged.parquet", bytes);
  await expect(throughJobs(damaged, 1, ["lon", "lat"])).rejects.toThrow(
    `${damaged}, rows 0 to 2: `,
  );
});

test("GeoParquet: points as WKB and as x and y, with a column beside them", async () => {
  const geometry = { name: "geometry", data: wkb, type: "BYTE_ARRAY" };
  const asWkb = [geometry, double("size", radii)];
  const schema = [
    { name: "root", num_children: 2 },
    { name: "geometry", num_children: 2, repetition_type: "OPTIONAL" },
    { name: "x", type: "DOUBLE", repetition_type: "REQUIRED" },
    { name: "y", type: "DOUBLE", repetition_type: "REQUIRED" },
    { name: "size", type: "DOUBLE", repetition_type: "REQUIRED" },
  ];
  const asPoint = [
    { name: "geometry", data: xs.map((x, k) => ({ x, y: ys[k] })) },
    { name: "size", data: radii },
  ];
  const native = [
    { name: "geometry", data: xs.map((_, k) => point(k)), type: "GEOMETRY" },
    asWkb[1],
  ];
  const files = [
    parquetFile("wkb.parquet", asWkb, { geo: geoOf("WKB"), rowGroupSize: 300 }),
    parquetFile("point.parquet", asPoint, { geo: geoOf("point"), rowGroupSize: 300, schema }),
    parquetFile("native.parquet", native, { rowGroupSize: 300 }),
  ];
  for (const input of files) {
    const { points, jobs } = await throughJobs(input, 1);
    expect([points, jobs]).toEqual([[...xy], 4]);
    expect((await throughJobs(input, 1, ["x", "y", "size"])).points).toEqual(xyr);
    await expect(throughJobs(input, 1, ["x", "y", "r"])).rejects.toThrow("no column r among");
  }
  // columns of the names that are asked for come before points
  const both = [geometry, double("x", ys), double("y", xs)];
  const { points } = await throughJobs(parquetFile("both.parquet", both, { geo: geoOf("WKB") }), 1);
  expect(points).toEqual(xs.flatMap((x, k) => [ys[k], x]));
  const line = geojsonToWkb({
    type: "LineString",
    coordinates: [
      [0, 0],
      [1, 1],
    ],
  }).slice();
  const empty = geojsonToWkb({ type: "Point", coordinates: [Number.NaN, Number.NaN] }).slice();
  for (const bad of [line, empty, null]) {
    const data = { name: "geometry", data: [wkb[0], bad], type: "BYTE_ARRAY" };
    const input = parquetFile("bad.parquet", [data], { geo: geoOf("WKB") });
    await expect(throughJobs(input, 1)).rejects.toThrow(
      `${input}, row 1: no point in column geometry`,
    );
  }
});

const feature = (k) => ({
  type: "Feature",
  properties: { name: 'a "b" \\ {[\n', r: radii[k], parts: { features: [{}] } },
  geometry: point(k),
});
const features = xs.map((_, k) => feature(k));

test("GeoJSON: lines of features", async () => {
  const text = features.map((each) => `${JSON.stringify(each)}\n`);
  for (const [end, content] of Object.entries({
    plain: text.join(""),
    "with record separators": text.map((line) => `\x1e${line}`).join(""),
    "with CRLF, blank lines, no end": text.join("\r\n").trimEnd(),
  })) {
    const input = file("points.geojsonl", content);
    for (const perJob of [10, 1e6]) {
      expect([end, (await throughJobs(input, perJob)).points]).toEqual([end, [...xy]]);
      expect((await throughJobs(input, perJob, ["x", "y", "r"])).points).toEqual(xyr);
    }
  }
  const good = JSON.stringify(feature(0));
  for (const [bad, problem] of [
    ["{", "no JSON"],
    ["[]", "no feature with a point"],
    ["null", "no feature with a point"],
    [good.replace("Point", "MultiPoint"), "no feature with a point"],
    [good.replace(/"coordinates":\[.*?\]/, '"coordinates":[1]'), "no coordinates"],
    [good.replace('"r":', '"s":'), "no number in property r"],
  ]) {
    const input = file("bad.geojsonl", `${good}\n${bad}\n`);
    await expect(throughJobs(input, 100, ["x", "y", "r"])).rejects.toThrow(
      `${input}, after byte 0, line 1: ${problem}`,
    );
  }
});

test.each([
  undefined,
  2,
])("GeoJSON: a FeatureCollection becomes lines (indent %s), also through .gz", async (indent) => {
  const links = [{ features: [] }, { type: "Feature" }]; // a foreign member
  const collection = { type: "FeatureCollection", links, features, "features:": [[{}]] };
  const content = JSON.stringify(collection, null, indent);
  const copy = path.join(emptyFolder("formats-unpacked"), "copy");
  for (const [name, bytes] of [
    ["points.geojson", content],
    ["points.geojson.gz", zlib.gzipSync(content)],
  ]) {
    const input = await unpacked(file(name, bytes), copy + name);
    expect(input).toBe(`${copy}${name}.geojsonl`);
    const lines = readFileSync(input, "utf8").trimEnd().split("\n");
    expect(lines.map((line) => JSON.parse(line))).toEqual(features);
    expect((await throughJobs(input, 33, ["x", "y", "r"])).points).toEqual(xyr);
  }
});

test("compressed files are unpacked once; what cannot be unpacked is named", async () => {
  const copy = path.join(emptyFolder("formats-unpacked"), "copy");
  const text = `x,y\n${lines("\n")}`;
  // two streams one after the other are one, as gzip and bgzip have it
  const zipped = Buffer.concat(
    [text.slice(0, 999), text.slice(999)].map((each) => zlib.gzipSync(each)),
  );
  const input = await unpacked(file("points.csv.gz", zipped), copy);
  expect(formatOf("points.csv.gz")).toBe("csv");
  expect((await throughJobs(input, 33)).points).toEqual([...xy]);
  writeFileSync(input, "x,y\n1,2\n");
  expect(await unpacked(path.join(folder, "points.csv.gz"), copy)).toBe(input);
  expect((await throughJobs(input, 33)).points).toEqual([1, 2]); // it was not done again
  const plain = file("points.csv", text);
  expect(await unpacked(plain, copy)).toBe(plain);
  for (const [name, bytes, problem] of [
    ["cut.csv.gz", zipped.subarray(0, -20), "unexpected end of file"],
    ["plain.csv.gz", text, "incorrect header check"],
    ["cut.geojson", '{"type":"FeatureCollection","features":[{"a":', "has expected a value"],
    ["lines.geojson", `${JSON.stringify(features[0])}\n`, "no FeatureCollection"],
  ])
    await expect(unpacked(file(name, bytes), copy + name)).rejects.toThrow(
      new RegExp(`${name}: .*${problem}`),
    );
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
    } else if (name === "parquet") {
      const rows = await parquetReadObjects({ file: await asyncBufferFromFile(written[0]) });
      const row = (id, k) => (isAsked ? { id, distance: distances[k] } : { id });
      expect(rows).toEqual(Array.from(ids, row));
    } else if (name === "csv" || name === "geojson") {
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
