// The default entry where nothing may be compiled, as on Cloudflare Workers and in Vercel's edge
// runtime: what builds for them compiles the .wasm that is imported. Taken by the package's
// conditions `workerd` and `edge-light`.
import compiled from "../../build/wasm/apollonius.wasm?module";
import { load as loadFrom } from "./wasm.js";

export * from "./wasm.js";

void loadFrom(compiled); // does not wait, and starts nothing before the first diagram

/** The module is compiled already. */
export async function load(): Promise<void> {}
