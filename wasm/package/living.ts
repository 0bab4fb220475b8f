// The native diagram of a Diagram, and the native region of a Voronoi: how long they live, and how
// Voronoi reaches the diagram.
import { described } from "./arguments.js";
import { ApolloniusError } from "./errors.js";
import { type NativeDiagram, type NativeRegion, runningModule } from "./module.js";

type Access = (diagram: unknown, changes: boolean) => NativeDiagram | null;

let access: Access;
let collector: FinalizationRegistry<NativeDiagram | NativeRegion> | undefined;

/** Called once by Diagram, which alone knows the native one and whether it still lives. */
export function provideNative(accessor: Access): void {
  access = accessor;
}

/**
 * The native diagram; throws "disposed" after dispose(), "bad-option" if it is no Diagram, and
 * "busy" for a call that `changes` it while a filter runs.
 */
export function nativeOf(diagram: unknown, changes = false): NativeDiagram {
  const native = access(diagram, changes);
  if (native !== null) return native;
  throw wrongReceiver(diagram);
}

/** The error of a method that was taken off its object, or called on another. */
export function wrongReceiver(receiver: unknown): ApolloniusError {
  return new ApolloniusError(
    "bad-option",
    `a method was called on ${described(receiver)}, expected a Diagram or a Voronoi: call it as ` +
      "diagram.find(x, y) or diagram.voronoi(bounds).cellArea(id)",
  );
}

/** An empty diagram that lives until `destroy`, or until its owner is collected. */
export function createNative(owner: object, location: "hierarchy" | "walk"): NativeDiagram {
  const native = runningModule().create(location);
  keep(owner, native);
  return native;
}

/** A region in the diagram's instance of the module, that lives as long as its owner. */
export function createRegion(
  owner: object,
  diagram: NativeDiagram,
  coordinates: Float64Array,
  starts: Uint32Array,
): NativeRegion {
  let native: NativeRegion;
  try {
    native = diagram.region(coordinates, starts) as NativeRegion;
  } catch (error) {
    if (!(error instanceof ApolloniusError && error.code === "bad-bounds")) throw error;
    throw new ApolloniusError(
      "bad-bounds",
      "the region has no area: its points are in line, or its rings cancel each other",
    );
  }
  keep(owner, native);
  return native;
}

function keep(owner: object, native: NativeDiagram | NativeRegion): void {
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

export function destroy(native: NativeDiagram | NativeRegion): void {
  collector?.unregister(native);
  native.delete();
}
