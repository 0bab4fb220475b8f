// The entry `apollonius-diagram/sphere`. It shares the running module with the default entry, which
// it imports by the package's name (tools/build.mjs), and carries the module's second part as text.
import { swaps, text } from "../../build/wasm/sphere.wasm";
import { setSphereSource } from "./native/module.js";
import { bytesOf } from "./native/wasm_text.js";

export * from "./sphere/sphere_api.js";

let compiled: WebAssembly.Module | undefined;
setSphereSource(() => (compiled ??= new WebAssembly.Module(bytesOf(text, swaps))));
