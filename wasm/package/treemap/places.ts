// Places for the sites of siblings in their window: spread by value, seeded.
import { ApolloniusError } from "../errors.js";
import type { Rings } from "./outline.js";
import { boxOf, isInside, Row } from "./rings.js";

const kSamplesOfSite = 16;
const kMostSamples = 30_000; // if there are fewer sites than these
/** A row inside has a sample at least, so no window that doubles know needs more rows a place. */
const kMostRows = 8;

/** A generator of numbers from 0 to 1 (mulberry32), of a seed and a number. */
export function randomOf(seed: number, which: number): () => number {
  let state = Math.imul(which + 1, 0x9e3779b1);
  for (const part of [seed, seed * 2 ** 32]) {
    state = Math.imul(state ^ (part | 0), 0x85ebca6b);
    state ^= state >>> 13;
  }
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Places that are in use, by y and x. */
export class Taken {
  readonly #rows = new Map<number, Set<number>>();

  has(x: number, y: number): boolean {
    return this.#rows.get(y)?.has(x) ?? false;
  }

  add(x: number, y: number): void {
    let row = this.#rows.get(y);
    if (row === undefined) this.#rows.set(y, (row = new Set()));
    row.add(x);
  }
}

/** Part of a window between two lines of constant y, and how wide the window is there. */
interface Band {
  readonly bottom: number;
  readonly top: number;
  readonly width: number;
}

/** The bands between each corner's y and the next where something is inside. */
function bandsOf(rings: Rings): Band[] {
  const heights = rings.flatMap((ring) => Array.from(ring.filter((_, k) => k % 2 === 1)));
  const lines = Float64Array.from(new Set(heights)).sort();
  const bands: Band[] = [];
  for (let k = 0; k + 1 < lines.length; ++k) {
    const [bottom, top] = [lines[k]!, lines[k + 1]!];
    const ends = new Row(rings, bottom + (top - bottom) / 2).crossings();
    const width = ends.reduce((sum, end, at) => sum + (at % 2 === 0 ? -end : end), 0);
    if (width > 0) bands.push({ bottom, top, width });
  }
  return bands;
}

/**
 * At least that many different places inside, x, y, …: in rows, evenly but for a random shift.
 * Throws "no-convergence" where doubles know fewer.
 */
export function samplesIn(rings: Rings, count: number, random: () => number): Float64Array {
  const { xmin, ymin, xmax, ymax } = boxOf(rings);
  const box = { bottom: ymin, top: ymax, width: xmax - xmin };
  // Even rows may miss islands that are thin and far apart; rows of the bands meet them.
  const samples =
    samplesInBands(rings, [box], count, random) ??
    samplesInBands(rings, bandsOf(rings), count, random);
  if (samples === null)
    throw new ApolloniusError("no-convergence", `the window has no room for ${count} places`);
  return samples;
}

/** Samples in rows of these bands; null if `kMostRows` a place are too few. */
function samplesInBands(
  rings: Rings,
  bands: readonly Band[],
  count: number,
  random: () => number,
): Float64Array | null {
  let [area, width, height] = [0, 0, 0];
  for (const band of bands) {
    area += (band.top - band.bottom) * band.width;
    width += band.width;
    height += band.top - band.bottom;
  }
  const side = Math.sqrt(area / count);
  // However thin the window is, no more columns or rows than places.
  let apart = Math.max(side, width / count);
  let above = Math.max(side, height / count);
  for (; height / above <= kMostRows * count; apart /= 2, above /= 2) {
    const places: number[] = [];
    for (const { bottom, top } of bands) {
      const rows = Math.ceil((top - bottom) / above);
      let lastY = NaN;
      for (let row = 0; row < rows; ++row) {
        const y = bottom + ((row + 0.05 + 0.9 * random()) / rows) * (top - bottom);
        if (y === lastY) continue; // closer than doubles
        lastY = y;
        addRow(places, new Row(rings, y), apart, random);
      }
    }
    if (places.length >= 2 * count) return new Float64Array(places);
  }
  return null;
}

/** Adds places of a row that are inside, about so far apart. */
function addRow(places: number[], row: Row, apart: number, random: () => number): void {
  const ends = row.crossings();
  for (let k = 0; k + 1 < ends.length; k += 2) {
    const length = ends[k + 1]! - ends[k]!;
    const columns = Math.ceil(length / apart);
    const shift = 0.05 + 0.9 * random();
    let lastX = NaN;
    for (let column = 0; column < columns; ++column) {
      const x = ends[k]! + ((column + shift) / columns) * length;
      if (x === lastX || !row.isInside(x)) continue;
      places.push(x, row.y);
      lastX = x;
    }
  }
}

/**
 * A place for each value, x, y, …: the samples are split in two, across the longer side of their
 * box, as the values are, and so on. Those beside each other in the list get places near each
 * other. All are different, and inside.
 */
export function spread(
  rings: Rings,
  values: ArrayLike<number>,
  random: () => number,
): Float64Array {
  const count = values.length;
  const wanted = Math.max(2 * count, Math.min(kSamplesOfSite * count, kMostSamples));
  const samples = samplesIn(rings, Math.max(32, wanted), random);
  const sums = new Float64Array(count + 1);
  for (let k = 0; k < count; ++k) sums[k + 1] = sums[k]! + values[k]!;
  const places = new Float64Array(2 * count);
  // A sample belongs to one part only, so it is free as long as no other part's middle is there.
  const taken = new Taken();
  for (let k = 0; k < samples.length; k += 2) taken.add(samples[k]!, samples[k + 1]!);
  const isFlipped = [random() < 0.5, random() < 0.5];
  const keys = new Float64Array(samples.length / 2);
  // A list of what is still to do: sites and samples from one to before another.
  const all = new Uint32Array(keys.length);
  for (let k = 0; k < all.length; ++k) all[k] = k;
  const rest: [number, number, Uint32Array][] = [[0, count, all]];
  for (let next = rest.pop(); next !== undefined; next = rest.pop()) {
    const [from, to, own] = next;
    if (to - from === 1) {
      places.set(middleOf(rings, samples, own, taken), 2 * from);
      continue;
    }
    const half = (sums[from]! + sums[to]!) / 2;
    let at = from + 1;
    while (at < to - 1 && Math.abs(sums[at + 1]! - half) < Math.abs(sums[at]! - half)) ++at;
    const share = (sums[at]! - sums[from]!) / (sums[to]! - sums[from]!);
    const axis = longerAxis(samples, own);
    const sign = isFlipped[axis] ? -1 : 1;
    for (let k = 0; k < own.length; ++k) keys[own[k]!] = sign * samples[2 * own[k]! + axis]!;
    const split = Math.round(share * own.length);
    const cut = Math.min(Math.max(split, at - from), own.length - (to - at));
    select(own, keys, cut);
    rest.push([from, at, own.subarray(0, cut)], [at, to, own.subarray(cut)]);
  }
  return places;
}

/** Puts the first `count` in the order of the keys in front (Hoare). */
function select(own: Uint32Array, keys: Float64Array, count: number): void {
  let low = 0;
  let high = own.length - 1;
  while (low < high) {
    const pivot = keys[own[(low + high) >> 1]!]!;
    let i = low;
    let j = high;
    while (i <= j) {
      while (keys[own[i]!]! < pivot) ++i;
      while (keys[own[j]!]! > pivot) --j;
      if (i > j) break;
      const kept = own[i]!;
      own[i++] = own[j]!;
      own[j--] = kept;
    }
    if (count <= j) high = j;
    else if (count >= i) low = i;
    else return;
  }
}

function longerAxis(samples: Float64Array, own: Uint32Array): 0 | 1 {
  let [xmin, ymin, xmax, ymax] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < own.length; ++k) {
    const x = samples[2 * own[k]!]!;
    const y = samples[2 * own[k]! + 1]!;
    if (x < xmin) xmin = x;
    if (x > xmax) xmax = x;
    if (y < ymin) ymin = y;
    if (y > ymax) ymax = y;
  }
  return xmax - xmin >= ymax - ymin ? 0 : 1;
}

/** Their centre of gravity, or if that is outside or taken, the sample nearest to it. */
function middleOf(
  rings: Rings,
  samples: Float64Array,
  own: Uint32Array,
  taken: Taken,
): [number, number] {
  let [x, y] = [0, 0];
  for (const k of own) {
    x += samples[2 * k]! / own.length;
    y += samples[2 * k + 1]! / own.length;
  }
  if (taken.has(x, y) || !isInside(rings, x, y)) return nearestOf(samples, own, x, y);
  taken.add(x, y);
  return [x, y];
}

function nearestOf(
  samples: Float64Array,
  own: Iterable<number>,
  x: number,
  y: number,
): [number, number] {
  let [best, least] = [0, Infinity];
  for (const k of own) {
    const [dx, dy] = [samples[2 * k]! - x, samples[2 * k + 1]! - y];
    const square = dx * dx + dy * dy;
    if (square < least) [best, least] = [k, square];
  }
  return [samples[2 * best]!, samples[2 * best + 1]!];
}

/**
 * Given places, where NaN is for none, as different ones inside the window: what is outside, or
 * taken, is replaced by the nearest free sample; what is missing by that farthest from all others.
 */
export function settled(rings: Rings, given: Float64Array, random: () => number): Float64Array {
  const count = given.length / 2;
  const places = given.slice();
  const taken = new Taken();
  const open: number[] = [];
  for (let k = 0; k < count; ++k) {
    const [x, y] = [places[2 * k]!, places[2 * k + 1]!];
    if (isInside(rings, x, y) && !taken.has(x, y)) taken.add(x, y);
    else open.push(k);
  }
  if (open.length === 0) return places;
  const samples = samplesIn(rings, Math.max(64, 4 * count), random);
  const free = new Set(
    Array.from({ length: samples.length / 2 }, (_, k) => k).filter(
      (k) => !taken.has(samples[2 * k]!, samples[2 * k + 1]!),
    ),
  );
  const settledOnes = new Set(Array.from({ length: count }, (_, k) => k));
  for (const k of open) settledOnes.delete(k);
  // Distance of each sample from the nearest place, as far as that is known.
  const room = new Float64Array(samples.length / 2).fill(Infinity);
  const narrow = (x: number, y: number) => {
    for (const s of free) {
      const [dx, dy] = [samples[2 * s]! - x, samples[2 * s + 1]! - y];
      room[s] = Math.min(room[s]!, dx * dx + dy * dy);
    }
  };
  for (const k of settledOnes) narrow(places[2 * k]!, places[2 * k + 1]!);
  for (const k of open) {
    const [x, y] = [places[2 * k]!, places[2 * k + 1]!];
    let [best, least] = [-1, Infinity];
    for (const s of free) {
      const [dx, dy] = [samples[2 * s]! - x, samples[2 * s + 1]! - y];
      const cost = Number.isNaN(x) ? -room[s]! : dx * dx + dy * dy;
      if (best === -1 || cost < least) [best, least] = [s, cost];
    }
    free.delete(best);
    places.set([samples[2 * best]!, samples[2 * best + 1]!], 2 * k);
    narrow(places[2 * k]!, places[2 * k + 1]!);
  }
  return places;
}
