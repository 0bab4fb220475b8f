// Building without blocking: in slices of some milliseconds, between which the event loop has a
// turn.
import { ApolloniusError } from "../errors.js";
import type { Reader } from "./accessors.js";
import { checkedBytes, described } from "./arguments.js";
import type { DynamicDiagram } from "./dynamic_diagram.js";
import { innerOf } from "./inner.js";
import type { Builder, NativeDiagram } from "./native/module.js";
import type { AsyncOptions } from "./types.js";

const kSlice = 8; // milliseconds
const kItems = 256; // items that are read, or inserted, between two looks at the clock
const kAll = 2 ** 32 - 1; // steps
const kReading = 0.1; // approximate share of the whole work

/** A turn of the event loop, without the four milliseconds that timers wait for in browsers. */
function turn(): Promise<void> {
  const { setImmediate } = globalThis as { setImmediate?: (task: () => void) => void };
  return new Promise((resolve) => {
    // Messages would keep Node's timers waiting.
    if (setImmediate) setImmediate(resolve);
    else if (typeof MessageChannel !== "function") setTimeout(resolve);
    else {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => {
        port1.close();
        resolve();
      };
      port2.postMessage(null);
    }
  });
}

/** Yields to the event loop, reports progress, and handles abort signals. */
export class Slices {
  readonly #signal: AbortSignal | undefined;
  readonly #onProgress: ((done: number) => void) | undefined;
  #start = performance.now();

  constructor({ signal, onProgress }: AsyncOptions) {
    if (signal !== undefined && typeof signal?.aborted !== "boolean")
      throw badOption("signal", signal, "an AbortSignal");
    if (onProgress !== undefined && typeof onProgress !== "function")
      throw badOption("onProgress", onProgress, "a function of a number");
    this.#signal = signal;
    this.#onProgress = onProgress;
    this.expectNoAbort();
  }

  get isOver(): boolean {
    return performance.now() - this.#start > kSlice;
  }

  async next(done: number): Promise<void> {
    this.#onProgress?.(done);
    await turn();
    this.expectNoAbort();
    this.#start = performance.now();
  }

  /** Throws the signal's reason if it has aborted. */
  expectNoAbort(): void {
    if (this.#signal?.aborted) throw this.#signal.reason;
  }
}

function badOption(name: string, value: unknown, expected: string): ApolloniusError {
  return new ApolloniusError(
    "bad-option",
    `options.${name} is ${described(value)}, expected ${expected}`,
  );
}

/** Fills an empty diagram of the plane or the sphere with items; disposes of it if that fails. */
export function buildOrDispose(
  diagram: DynamicDiagram<unknown>,
  items: Reader,
  options: AsyncOptions,
): Promise<void> {
  const { count } = items;
  return inSlices(diagram, options, count, kReading, async (native, builder, slices) => {
    for (let from = 0; from < count; from += kItems) {
      native.addTo(builder, items.triples(from, Math.min(from + kItems, count)));
      if (slices.isOver) await slices.next((kReading * from) / count);
    }
  });
}

/** Restores a snapshot into an empty diagram. */
export function restore(diagram: DynamicDiagram<unknown>, bytes: unknown, isTrusted: boolean) {
  const { native, ballast, builder } = builderOf(diagram, 0);
  try {
    give(native, builder, bytes, isTrusted);
    while (!native.advance(builder, kAll)) {}
  } finally {
    builder.delete();
  }
  ballast.carry(native.size());
}

/** Restores a snapshot into an empty diagram in slices; disposes of the diagram if that fails. */
export function restoreOrDispose(
  diagram: DynamicDiagram<unknown>,
  bytes: unknown,
  isTrusted: boolean,
  options: AsyncOptions,
): Promise<void> {
  return inSlices(diagram, options, 0, 0, async (native, builder) =>
    give(native, builder, bytes, isTrusted),
  );
}

function give(native: NativeDiagram, builder: Builder, bytes: unknown, isTrusted: boolean): void {
  native.readInto(builder, checkedBytes("bytes", bytes), isTrusted);
}

/** Returns the inside of a diagram of the plane or the sphere, and a builder for `count` items. */
function builderOf(diagram: DynamicDiagram<unknown>, count: number) {
  const { native: any, ballast } = innerOf(diagram);
  const native = any as NativeDiagram;
  return { native, ballast, builder: native.builder(count) as Builder };
}

/** Gives a builder its work with `begin`, which takes that share of the time, and completes it. */
async function inSlices(
  diagram: DynamicDiagram<unknown>,
  options: AsyncOptions,
  count: number,
  share: number,
  begin: (native: NativeDiagram, builder: Builder, slices: Slices) => Promise<void>,
): Promise<void> {
  try {
    const slices = new Slices(options);
    const { native, ballast, builder } = builderOf(diagram, count);
    try {
      await begin(native, builder, slices);
      if (slices.isOver) await slices.next(share);
      while (!native.advance(builder, kItems)) {
        if (slices.isOver) await slices.next(share + (1 - share) * builder.progress());
      }
      await slices.next(1);
    } finally {
      builder.delete();
    }
    ballast.carry(native.size());
  } catch (error) {
    diagram.dispose();
    throw error;
  }
}
