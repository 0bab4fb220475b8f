// Imports of .wasm files (asTemplate in tools/build.mjs).
declare module "*.wasm" {
  /**
   * One character a byte, whose code's lower eight bits are the byte; of each pair in `swaps`, the
   * bytes have changed places.
   */
  export const text: string;
  /** a, b, a, b, … */
  export const swaps: readonly number[];
}
