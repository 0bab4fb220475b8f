// How Voronoi reaches the native diagram of a Diagram, which alone knows it and whether it still
// lives.
import type { NativeDiagram } from "./native.js";

let access: (diagram: object) => NativeDiagram;

/** Called once by the class Diagram. */
export function provideNative(accessor: (diagram: object) => NativeDiagram): void {
  access = accessor;
}

/** The native diagram; throws "disposed" if there is none any more. */
export function nativeOf(diagram: object): NativeDiagram {
  return access(diagram);
}
