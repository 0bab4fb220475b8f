// The native diagram of a Diagram: how long it lives, and how Voronoi reaches it.
import { type NativeDiagram, runningModule } from "./module.js";

let access: (diagram: object) => NativeDiagram;
let collector: FinalizationRegistry<NativeDiagram> | undefined;

/** Called once by Diagram, which alone knows the native one and whether it still lives. */
export function provideNative(accessor: (diagram: object) => NativeDiagram): void {
  access = accessor;
}

/** The native diagram; throws "disposed" if there is none any more. */
export function nativeOf(diagram: object): NativeDiagram {
  return access(diagram);
}

/** An empty diagram that lives until `destroy`, or until its owner is collected. */
export function createNative(owner: object, location: "hierarchy" | "walk"): NativeDiagram {
  const native = runningModule().create(location);
  collector ??= new FinalizationRegistry((abandoned) => abandoned.delete());
  collector.register(owner, native, native);
  return native;
}

export function destroy(native: NativeDiagram): void {
  collector?.unregister(native);
  native.delete();
}
