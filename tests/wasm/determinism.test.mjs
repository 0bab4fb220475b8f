// Equal bits in every engine: a history with all outputs of the package, as one hash, in Node,
// Chromium and Firefox. What differed would be arithmetic of the engine's JavaScript; the wasm's
// own is compared with native code by recorded hashes (tests/diagram/determinism_test.cpp).
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describeInBrowsers } from "./support/browsers.mjs";
import { runInNode } from "./support/node.mjs";
import { runPages } from "./support/pages.mjs";

const script = fileURLToPath(new URL("support/all_outputs.mjs", import.meta.url));
const dist = "/node_modules/apollonius-diagram/dist";

const setUp = `
  import { hashOfAllOutputs } from ${JSON.stringify(`file://${script}`)};
  const names = ["", "/sphere", "/treemap", "/diagnostics"];
  const entries = names.map((name) => import("apollonius-diagram" + name));
  const code = Object.assign({}, ...(await Promise.all(entries)));
`;
const [inNode, again] = runInNode(`${setUp}
  for (let k = 0; k < 2; ++k) console.log(await hashOfAllOutputs(code));
`).split("\n");

test("Node comes to a hash of all outputs, the same each time", () => {
  expect(inNode).toMatch(/^\d{6,} bytes [0-9a-f]{64}$/);
  expect(again).toBe(inNode);
});

test("functions of Math that every engine rounds in its own way change no bit", () => {
  const rounded = "acos acosh asin asinh atan atan2 atanh cbrt cos cosh exp expm1 hypot log log10 \
log1p log2 pow sin sinh tan tanh".split(" ");
  const offByAnUlp = `
    for (const name of ${JSON.stringify(rounded)}) {
      const exact = Math[name];
      Math[name] = (...numbers) => {
        const bits = new BigInt64Array(Float64Array.of(exact(...numbers)).buffer);
        ++bits[0];
        return new Float64Array(bits.buffer)[0];
      };
    }
  `;
  expect(runInNode(`${setUp} ${offByAnUlp} console.log(await hashOfAllOutputs(code));`)).toBe(
    inNode,
  );
});

test("every call of every class is among the outputs", () => {
  const missing = runInNode(`${setUp}
    const view = new code.Diagram([0, 0, 1]).voronoi([0, 0, 1, 1]);
    const { Diagram, SphericalDiagram } = code;
    const kept = [Diagram.prototype, Object.getPrototypeOf(view), SphericalDiagram.prototype]
      .flatMap((prototype) => [prototype, Object.getPrototypeOf(prototype)])
      .filter((prototype) => prototype !== Object.prototype);
    const missing = new Set();
    for (const prototype of kept) {
      for (const [name, member] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
        if (name === "constructor") continue;
        const call = prototype.constructor.name + "." + name;
        missing.add(call);
        for (const kind of ["value", "get"]) {
          const original = member[kind];
          if (typeof original !== "function") continue;
          member[kind] = function (...args) {
            missing.delete(call);
            return original.apply(this, args);
          };
        }
        Object.defineProperty(prototype, name, member);
      }
    }
    await hashOfAllOutputs(code);
    console.log([...missing].join(" "));
  `);
  expect(missing).toBe("");
});

describeInBrowsers("the hash of all outputs", (browser) => {
  test("has the same bits as Node", async () => {
    expect(browser).not.toBeNull();
    const files = {
      "all_outputs.js": readFileSync(script, "utf8"),
      "hash.js": `import { hashOfAllOutputs } from "/all_outputs.js";
        const entries = ["index", "sphere", "treemap", "diagnostics"];
        const modules = entries.map((name) => import("${dist}/esm/" + name + ".js"));
        const code = Object.assign({}, ...(await Promise.all(modules)));
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
