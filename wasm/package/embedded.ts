// All of the default entry: core and shapes, and these as methods of its diagrams.
import { load as loadCore } from "./core.js";
import { load as loadShapes } from "./shapes.js";

export * from "./core/api.js";
export * from "./shapes/api.js";
export { enclose } from "./shapes/enclose.js";
export { Diagram, type DiagramClass, type Voronoi } from "./shapes/methods.js";

/**
 * Compiles the wasm ahead of its first use and off the main thread. Optional: without it the first
 * diagram and the first shape compile their parts synchronously, a few milliseconds each. Throws
 * "not-loaded" where compiling is forbidden, as they would.
 */
export async function load(): Promise<void> {
  await Promise.all([loadCore(), loadShapes()]);
}
