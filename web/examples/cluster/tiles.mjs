// The tiles of a store: rectangles of whole buckets, of about as many circles each however these
// are spread; and their parts put together.
import { open } from "node:fs/promises";
import { cellFormats } from "./cells/index.mjs";

const kSpacings = 4; // that are looked around a tile at first, beside the radii
const kSlice = 1 << 26; // areas at once

/** Tiles {window, halo, size} of at most this many circles, or one bucket, inside the window. */
export function planTiles({ grid, starts, largest, mean }, window, perTile) {
  const sums = summed(grid, starts);
  const counted = (left, bottom, right, top) =>
    sums(right, top) - sums(left, top) - sums(right, bottom) + sums(left, bottom);
  const reach = Math.max(0, largest - mean);
  const tiles = [];
  const divide = (left, bottom, right, top) => {
    const [xmin, ymin] = [grid.x.line(left), grid.y.line(bottom)];
    const [xmax, ymax] = [grid.x.line(right), grid.y.line(top)];
    const own = [
      Math.max(xmin, window[0]),
      Math.max(ymin, window[1]),
      Math.min(xmax, window[2]),
      Math.min(ymax, window[3]),
    ];
    if (own[0] >= own[2] || own[1] >= own[3]) return;
    const size = counted(left, bottom, right, top);
    const [width, height] = [right - left, top - bottom];
    if (size <= perTile || width * height === 1) {
      const spacing = Math.sqrt(((xmax - xmin) * (ymax - ymin)) / Math.max(1, size));
      tiles.push({ window: own, halo: kSpacings * spacing + reach, size });
      return;
    }
    // across the longer side, where half of the circles are on either side
    const isWide = height === 1 || (width > 1 && xmax - xmin >= ymax - ymin);
    if (isWide) {
      let middle = left + 1;
      while (middle < right - 1 && 2 * counted(left, bottom, middle, top) < size) ++middle;
      divide(left, bottom, middle, top);
      divide(middle, bottom, right, top);
    } else {
      let middle = bottom + 1;
      while (middle < top - 1 && 2 * counted(left, bottom, right, middle) < size) ++middle;
      divide(left, bottom, right, middle);
      divide(left, middle, right, top);
    }
  };
  divide(0, 0, grid.x.count, grid.y.count);
  return tiles;
}

/** How many circles are in the first buckets of the first rows. */
function summed({ x, y }, starts) {
  const width = x.count + 1;
  const sums = new Float64Array(width * (y.count + 1));
  for (let row = 0; row < y.count; ++row) {
    for (let k = 1; k <= x.count; ++k)
      sums[(row + 1) * width + k] =
        sums[row * width + k] + starts[row * x.count + k] - starts[row * x.count];
  }
  return (column, row) => sums[row * width + column];
}

/**
 * Writes `out`.areas.f64, the area of each circle's cell in the window by id, and a file of cells
 * in each format that was asked for. Circles are taken `kSlice` at a time, so that the memory does
 * not depend on how many there are.
 */
export async function join(out, parts, common) {
  const file = `${out}.areas.f64`;
  const output = await open(file, "w");
  let features; // as many pairs there are
  try {
    for (let first = 0; first < common.count; first += kSlice) {
      features = 0;
      const areas = new Float64Array(Math.min(kSlice, common.count - first));
      for await (const { areas: bytes } of parts()) {
        const pairs = new Float64Array(
          bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length),
        );
        for (let k = 0; k < pairs.length; k += 2) areas[pairs[k] - first] += pairs[k + 1];
        features += pairs.length / 2;
      }
      await output.writeFile(new Uint8Array(areas.buffer));
    }
  } finally {
    await output.close();
  }
  const files = [file];
  for (const format of common.cells)
    files.push(...(await cellFormats[format].join(out, parts, { ...common, features })));
  return files;
}
