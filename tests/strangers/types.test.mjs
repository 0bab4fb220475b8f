// The types under other compilers than the one that made them.
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import { compileUsers } from "../wasm/support/types.mjs";

// TypeScript 7 has no node10.
test.each([
  ["5.2", []],
  ["5.6", []],
  ["7", ["node10"]],
])("TypeScript %s compiles users of the package", (version, without) => {
  const tsc = path.join(root, `tests/strangers/node_modules/typescript-${version}/bin/tsc`);
  compileUsers(tsc, without);
});
