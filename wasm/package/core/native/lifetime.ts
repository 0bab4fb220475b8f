// Frees the memory that an object of the package has in the module.
import type { AnyNative, NativeReach, NativeRegion } from "./module.js";

type Native = AnyNative | NativeReach | NativeRegion;

let collector: FinalizationRegistry<Native> | undefined;

/** Deletes `native` some time after its owner has been collected. */
export function keep(owner: object, native: Native): void {
  // Some edge runtimes have none: there, forgotten diagrams stay until the process ends.
  if (typeof FinalizationRegistry === "undefined") return;
  collector ??= new FinalizationRegistry((abandoned) => abandoned.delete());
  collector.register(owner, native, native);
}

/** Fills a new diagram; one that cannot be filled is disposed of. */
export function fillOrDispose(diagram: { dispose(): void }, fill: () => unknown): void {
  try {
    fill();
  } catch (error) {
    diagram.dispose();
    throw error;
  }
}

export function destroy(native: Native): void {
  collector?.unregister(native);
  native.delete();
}

// --- Weight --------------------------------------------------------------------------------------

// Makes the engine collect forgotten diagrams in time. The engine sees a few hundred bytes of a
// diagram, as the rest is in the wasm memory that all diagrams share; so it would wait until that
// memory is full. Here a diagram holds buffers as large as its part of the wasm memory. Engines
// count them; nobody writes to them, so that they take addresses only.

const kBytesOfSite = 162; // docs/PROOFS.md, "What a site costs"
const kStep = 64; // sites; counts are rounded up to multiples: few sites take as much, too
// Making a buffer takes some 0.1 ms, as long as making a diagram of 100 sites. So one is made only
// when this many bytes have come together, which may be of many small diagrams.
const kBytesOfBuffer = 4 << 20;

/** Bytes of diagrams that no buffer stands for yet. */
let owed = 0;

export class Ballast {
  #sites = 0; // number of sites counted so far
  #buffers: ArrayBuffer[] = [];

  /** Tells that a diagram has this many sites now, or once had. */
  carry(sites: number): void {
    if (sites <= this.#sites) return;
    const counted = Math.ceil(sites / kStep) * kStep;
    owed += kBytesOfSite * (counted - this.#sites);
    this.#sites = counted;
    if (owed < kBytesOfBuffer) return;
    try {
      // A resizable buffer has pages of its own, which cost nothing before they are used.
      type Resizable = new (length: number, options: { maxByteLength: number }) => ArrayBuffer;
      this.#buffers.push(new (ArrayBuffer as Resizable)(owed, { maxByteLength: owed }));
    } catch {} // no addresses left: no buffer
    owed = 0;
  }

  /** Drops the buffers when the diagram's memory has been given back. */
  drop(): void {
    owed = Math.max(0, owed - kBytesOfSite * this.#sites);
    this.#sites = 0;
    this.#buffers = [];
  }
}
