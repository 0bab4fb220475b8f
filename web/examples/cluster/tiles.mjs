// The tiles of a store: rectangles of whole buckets, of about as many circles each however these
// are spread; and their parts put together.
import { cellFormats } from "./cells/index.mjs";
import { withFile } from "./files.mjs";

const kSpacings = 4; // that are looked around a tile at first, beside the radii
const kSlice = 1 << 27; // ids whose areas are summed at once, in a GB of memory

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

/** The first ids of the slices, and the name of the section of a part that has one's areas. */
function* slices(count, slice) {
  for (let first = 0; first < count; first += slice) yield { first, name: `areas.${first}` };
}

/**
 * The areas of a part, pairs of id and area, in a section for each slice of all ids: who sums the
 * areas of a slice reads no others.
 */
export function areaSections(pairs, count, slice = kSlice) {
  const sections = {};
  for (const { first, name } of slices(count, slice)) {
    const own = [];
    for (let k = 0; k < pairs.length; k += 2)
      if (pairs[k] >= first && pairs[k] < first + slice) own.push(pairs[k], pairs[k + 1]);
    sections[name] = new Uint8Array(Float64Array.from(own).buffer);
  }
  return sections;
}

/**
 * Writes `out`.areas.f64, the area of each circle's cell in the window by id, and a file of cells
 * in each format that was asked for. Each section of the parts is read once, whatever there is of
 * circles and formats; the memory depends on neither.
 */
export async function join(out, parts, common, slice = kSlice) {
  const file = `${out}.areas.f64`;
  let features = 0; // as many pairs there are
  await withFile(file, "w", async (output) => {
    for (const { first, name } of slices(common.count, slice)) {
      const areas = new Float64Array(Math.min(slice, common.count - first));
      for await (const { [name]: bytes } of parts([name])) {
        const pairs = new Float64Array(bytes.buffer);
        for (let k = 0; k < pairs.length; k += 2) areas[pairs[k] - first] += pairs[k + 1];
        features += pairs.length / 2;
      }
      await output.writeAll(new Uint8Array(areas.buffer));
    }
  });
  const files = [file];
  for (const format of common.cells)
    files.push(...(await cellFormats[format].join(out, parts, { ...common, features })));
  return files;
}
