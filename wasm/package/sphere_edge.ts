// `apollonius-diagram/sphere` where nothing may be compiled, as core_edge.ts is of core.ts.
import compiled from "../../build/wasm/sphere.wasm?module";
import { setSource } from "./core/native/module.js";

export { load } from "./core_edge.js";
export * from "./sphere/api.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";

setSource("sphere", () => compiled);
