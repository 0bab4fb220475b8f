// Random circles with a chosen share of hidden ones: seeded, so that a set can be had again.

/** mulberry32: a small generator of numbers in [0, 1). */
export function generator(seed: number) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Circles that can be found near a point: lists in a grid as wide as the largest circle. */
class Grid {
  #columns;
  #rows;
  #first;
  #next;

  /** @param xyr of the circles, by number */
  constructor(
    readonly xyr: Float64Array,
    readonly size: number,
    width: number,
    height: number,
  ) {
    this.#columns = Math.floor(width / size) + 1;
    this.#rows = Math.floor(height / size) + 1;
    this.#first = new Int32Array(this.#columns * this.#rows).fill(-1);
    this.#next = new Int32Array(xyr.length / 3);
  }

  /** @param k of the circle */
  add(k: number) {
    const column = Math.floor(this.xyr[3 * k] / this.size);
    const row = Math.floor(this.xyr[3 * k + 1] / this.size);
    const place = row * this.#columns + column;
    this.#next[k] = this.#first[place];
    this.#first[place] = k;
  }

  /** Whether some circle near a point is as asked. */
  hasNear(x: number, y: number, isAsked: (k: number) => boolean) {
    const column = Math.floor(x / this.size);
    const row = Math.floor(y / this.size);
    const lastRow = Math.min(row + 1, this.#rows - 1);
    const lastColumn = Math.min(column + 1, this.#columns - 1);
    for (let i = Math.max(row - 1, 0); i <= lastRow; i++)
      for (let j = Math.max(column - 1, 0); j <= lastColumn; j++)
        for (let k = this.#first[i * this.#columns + j]; k >= 0; k = this.#next[k])
          if (isAsked(k)) return true;
    return false;
  }
}

/** How far centres keep away from the larger circle, as a share of its radius. */
const kDistance = 0.6;

export type CircleOptions = {
  count: number;
  hiddenShare: number;
  seed: number;
  width: number;
  height: number;
};

/**
 * Circles in a rectangle of the given width and height, x, y, r of each. Exactly round(count *
 * hiddenShare) of them lie inside another one; the others overlap here and there but none covers
 * another.
 */
export function randomCircles({
  count,
  hiddenShare,
  seed,
  width,
  height,
}: CircleOptions): Float64Array {
  const random = generator(seed);
  const hiddenCount = Math.min(Math.round(count * hiddenShare), Math.max(count - 1, 0));
  const visibleCount = count - hiddenCount;
  const spacing = Math.sqrt((width * height) / Math.max(visibleCount, 1));
  const xyr = new Float64Array(3 * count);
  const grid = new Grid(xyr, spacing, width, height);
  for (let n = 0; n < visibleCount; ) {
    // Many small circles, few large ones: up to 0.7 spacings in radius.
    const r = spacing * (0.04 + 0.66 * random() ** 4);
    const x = random() * width;
    const y = random() * height;
    // None covers another; and centres keep away from other circles, which looks better.
    const isTaken = grid.hasNear(x, y, (k) => {
      const other = xyr[3 * k + 2];
      const least = Math.max(kDistance * Math.max(other, r), Math.abs(other - r));
      return Math.hypot(xyr[3 * k] - x, xyr[3 * k + 1] - y) <= least;
    });
    if (isTaken) continue;
    xyr.set([x, y, r], 3 * n);
    grid.add(n++);
  }
  // Hidden circles sit in covers picked by area, so that large circles hold several.
  const reach = new Float64Array(visibleCount);
  let sum = 0;
  for (let k = 0; k < visibleCount; k++) {
    sum += xyr[3 * k + 2] ** 2;
    reach[k] = sum;
  }
  for (let n = visibleCount; n < count; n++) {
    const cover = 3 * firstAtLeast(reach, random() * sum);
    const r = xyr[cover + 2] * (0.08 + 0.3 * random());
    const distance = (xyr[cover + 2] - r) * 0.98 * Math.sqrt(random());
    const angle = 2 * Math.PI * random();
    xyr[3 * n] = xyr[cover] + distance * Math.cos(angle);
    xyr[3 * n + 1] = xyr[cover + 1] + distance * Math.sin(angle);
    xyr[3 * n + 2] = r;
  }
  return xyr;
}

/** The first index whose value is at least x, in an ascending array. */
function firstAtLeast(values: Float64Array, x: number) {
  let low = 0;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}
