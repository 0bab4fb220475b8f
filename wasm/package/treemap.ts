// The entry `apollonius-diagram/treemap`, which needs core and shapes.
import { load as loadCore } from "./core.js";
import { load as loadShapes } from "./shapes.js";

export * from "./treemap/api.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";

/** As `load` of `apollonius-diagram/core`, for what treemaps need. */
export async function load(): Promise<void> {
  await Promise.all([loadCore(), loadShapes()]);
}
