// The default entry where there is nothing but the language and WebAssembly, as in functions of
// databases: no timers, no fetch, no TextDecoder, no code from strings. Emscripten's part wants to
// have a console to be silent with.
import { readFileSync } from "node:fs";
import { createContext, runInContext } from "node:vm";
import { expect, test } from "@jest/globals";

test("the script builds, finds, saves and restores in an empty context", () => {
  const file = new URL("../../dist/apollonius.js", import.meta.url);
  const codeGeneration = { strings: false, wasm: true };
  const context = createContext(Object.create(null), { codeGeneration });
  runInContext("globalThis.console = { log() {}, error() {} };", context);
  runInContext(readFileSync(file, "utf8"), context);
  const found = runInContext(
    `(() => {
      const { Diagram } = apollonius;
      const bytes = new Diagram([0, 0, 1, 5, 0, 2]).toBytes();
      const diagram = Diagram.fromBytes(bytes);
      try {
        diagram.insert(NaN, 0);
      } catch ({ code }) {
        const area = diagram.voronoi([0, 0, 4, 4]).cellArea(0);
        return [...diagram.findMany([0, 0, 4, 0]), area > 0, code].join();
      }
    })()`,
    context,
  );
  expect(found).toBe("0,1,true,not-finite");
  expect(() => runInContext("eval('1')", context)).toThrow("Code generation from strings");
});
