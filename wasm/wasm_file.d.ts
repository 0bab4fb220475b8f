// esbuild gives imports of .wasm files as base64 text (wasm/build.mjs).
declare module "*.wasm" {
  const base64: string;
  export default base64;
}
