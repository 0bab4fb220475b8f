// `apollonius-diagram/core` where nothing may be compiled, as on Cloudflare Workers and in Vercel's
// edge runtime: what builds for them compiles the .wasm that is imported. Taken by the package's
// conditions `workerd` and `edge-light`.
import compiled from "../../build/wasm/core.wasm?module";
import { setSource } from "./core/native/module.js";

export * from "./core/api.js";

setSource("core", () => compiled);

/** The part is compiled already. */
export async function load(): Promise<void> {}
