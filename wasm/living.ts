// The native diagram of a Diagram: how long it lives, and how Voronoi reaches it.
import { described } from "./arguments.js";
import { ApolloniusError } from "./errors.js";
import { type NativeDiagram, runningModule } from "./module.js";

let access: (diagram: unknown) => NativeDiagram | null;
let collector: FinalizationRegistry<NativeDiagram> | undefined;

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
  // Some runtimes at the edge have none: there, what is forgotten stays until the process ends.
  if (typeof FinalizationRegistry !== "undefined") {
    collector ??= new FinalizationRegistry((abandoned) => abandoned.delete());
    collector.register(owner, native, native);
  }
  return native;
}

export function destroy(native: NativeDiagram): void {
  collector?.unregister(native);
  native.delete();
}
