// The native diagram of a Diagram, and the native region of a Voronoi: how long they live, and how
// Voronoi reaches the diagram.
import { described } from "./arguments.js";
import { ApolloniusError } from "./errors.js";
import { type NativeDiagram, type NativeRegion, runningModule } from "./module.js";

let access: (diagram: unknown) => NativeDiagram | null;
let collector: FinalizationRegistry<NativeDiagram | NativeRegion> | undefined;

/** Called once by Diagram, which alone knows the native one and whether it still lives. */
export function provideNative(accessor: (diagram: unknown) => NativeDiagram | null): void {
  access = accessor;
}

/** The native diagram; throws "disposed" if there is none any more, "bad-option" for no Diagram. */
export function nativeOf(diagram: unknown): NativeDiagram {
  const native = access(diagram);
  if (native !== null) return native;
  throw new ApolloniusError(
    "bad-option",
    `diagram is ${described(diagram)}, expected a Diagram: diagram.voronoi(bounds) makes a Voronoi`,
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
  const native = diagram.region(coordinates, starts) as NativeRegion;
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

export function destroy(native: NativeDiagram): void {
  collector?.unregister(native);
  native.delete();
}
