// Sorts a file of circles by where they are, into the buckets of a grid, row after row: those of a
// rectangle are then a few ranges of one file. Three passes over the input in pieces, so the memory
// does not depend on its size; the largest circles go to a file of their own.
import { mkdir, rename, rm } from "node:fs/promises";
import path from "node:path";
import { CircleStore, kBytes, kRecord } from "./circle_store.mjs";
import { withFile } from "./files.mjs";
import { formatOf, formats } from "./formats/index.mjs";
import { Grid } from "./grid.mjs";

const kInput = 3; // x, y, r
const kPiece = 1 << 21; // circles at once
const kRange = 1 << 18; // circles that are read at once, as texts take more memory than numbers
const kBucketsInTile = 64;
const kMostBuckets = 1 << 24;

/**
 * Makes a store, a folder that is whole or not there, and opens it. `window` is inside the grid,
 * wherever circles are; `columns` are the names of x, y and r in formats that have names.
 */
export async function makeStore(home, file, options) {
  const draft = `${home}.draft`;
  await rm(draft, { recursive: true, force: true }); // of one that was killed
  try {
    await fillStore(draft, file, options);
    await rename(draft, home);
  } finally {
    await rm(draft, { recursive: true, force: true });
  }
  return CircleStore.open(home);
}

async function fillStore(home, file, { window, perTile, columns = ["x", "y", "r"] }) {
  const { split, read } = formats[formatOf(file)];
  const ranges = await split(file, { perJob: kRange, columns });
  const pieces = () => piecesOf(ranges, (range) => read(file, range));
  await mkdir(home, { recursive: true });
  const { bounds, count, mean, giants, largest } = await survey(file, pieces, perTile / 10, window);
  if (count === 0) throw new Error(`${file} is empty`);
  const buckets = Math.min(kMostBuckets, Math.ceil((kBucketsInTile * count) / perTile));
  const layout = Grid.of(bounds, buckets);
  const grid = new Grid(layout);

  const isGiant = new Set(giants.map(({ id }) => id));
  const starts = new Float64Array(grid.size + 1); // counts, one place further; then their sums
  for await (const { xyr, first } of pieces())
    for (let k = 0; k < xyr.length; k += kInput)
      if (!isGiant.has(first + k / kInput)) ++starts[grid.bucket(xyr[k], xyr[k + 1]) + 1];
  for (let k = 1; k < starts.length; ++k) starts[k] += starts[k - 1];
  await sortInto(path.join(home, "circles.f64"), pieces, grid, starts, isGiant);

  const write = (name, bytes) =>
    withFile(path.join(home, name), "w", async (output) => {
      await output.writeAll(bytes);
      await output.sync();
    });
  const doubles = (values) => Buffer.from(Float64Array.from(values).buffer);
  await write("starts.f64", doubles(starts));
  await write("giants.f64", doubles(giants.flatMap(({ x, y, r, id }) => [x, y, r, id])));
  const index = { grid: layout, count, giantCount: giants.length, mean, largest };
  await write("index.json", Buffer.from(JSON.stringify(index)));
}

/** The circles of all ranges in pieces of `kPiece`, whatever a format's ranges hold. */
async function* piecesOf(ranges, read) {
  let first = 0,
    piece = new Float64Array(kInput * kPiece),
    filled = 0;
  for (const range of ranges) {
    const rows = await read(range);
    for (let from = 0; from < rows.length; ) {
      const some = rows.subarray(from, from + piece.length - filled);
      piece.set(some, filled);
      from += some.length;
      filled += some.length;
      if (filled < piece.length) continue;
      yield { xyr: piece, first };
      first += kPiece;
      piece = new Float64Array(kInput * kPiece);
      filled = 0;
    }
  }
  if (filled > 0) yield { xyr: piece.subarray(0, filled), first };
}

/** How many circles, where, and how large; `largest` is the largest radius beside the giants. */
async function survey(file, pieces, giantCount, window) {
  let [xmin, ymin, xmax, ymax] = window ?? [Infinity, Infinity, -Infinity, -Infinity];
  let count = 0,
    sum = 0,
    giants = [],
    least = -Infinity; // what is not larger than this is no giant
  const most = Math.floor(giantCount) + 1; // one more, which is the largest of the others
  const prune = () => {
    giants.sort((a, b) => b.r - a.r || a.id - b.id).splice(most);
    if (giants.length === most) least = giants.at(-1).r;
  };
  for await (const { xyr, first } of pieces()) {
    for (let k = 0; k < xyr.length; k += kInput) {
      const [x, y, r] = [xyr[k], xyr[k + 1], xyr[k + 2]];
      if (!Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(r))
        throw new Error(`${file}: circle ${first + k / kInput} is ${x}, ${y}, ${r}`);
      xmin = Math.min(xmin, x);
      ymin = Math.min(ymin, y);
      xmax = Math.max(xmax, x);
      ymax = Math.max(ymax, y);
      sum += r;
      if (r > least) giants.push({ x, y, r, id: first + k / kInput });
      if (giants.length > 2 * most) prune();
    }
    count += xyr.length / kInput;
  }
  prune();
  const largest = giants.length === most ? giants.pop().r : undefined;
  return { bounds: [xmin, ymin, xmax, ymax], count, mean: sum / count, giants, largest };
}

/** Sorts each piece by buckets, and writes each bucket's run to where that has got to. */
function sortInto(target, pieces, grid, starts, isGiant) {
  const next = starts.slice(0, -1);
  return withFile(target, "w", async (output) => {
    for await (const { xyr, first } of pieces()) {
      const order = new Float64Array(xyr.length / kInput); // bucket, then place in the piece
      let count = 0;
      for (let k = 0; k < order.length; ++k)
        if (!isGiant.has(first + k))
          order[count++] = grid.bucket(xyr[kInput * k], xyr[kInput * k + 1]) * kPiece + k;
      order.subarray(0, count).sort();
      const records = new Float64Array(kRecord * count);
      for (let at = 0; at < count; ++at) {
        const k = order[at] % kPiece;
        records.set(xyr.subarray(kInput * k, kInput * k + kInput), kRecord * at);
        records[kRecord * at + kInput] = first + k;
      }
      const bucketAt = (at) => Math.floor(order[at] / kPiece);
      for (let from = 0, to = 0; from < count; from = to) {
        const bucket = bucketAt(from);
        while (to < count && bucketAt(to) === bucket) ++to;
        const run = new Uint8Array(records.buffer, kBytes * from, kBytes * (to - from));
        await output.writeAll(run, kBytes * next[bucket]);
        next[bucket] += to - from;
      }
    }
    await output.sync();
  });
}
