// Calls go through two functions that list their parameters by hand (embind_parts.js, `guard` in
// module.ts), as rest parameters would need an array for each call. Further arguments are dropped.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";

const read = (file) => readFileSync(path.join(root, file), "utf8");

/** The most parameters of any method of the module's classes. */
function mostParameters() {
  const methods = read("build/wasm/apollonius.d.mts").matchAll(/^ {2}\w+\(([^\n]*)\): [^\n]+;$/gm);
  // The first parameter of a function of a diagram (wasm/bindings/shapes.cpp) is the object.
  const counts = [...methods].map(
    ([, list]) => [...list.replace(/^_0: Diagram\b/, "").matchAll(/\b_\d+\??: /g)].length,
  );
  return { most: Math.max(...counts), methods: counts.length };
}

test("no call has more parameters than are passed on", () => {
  const { most, methods } = mostParameters();
  expect(methods).toBeGreaterThan(50);
  expect(most).toBeGreaterThan(8);
  const [, list] = /plain\.call\(this, ([\w, ]+)\)/.exec(
    read("wasm/package/core/native/module.ts"),
  );
  expect(list.split(", ").length).toBeGreaterThanOrEqual(most);
  // Embind's own come first: the method's address and the object.
  const [, all] = /plain\(([\w, ]+)\) >>> 0/.exec(read("wasm/bindings/embind_parts.js"));
  expect(all.split(", ").length).toBeGreaterThanOrEqual(most + 2);
});
