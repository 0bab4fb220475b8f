// What README shows can be pasted: its code runs and gives what the comments beside it say, its
// links lead somewhere.
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import { runInNode } from "./support/node.mjs";

const readme = readFileSync(path.join(root, "README.md"), "utf8");
const blocks = [...readme.matchAll(/^```js\n([\s\S]*?)^```/gm)].map((match) => match[1]);
const importLine = 'import { Diagram } from "apollonius-diagram";\n';

/** The block with each `expression; // value` made to print the expression, and these values. */
function instrumented(block) {
  const values = [];
  const code = block.replace(
    /^(?!const|import)(\S.*?);\s+\/\/ (\[.*?\]|\d+|true|false)(?=$|:).*$/gm,
    (_, expression, value) => {
      values.push(value.replaceAll(" ", ""));
      return `show(${expression});`;
    },
  );
  const show =
    "const show = (value) =>\n" +
    "  console.log(JSON.stringify(ArrayBuffer.isView(value) ? [...value] : value));\n";
  return { code: show + code, values };
}

test("the first lines", () => {
  const block = blocks.find((text) => text.includes("const bubbles"));
  const { code, values } = instrumented(block);
  expect(values.length).toBe(5);
  expect(runInNode(code).split("\n")).toEqual(values);
});

test("the lines about cells", () => {
  const block = blocks.find((text) => text.includes("cellPolygons"));
  const context =
    "const calls = [];\n" +
    "const context = new Proxy({}, { get: (_, name) => () => calls.push(name) });\n";
  const output = runInNode(
    importLine +
      context +
      block.replace("ring.index, ring", "ring.index") +
      "console.log(calls.length > 1, path.slice(0, 1));",
  );
  expect(output.split("\n")).toEqual(["0", "1", "2", "true M"]);
});

test("the address of the wasm is written as the tests of bundlers write it", () => {
  const block = blocks.find((text) => text.includes("apollonius-diagram/wasm"));
  const bundlers = readFileSync(path.join(root, "tests/wasm/support/bundle.mjs"), "utf8");
  for (const way of [
    '"apollonius-diagram/apollonius.wasm?url"',
    'new URL("apollonius-diagram/apollonius.wasm", import.meta.url)',
    'from "apollonius-diagram/apollonius.wasm";',
  ]) {
    expect(block).toContain(way);
    expect(bundlers).toContain(way);
  }
  expect(blocks.length).toBe(3);
});

test("links and pictures are there", () => {
  const targets = [...readme.matchAll(/\]\(([^)]+)\)/g)]
    .map((match) => match[1])
    .filter((target) => !target.startsWith("http"));
  expect(targets.length).toBeGreaterThan(15);
  expect(targets.filter((target) => !existsSync(path.join(root, target.split("#")[0])))).toEqual(
    [],
  );
});
