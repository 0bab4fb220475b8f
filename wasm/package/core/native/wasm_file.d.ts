// Imports of .wasm files (asString in tools/build.mjs), and of compiled ones (edge.ts).
declare module "*.wasm?module" {
  const compiled: WebAssembly.Module;
  export default compiled;
}
declare module "*.wasm" {
  /**
   * One character a byte, whose code is the byte; but the bytes of each pair in `swaps` have
   * changed places.
   */
  export const text: string;
  /** a, b, a, b, … */
  export const swaps: readonly number[];
}
