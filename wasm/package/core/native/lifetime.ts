// When the memory that an object of the package has in the module is freed.
import type { AnyNative, NativeReach, NativeRegion } from "./module.js";

type Native = AnyNative | NativeReach | NativeRegion;

let collector: FinalizationRegistry<Native> | undefined;

/** Deletes `native` some time after its owner has been collected. */
export function keep(owner: object, native: Native): void {
  // Some runtimes at the edge have none: there, what is forgotten stays until the process ends.
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

// What makes the engine collect forgotten diagrams in time. Of a diagram it sees a few
// hundred bytes, as the rest is in the one memory that all share; so it waits, until that memory is
// full. Here a diagram holds buffers as long as what it takes there. Engines count them; nobody
// writes to them, so that they are addresses only.

const kBytesOfSite = 162; // docs/PROOFS.md, "What a site costs"
const kStep = 64; // sites: so much is taken by a diagram of few, too
// Making a buffer takes some 0.1 ms, as long as making a diagram of 100 sites. So it is made when
// that much has come together, of many small diagrams, too.
const kBytesOfBuffer = 4 << 20;

/** Bytes of diagrams that no buffer stands for yet. */
let owed = 0;

export class Ballast {
  #sites = 0; // that have been counted
  #buffers: ArrayBuffer[] = [];

  /** Tells that a diagram has this many sites now, or once had. */
  carry(sites: number): void {
    if (sites <= this.#sites) return;
    const counted = Math.ceil(sites / kStep) * kStep;
    owed += kBytesOfSite * (counted - this.#sites);
    this.#sites = counted;
    if (owed < kBytesOfBuffer) return;
    try {
      // One that might shrink is made of pages of its own, which cost nothing before they are used.
      type Resizable = new (length: number, options: { maxByteLength: number }) => ArrayBuffer;
      this.#buffers.push(new (ArrayBuffer as Resizable)(owed, { maxByteLength: owed }));
    } catch {} // no addresses left: then there is none
    owed = 0;
  }

  /** The diagram's memory has been given back. */
  drop(): void {
    owed = Math.max(0, owed - kBytesOfSite * this.#sites);
    this.#sites = 0;
    this.#buffers = [];
  }
}
