// The packed package in Chromium and Firefox, under a strict content security policy: as it is, in
// workers, and as each bundler packs it.
import { readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { describeInBrowsers } from "./support/browsers.mjs";
import { packed } from "./support/install_packed.mjs";
import { runScriptInNode } from "./support/node.mjs";
import { runPages } from "./support/pages.mjs";

const expected = "1 2 null";
const dist = "/node_modules/apollonius-diagram/dist";
const useOfScript =
  "const d = new Diagram([0, 0, 1, 9, 0, 2]); report(`${d.find(8, 0)} ${d.size} null`);";
const use =
  `import { validate } from "${dist}/esm/diagnostics.js"; ` +
  useOfScript.replace("null", "${validate(d)}");
const bundlers = ["vite", "webpack", "rollup", "esbuild"];

const bundle = (name) =>
  JSON.parse(
    capture(process.execPath, [path.join(root, "tests/wasm/support/bundle.mjs"), name])
      .trim()
      .split("\n")
      .at(-1),
  );

test.each(bundlers)("%s bundles the package without a warning, and the bundle runs", (name) => {
  expect(bundle(name)).toEqual([]);
  expect(
    runScriptInNode(`globalThis.report = console.log; import("./bundles/${name}/main.js")`),
  ).toBe(expected);
});

// A page that only tells our errors from others should not load the whole package.
test.each(bundlers)("%s keeps of the package what is used", (name) => {
  const folder = path.join(packed, "bundles", name);
  const size = readdirSync(folder)
    .filter((file) => /^error.*\.js$/.test(file))
    .reduce((sum, file) => sum + statSync(path.join(folder, file)).size, 0);
  expect(size).toBeGreaterThan(100);
  expect(size).toBeLessThan(2000);
  expect(
    runScriptInNode(`globalThis.report = console.log; import("./bundles/${name}/error.js")`),
  ).toBe("why");
});

/** The files that a bundle of a program loads, and how long they are together. */
function loadedBy(folder, file, seen = new Set()) {
  if (seen.has(file)) return 0;
  seen.add(file);
  const text = readFileSync(path.join(folder, file), "utf8");
  const imported = [...text.matchAll(/(?:from|import)\s*["']\.\/([\w.-]+\.js)["']/g)];
  return imported.reduce((sum, [, other]) => sum + loadedBy(folder, other, seen), text.length);
}

test.each(bundlers)("%s bundles of each entry the parts that it needs", (name) => {
  const folder = path.join(packed, "bundles", name);
  const [core, main, sphere, treemap] = ["core", "main", "sphere", "treemap"].map((entry) =>
    loadedBy(folder, `${entry}.js`),
  );
  expect(core).toBeGreaterThan(200_000);
  expect(main - core).toBeGreaterThan(120_000); // shapes
  expect(sphere - core).toBeGreaterThan(40_000);
  expect(sphere).toBeLessThan(main);
  expect(treemap - main).toBeGreaterThan(5_000); // without the sphere
  expect(treemap - main).toBeLessThan(40_000);
  const ran = (entry) =>
    runScriptInNode(`globalThis.report = console.log; import("./bundles/${name}/${entry}.js")`);
  expect(ran("core")).toBe(expected);
  expect(ran("sphere")).toBe(expected);
  expect(ran("treemap")).toBe("function");
});

test("no file has characters that a page or a bundler would not take as they are", () => {
  const folder = path.join(packed, dist);
  for (const file of readdirSync(folder, { recursive: true })) {
    if (!file.endsWith(".js")) continue;
    const text = readFileSync(path.join(folder, file), "utf8");
    expect(text).not.toMatch(/[\0\r\u{D800}-\u{DFFF}\u{FFFE}-\u{10FFFF}]|<!--|<\/script/u);
  }
});

const files = {
  "module.js": `import { Diagram } from "${dist}/esm/index.js"; ${use}`,
  "core.js": `import { Diagram } from "${dist}/esm/core.js"; ${use}`,
  "global.js": `const { Diagram, SphericalDiagram, treemap } = apollonius;
    const globe = new SphericalDiagram([0, 0, 0, 90, 0, 0]);
    const tree = { data: {}, value: 1, children: [{ data: {}, value: 1 }] };
    if (globe.find(80, 0) !== 1 || Math.abs(treemap()(tree).area - 1) > 1e-6)
      throw new Error("not all entries are there");
    ${useOfScript}`,
  "wasm.js": `import { Diagram, load } from "${dist}/esm/wasm.js";
    await load({ core: "${dist}/core.wasm" }); ${use}`,
  "ahead.js": `import { Diagram, load } from "${dist}/esm/index.js"; await load(); ${use}`,
  "start_module_worker.js": `
    const worker = new Worker("/module_worker_inside.js", { type: "module" });
    worker.onmessage = ({ data }) => report(data);`,
  "module_worker_inside.js": `const report = (found) => postMessage(found);
    import { Diagram } from "${dist}/esm/index.js"; ${use}`,
  "start_classic_worker.js": `
    new Worker("/classic_worker_inside.js").onmessage = ({ data }) => report(data);`,
  "classic_worker_inside.js": `const report = (found) => postMessage(found);
    importScripts("${dist}/apollonius.js"); const { Diagram } = apollonius; ${useOfScript}`,
};
const scriptFile = readFileSync(path.join(packed, dist, "apollonius.js"), "utf8");
const module = (file) => ({ html: `<script type="module" src="${file}"></script>` });
const cases = {
  module: module("/module.js"),
  core: module("/core.js"),
  load: module("/ahead.js"),
  streaming: module("/wasm.js"),
  script: {
    html: `<script src="${dist}/apollonius.js"></script><script src="/global.js"></script>`,
  },
  "script-in-an-old-page": {
    charset: "windows-1252",
    html: `<script src="${dist}/apollonius.js"></script><script src="/global.js"></script>`,
  },
  "within-a-page": {
    hasInline: true,
    html: `<script>${scriptFile}</script><script>${files["global.js"]}</script>`,
  },
  "module-worker": module("/start_module_worker.js"),
  "classic-worker": { html: '<script src="/start_classic_worker.js"></script>' },
  ...Object.fromEntries(
    bundlers.map((name) => [`bundle-${name}`, module(`/bundles/${name}/main.js`)]),
  ),
  ...Object.fromEntries(
    ["vite", "webpack", "esbuild"].map((name) => [
      `streamed-${name}`,
      module(`/bundles/${name}/streamed.js`),
    ]),
  ),
};

describeInBrowsers("the package", (browser) => {
  test("runs the package in every way", async () => {
    expect(browser).not.toBeNull();
    const results = await runPages(browser, cases, files);
    expect(results).toEqual(Object.fromEntries(Object.keys(cases).map((key) => [key, expected])));
  });
});
