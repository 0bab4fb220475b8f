// Lack of memory, call by call: in a full heap every call that needs much memory throws
// "out-of-memory", every other one works, and afterwards the diagram is as it was. (Natively each
// single allocation is made to fail: tests/diagram/out_of_memory_test.cpp.)
import { fileURLToPath } from "node:url";
import { capture } from "../../tools/toolchain/process.mjs";
import { calls } from "./support/calls.mjs";

const program = fileURLToPath(new URL("support/full_heap.mjs", import.meta.url));
let found;
beforeAll(() => {
  found = JSON.parse(capture(process.execPath, [program], { env: { NODE_OPTIONS: "" } }));
}, 300_000); // a quarter of a minute on a quiet machine

test("every call is tried", () => {
  expect(Object.keys(found.results).sort()).toEqual(calls.map(([name]) => name).sort());
});

test.each(["shapes", "sphere"])("the part %s begins when there is room for it", (part) => {
  expect(found.parts[part]).toBe("out-of-memory");
});

test.each(calls.map(([name]) => name))("%s in a full heap", (name) => {
  const { isLarge, code, isSame } = found.results[name];
  expect(code).toBe(isLarge ? "out-of-memory" : "none");
  if (name !== "Diagram.clear") expect(isSame).toBe(true);
  else expect(found.afterClear).toBe(0);
});
