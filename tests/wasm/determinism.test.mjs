// The same bits in every engine: a history with all outputs of the package, as one hash, in Node,
// Chromium and Firefox. What differed would be arithmetic of the engine's JavaScript; the wasm's
// own is compared with native code by recorded hashes (tests/diagram/determinism_test.cpp).
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describeInBrowsers } from "./support/browsers.mjs";
import { runInNode } from "./support/node.mjs";
import { runPages } from "./support/pages.mjs";

const script = fileURLToPath(new URL("support/all_outputs.mjs", import.meta.url));
const dist = "/node_modules/apollonius-diagram/dist";

const [inNode, again] = runInNode(`
  import { hashOfAllOutputs } from ${JSON.stringify(`file://${script}`)};
  const code = await import("apollonius-diagram");
  for (let k = 0; k < 2; ++k) console.log(await hashOfAllOutputs(code));
`).split("\n");

test("Node comes to a hash of all outputs, the same each time", () => {
  expect(inNode).toMatch(/^\d{6,} bytes [0-9a-f]{64}$/);
  expect(again).toBe(inNode);
});

describeInBrowsers("the hash of all outputs", (browser) => {
  test("has the same bits as Node", async () => {
    expect(browser).not.toBeNull();
    const files = {
      "all_outputs.js": readFileSync(script, "utf8"),
      "hash.js": `import { hashOfAllOutputs } from "/all_outputs.js";
        import * as code from "${dist}/esm/index.js";
        report(await hashOfAllOutputs(code));`,
    };
    const { hash } = await runPages(
      browser,
      { hash: { html: '<script type="module" src="/hash.js"></script>' } },
      files,
    );
    expect(hash).toBe(inNode);
  });
});
