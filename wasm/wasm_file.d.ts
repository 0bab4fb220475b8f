// Imports of .wasm files (asTemplate in tools/build.mjs), and of compiled ones (edge.ts).
declare module "*.wasm?module" {
  const compiled: WebAssembly.Module;
  export default compiled;
}
declare module "*.wasm" {
  /**
   * One character a byte, whose code's lower eight bits are the byte; of each pair in `swaps`, the
   * bytes have changed places.
   */
  export const text: string;
  /** a, b, a, b, … */
  export const swaps: readonly number[];
}
