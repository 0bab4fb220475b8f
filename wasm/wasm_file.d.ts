// Imports of .wasm files are strings of one character a byte (wasm/build.mjs).
declare module "*.wasm" {
  const text: string;
  export default text;
}
