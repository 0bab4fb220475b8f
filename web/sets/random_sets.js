// Random circles with a chosen share of hidden ones: seeded, so that a set can be had again.

/** mulberry32: a small generator of numbers in [0, 1). @param {number} seed */
export function generator(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Finds the circles near a point: buckets as large as the largest circle. */
class Buckets {
  #buckets = new Map();

  constructor(size) {
    this.size = size;
  }

  #key = (x, y) => Math.floor(x / this.size) * 65536 + Math.floor(y / this.size);

  add(circle) {
    const key = this.#key(circle.x, circle.y);
    if (!this.#buckets.has(key)) this.#buckets.set(key, []);
    this.#buckets.get(key).push(circle);
  }

  *near(x, y) {
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        yield* this.#buckets.get(this.#key(x + dx * this.size, y + dy * this.size)) ?? [];
      }
    }
  }
}

const covers = (a, b) => a.r >= b.r && Math.hypot(a.x - b.x, a.y - b.y) <= a.r - b.r;

/**
 * Circles in a rectangle of the given width and height, x, y, r of each. Exactly round(count *
 * hiddenShare) of them lie inside another one; the others overlap here and there but none covers
 * another.
 * @param {{ count: number, hiddenShare: number, seed: number, width: number, height: number }}
 * options
 * @returns {Float64Array}
 */
export function randomCircles({ count, hiddenShare, seed, width, height }) {
  const random = generator(seed);
  const hiddenCount = Math.min(Math.round(count * hiddenShare), Math.max(count - 1, 0));
  const visibleCount = count - hiddenCount;
  const spacing = Math.sqrt((width * height) / Math.max(visibleCount, 1));
  const buckets = new Buckets(spacing);
  const visible = [];
  while (visible.length < visibleCount) {
    // Many small circles, few large ones: up to 0.7 spacings in radius.
    const r = spacing * (0.04 + 0.66 * random() ** 4);
    const circle = { x: random() * width, y: random() * height, r };
    let free = true;
    for (const other of buckets.near(circle.x, circle.y)) {
      // Centres keep away from other circles, mostly: sets look better, and covering is impossible
      // for equal centres.
      const distance = Math.hypot(other.x - circle.x, other.y - circle.y);
      if (covers(other, circle) || covers(circle, other) || distance < 0.6 * Math.max(other.r, r)) {
        free = false;
        break;
      }
    }
    if (!free) continue;
    buckets.add(circle);
    visible.push(circle);
  }
  // Hidden circles sit in covers picked by area, so that large circles hold several.
  const reach = [];
  let sum = 0;
  for (const { r } of visible) {
    sum += r * r;
    reach.push(sum);
  }
  const hidden = Array.from({ length: hiddenCount }, () => {
    const cover = visible[firstAtLeast(reach, random() * sum)];
    const r = cover.r * (0.08 + 0.3 * random());
    const distance = (cover.r - r) * 0.98 * Math.sqrt(random());
    const angle = 2 * Math.PI * random();
    return { x: cover.x + distance * Math.cos(angle), y: cover.y + distance * Math.sin(angle), r };
  });
  const circles = [...visible, ...hidden];
  const xyr = new Float64Array(3 * circles.length);
  circles.forEach(({ x, y, r }, k) => xyr.set([x, y, r], 3 * k));
  return xyr;
}

/** The first index whose value is at least x, in an ascending array. */
function firstAtLeast(values, x) {
  let low = 0;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}
