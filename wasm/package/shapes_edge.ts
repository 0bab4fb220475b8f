// `apollonius-diagram/shapes` where nothing may be compiled, as core_edge.ts is of core.ts.
import compiled from "../../build/wasm/shapes.wasm?module";
import { setSource } from "./core/native/module.js";

export * from "./shapes/api.js";
export {
  edges,
  render,
  renderHull,
  renderSites,
  smallestEnclosingCircle,
  voronoi,
} from "./shapes/functions.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";

setSource("shapes", () => compiled);

/** The part is compiled already. */
export async function load(): Promise<void> {}
