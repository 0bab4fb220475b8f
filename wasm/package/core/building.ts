// Building without blocking: in slices of some milliseconds, between which the event loop has a
// turn.
import { ApolloniusError } from "../errors.js";
import type { Reader } from "./accessors.js";
import { described } from "./arguments.js";
import type { DynamicDiagram } from "./dynamic_diagram.js";
import { innerOf } from "./inner.js";
import type { Builder, NativeDiagram } from "./native/module.js";
import type { AsyncOptions } from "./types.js";

const kSlice = 8; // milliseconds
const kItems = 256; // read, or inserted, between two looks at the clock
const kReading = 0.1; // of the whole work, about

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
export async function buildOrDispose(
  diagram: DynamicDiagram<unknown>,
  items: Reader,
  options: AsyncOptions,
): Promise<void> {
  try {
    const { native, ballast } = innerOf(diagram);
    await build(native as NativeDiagram, items, options); // the sphere has the same calls
    ballast.carry(items.count);
  } catch (error) {
    diagram.dispose();
    throw error;
  }
}

async function build(native: NativeDiagram, items: Reader, options: AsyncOptions): Promise<void> {
  const slices = new Slices(options);
  const builder = native.builder(items.count) as Builder;
  try {
    for (let from = 0; from < items.count; from += kItems) {
      native.addTo(builder, items.triples(from, Math.min(from + kItems, items.count)));
      if (slices.isOver) await slices.next((kReading * from) / items.count);
    }
    while (!native.advance(builder, kItems)) {
      if (slices.isOver) await slices.next(kReading + (1 - kReading) * builder.progress());
    }
    await slices.next(1);
  } finally {
    builder.delete();
  }
}
