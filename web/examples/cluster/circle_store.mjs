// Circles on disk by where they are (make_store.mjs), as `tile` asks for them.
import { readFileSync } from "node:fs";
import { open } from "node:fs/promises";
import path from "node:path";
import { Grid } from "./grid.mjs";

/** Of circles.f64: x, y, r, id as little-endian doubles. */
export const kRecord = 4;
export const kBytes = 8 * kRecord;

function readDoubles(file) {
  const bytes = readFileSync(file);
  return new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/** The records with centres in a rectangle, as the triples that diagrams take and their ids. */
function separated(records, [xmin, ymin, xmax, ymax]) {
  const xyr = new Float64Array((3 * records.length) / kRecord);
  const ids = new Float64Array(records.length / kRecord);
  let count = 0;
  for (let k = 0; k < records.length; k += kRecord) {
    const [x, y] = [records[k], records[k + 1]];
    if (x < xmin || y < ymin || x > xmax || y > ymax) continue;
    xyr[3 * count] = x;
    xyr[3 * count + 1] = y;
    xyr[3 * count + 2] = records[k + 2];
    ids[count++] = records[k + 3];
  }
  return { xyr: xyr.slice(0, 3 * count), ids: ids.slice(0, count) };
}

const kEverywhere = [-Infinity, -Infinity, Infinity, Infinity];

export class CircleStore {
  #home;

  constructor(home) {
    this.#home = home;
    const index = JSON.parse(readFileSync(path.join(home, "index.json"), "utf8"));
    this.grid = new Grid(index.grid);
    this.bounds = index.grid.bounds;
    this.count = index.count;
    this.mean = index.mean; // of the radii
    this.largest = index.largest ?? -Infinity; // radius beside the giants; there may be none
    this.starts = readDoubles(path.join(home, "starts.f64"));
    this.giants = separated(readDoubles(path.join(home, "giants.f64")), kEverywhere);
  }

  /** All circles, but the giants, with centres in a rectangle. */
  async within([xmin, ymin, xmax, ymax]) {
    const { x, y } = this.grid;
    const [left, right] = [x.bucket(xmin), x.bucket(xmax)];
    const [bottom, top] = [y.bucket(ymin), y.bucket(ymax)];
    const ranges = [];
    for (let row = bottom; row <= top; ++row) {
      const first = row * x.count;
      ranges.push([this.starts[first + left], this.starts[first + right + 1]]);
    }
    const records = new Float64Array(kRecord * ranges.reduce((sum, [a, b]) => sum + b - a, 0));
    const input = await open(path.join(this.#home, "circles.f64"));
    try {
      let at = 0;
      for (const [from, to] of ranges) {
        const bytes = new Uint8Array(records.buffer, at, kBytes * (to - from));
        await input.read(bytes, 0, bytes.length, kBytes * from);
        at += bytes.length;
      }
    } finally {
      await input.close();
    }
    const [least, lowest, most, highest] = this.bounds; // no centre is outside
    const known = [
      xmin <= least ? -Infinity : xmin,
      ymin <= lowest ? -Infinity : ymin,
      xmax >= most ? Infinity : xmax,
      ymax >= highest ? Infinity : ymax,
    ];
    return { ...separated(records, known), known };
  }
}
