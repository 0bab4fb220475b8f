// The entry `apollonius-diagram/sphere`: the diagram of the sphere, which works in the instance of
// the other entries, and the part `core`, on which it rests.
import { swaps, text } from "../../build/wasm/sphere.wasm";
import { load as loadCore } from "./core.js";
import { embed } from "./core/native/embedded.js";

export * from "./sphere/api.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";

const loadSphere = embed("sphere", text, swaps);

/** As `load` of `apollonius-diagram/core`, for what diagrams of the sphere need. */
export async function load(): Promise<void> {
  await Promise.all([loadCore(), loadSphere()]);
}
