// Shared by the JavaScript contenders: reading a set, and timing an operation in samples. As
// bench/native/contender.h.
import { existsSync, readFileSync } from "node:fs";

const kMostSamples = 200;

const wallTime = () => performance.now();

/** Milliseconds of this process on a processor: what others do at the time does not count. */
export function processorTime() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** Raw little-endian doubles. */
export function readDoubles(file) {
  if (!existsSync(file)) throw new Error(`no file ${file}`);
  const bytes = readFileSync(file);
  return new Float64Array(
    bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength),
  );
}

/**
 * The queries of an operation as x, y pairs: near sites if its name ends so, else uniform in the
 * bounding box.
 */
export function readQueries({ set, operation, count }) {
  const points = readDoubles(`${set}${operation.endsWith("Near") ? ".near" : ".box"}`);
  return count > 0 ? points.subarray(0, 2 * count) : points;
}

/** The centres of a set, as x, y pairs. */
export function readCentres(set) {
  const sites = readDoubles(`${set}.sites`);
  return Float64Array.from(
    { length: (sites.length / 3) * 2 },
    (_, k) => sites[3 * (k >> 1) + (k & 1)],
  );
}

// No forced garbage collection between samples: it throws optimised code away (delaunator became
// six times slower).
/**
 * Takes samples: `prepare()` is not timed, `work()` is. Where it returns what `forEachUntil` does,
 * the answer has the sink of the last sample, and whether one was cut off. `clock()` is in
 * milliseconds.
 */
export function sampled(request, items, work, prepare = () => {}, clock = wallTime) {
  const { seconds, least = 1, most = kMostSamples } = request;
  const samples = [];
  let measured = 0;
  let last;
  do {
    prepare();
    const start = clock();
    last = { done: items, ...work() };
    const milliseconds = clock() - start;
    measured += milliseconds / 1000;
    samples.push((1000 * milliseconds) / last.done);
  } while (
    (measured < seconds || samples.length < least) &&
    samples.length < most &&
    last.done === items
  );
  return { samples, items, isCutOff: last.done < items, sink: last.sink };
}

/** `sampled` for work that ends later. */
export async function sampledLater(request, items, work) {
  const samples = [];
  let measured = 0;
  do {
    const start = performance.now();
    await work();
    const milliseconds = performance.now() - start;
    measured += milliseconds / 1000;
    samples.push((1000 * milliseconds) / items);
  } while (measured < request.seconds && samples.length < kMostSamples);
  return { samples, items, isCutOff: false };
}

/**
 * Calls `step(k)` for k = 0, 1, ... `items` times or until the time limit; returns how often, and
 * the sum of the answers.
 */
export function forEachUntil(limit, items, step) {
  const end = performance.now() + 1000 * limit;
  let sink = 0;
  let done = 0;
  for (; done < items; ++done) {
    if ((done & 1023) === 1023 && performance.now() > end) break;
    sink += step(done) ?? 0;
  }
  return { done, sink };
}

/** Samples of an operation's queries; `stepOf(points)` is a function that asks for the k-th. */
export function sampledQueries(request, stepOf) {
  const points = readQueries(request);
  const count = points.length / 2;
  return sampled(request, count, () => forEachUntil(request.limit, count, stepOf(points)));
}

/**
 * Warm-up: repeats an action, so that the engine compiles hot code at its best level before any
 * timing.
 */
export function forMilliseconds(duration, action) {
  const end = performance.now() + duration;
  for (let k = 0; performance.now() < end; ++k) action(k);
}

/** The bounding box of x, y pairs or x, y, r triples: [xmin, ymin, xmax, ymax]. */
export function boxOf(numbers, perItem) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < numbers.length; k += perItem) {
    for (const axis of [0, 1]) {
      box[axis] = Math.min(box[axis], numbers[k + axis]);
      box[2 + axis] = Math.max(box[2 + axis], numbers[k + axis]);
    }
  }
  return box;
}

/**
 * A context to draw into that costs next to nothing: it adds up all numbers, so that the engine
 * cannot leave out any.
 */
export class Sum {
  value = 0;
  moveTo(x, y) {
    this.value += x + y;
  }
  lineTo(x, y) {
    this.value += x + y;
  }
  bezierCurveTo(x1, y1, x2, y2, x, y) {
    this.value += x1 + y1 + x2 + y2 + x + y;
  }
  closePath() {
    this.value += 1;
  }
}
