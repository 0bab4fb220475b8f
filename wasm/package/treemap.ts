// The entry `apollonius-diagram/treemap`, which needs core and shapes.
import "./core.js";
import "./shapes.js";

export * from "./treemap/api.js";
export { ApolloniusError, type ErrorCode } from "./errors.js";
