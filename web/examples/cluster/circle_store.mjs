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

/** Records as the triples that diagrams take, and their ids. */
function separated(records) {
  const count = records.length / kRecord;
  const xyr = new Float64Array(3 * count);
  const ids = new Float64Array(count);
  for (let k = 0; k < count; ++k) {
    xyr.set(records.subarray(kRecord * k, kRecord * k + 3), 3 * k);
    ids[k] = records[kRecord * k + 3];
  }
  return { xyr, ids };
}

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
    this.giants = separated(readDoubles(path.join(home, "giants.f64")));
  }

  /** All circles, but the giants, of the buckets that a rectangle meets. */
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
    // no centre is outside the grid
    const known = [
      left === 0 ? -Infinity : x.line(left),
      bottom === 0 ? -Infinity : y.line(bottom),
      right === x.count - 1 ? Infinity : x.line(right + 1),
      top === y.count - 1 ? Infinity : y.line(top + 1),
    ];
    return { ...separated(records), known };
  }
}
