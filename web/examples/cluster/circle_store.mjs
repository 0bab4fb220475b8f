// Circles on disk by where they are (make_store.mjs), as `tile` asks for them.
import path from "node:path";
import { readWhole, withFile } from "./files.mjs";
import { Grid } from "./grid.mjs";

/** A record of circles.f64: x, y, r, id as little-endian doubles. */
export const kRecord = 4;
export const kBytes = 8 * kRecord;

const doublesOf = (bytes) => new Float64Array(bytes.buffer);

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

const kRemedy = "remove the folder that it is in, and start build.mjs again";
const kEverywhere = [-Infinity, -Infinity, Infinity, Infinity];

function refuseLength(file, size, length) {
  if (size !== length)
    throw new Error(`${file} has ${size} bytes, not ${length}: it is damaged; ${kRemedy}`);
}

function indexOf(file, bytes) {
  try {
    return JSON.parse(bytes);
  } catch {
    throw new Error(`${file} is damaged; ${kRemedy}`);
  }
}

export class CircleStore {
  #file;

  /** Opens the store in a folder; refuses files that are not as long as the index says. */
  static async open(home) {
    const inHome = (name) => path.join(home, name);
    const read = async (name, length) => {
      const bytes = await readWhole(inHome(name));
      refuseLength(inHome(name), bytes.length, length);
      return doublesOf(bytes);
    };
    const index = indexOf(inHome("index.json"), await readWhole(inHome("index.json")));
    const grid = new Grid(index.grid);
    const starts = await read("starts.f64", 8 * (grid.size + 1));
    const giants = await read("giants.f64", kBytes * index.giantCount);
    const file = inHome("circles.f64");
    const size = await withFile(file, "r", (input) => input.size());
    refuseLength(file, size, kBytes * (index.count - index.giantCount));
    refuseLength(file, size, kBytes * starts.at(-1));
    return new CircleStore(file, { ...index, grid, starts, giants }, index.grid.bounds);
  }

  constructor(file, { grid, starts, giants, count, mean, largest }, bounds) {
    this.#file = file;
    this.grid = grid;
    this.bounds = bounds;
    this.count = count;
    this.mean = mean; // of the radii
    this.largest = largest ?? -Infinity; // radius beside the giants; there may be none
    this.starts = starts;
    this.giants = separated(giants, kEverywhere);
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
    await withFile(this.#file, "r", async (input) => {
      let at = 0;
      for (const [from, to] of ranges) {
        const some = await input.readAll(kBytes * (to - from), kBytes * from);
        records.set(doublesOf(some), at);
        at += kRecord * (to - from);
      }
    });
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
