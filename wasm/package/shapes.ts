// The entry `apollonius-diagram/shapes`: windows, drawings and the enclosing circle for diagrams of
// `apollonius-diagram/core`, with their wasm as text, as core.ts has it.
import { swaps, text } from "../../build/wasm/shapes.wasm";
import { embed } from "./core/native/embedded.js";

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

const compiled = embed("shapes", text, swaps);

/** As `load` of `apollonius-diagram/core`, for this part. */
export async function load(): Promise<void> {
  await compiled();
}
