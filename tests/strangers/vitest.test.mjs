// Vitest, in its own environment and in jsdom: nothing has to be set up, and diagrams are compared
// by their content.
import { symlinkSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { packed } from "../wasm/support/install_packed.mjs";

const modules = path.join(root, "tests/strangers/node_modules");
const source = `
import { Diagram } from "apollonius-diagram";
import { expect, test } from "vitest";

const xyr = [0, 0, 5, 1, 1, 1, 20, 0, 2];

test("the environment", () => {
  expect(typeof document).toBe(process.env.EXPECTED_DOCUMENT);
});
test("equal and different diagrams", () => {
  const [a, b] = [new Diagram(xyr), new Diagram(xyr)];
  expect(a).toEqual(b);
  expect(a).toStrictEqual(b);
  b.update(2, 20, 0, 3);
  expect(a).not.toEqual(b);
  expect(a).not.toStrictEqual(b);
  expect({ state: [a] }).not.toEqual({ state: [b] });
});
test("errors have their class and code", () => {
  expect(() => new Diagram([NaN, 0, 0])).toThrow(/xyr\\[0\\] is NaN/);
});
`;

test.each([
  ["node", "undefined"],
  ["jsdom", "object"],
])("in the environment %s", (environment, document) => {
  const folder = path.join(packed, `vitest-${environment}`);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(path.join(folder, "node_modules"), { recursive: true });
  for (const name of ["vitest", "jsdom"])
    symlinkSync(path.join(modules, name), path.join(folder, "node_modules", name));
  writeFileSync(path.join(folder, "diagram.test.js"), source);
  writeFileSync(
    path.join(folder, "vitest.config.mjs"),
    `export default { test: { environment: ${JSON.stringify(environment)} } };\n`,
  );
  const output = capture(process.execPath, [path.join(modules, "vitest/vitest.mjs"), "run"], {
    cwd: folder,
    env: { NODE_OPTIONS: "", EXPECTED_DOCUMENT: document, NO_COLOR: "1" },
  });
  expect(output).toMatch(/Tests +3 passed/);
});
