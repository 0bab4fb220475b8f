// The packed package through bundlers and minifiers that are too large for every `npm ci`; the
// others: tests/wasm/browsers.test.mjs.
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { describeInBrowsers } from "../wasm/support/browsers.mjs";
import { packed } from "../wasm/support/install_packed.mjs";
import { runScriptInNode } from "../wasm/support/node.mjs";
import { runPages } from "../wasm/support/pages.mjs";

const use = (diagnostics) =>
  `import { validate } from "${diagnostics}";\n` +
  "const d = new Diagram([0, 0, 1, 9, 0, 2]);\n" +
  "globalThis.report(`${d.find(8, 0)} ${d.size} ${validate(d)}`);\n";
const programs = {
  main: `import { Diagram } from "apollonius-diagram";\n${use("apollonius-diagram/diagnostics")}`,
  error:
    'import { ApolloniusError } from "apollonius-diagram";\n' +
    'globalThis.report(new ApolloniusError("broken", "why").message);\n',
};
const expected = { main: "1 2 null", error: "why" };
const folder = (name) => path.join(packed, "bundles", name);

function sourceFor(name) {
  const source = folder(`${name}-source`);
  for (const old of [source, folder(name)]) rmSync(old, { recursive: true, force: true });
  mkdirSync(source, { recursive: true });
  for (const [program, text] of Object.entries(programs))
    writeFileSync(path.join(source, `${program}.js`), text);
  return source;
}

const bundlers = {
  async rspack() {
    const { rspack } = await import("@rspack/core");
    const context = sourceFor("rspack");
    const stats = await new Promise((resolve, reject) =>
      rspack(
        {
          mode: "production",
          context,
          entry: { main: "./main.js", error: "./error.js" },
          output: { path: folder("rspack") },
          target: ["web", "es2022"],
          performance: false,
        },
        (error, result) => (error ? reject(error) : resolve(result)),
      ),
    );
    const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true });
    return [...errors, ...warnings].map(({ message }) => message);
  },

  parcel() {
    const source = sourceFor("parcel");
    // Parcel reads `exports` only if the project says so: the folder with the lock file.
    writeFileSync(path.join(source, "package-lock.json"), "{}");
    writeFileSync(
      path.join(source, "package.json"),
      JSON.stringify({
        browserslist: "last 2 Chrome versions",
        "@parcel/resolver-default": { packageExports: true },
      }),
    );
    capture(
      process.execPath,
      [
        path.join(root, "tests/strangers/node_modules/parcel/lib/bin.js"),
        "build",
        "main.js",
        "error.js",
        "--no-cache",
        "--no-source-maps",
        "--dist-dir",
        folder("parcel"),
      ],
      { cwd: source },
    );
    return [];
  },
};

describe.each(Object.keys(bundlers))("%s", (name) => {
  beforeAll(async () => expect(await bundlers[name]()).toEqual([]), 300_000);

  test.each(Object.keys(programs))("the bundle of %s runs", (program) => {
    const file = `./bundles/${name}/${program}.js`;
    expect(runScriptInNode(`globalThis.report = console.log; import("${file}")`)).toBe(
      expected[program],
    );
  });

  test("who imports only ApolloniusError gets only that", () => {
    const size = readdirSync(folder(name))
      .filter((file) => /^error.*\.js$/.test(file))
      .reduce((sum, file) => sum + statSync(path.join(folder(name), file)).size, 0);
    expect(size).toBeGreaterThan(100);
    expect(size).toBeLessThan(2000);
  });
});

const minifiers = {
  async swc(text) {
    const { minify } = await import("@swc/core");
    return (await minify(text, { module: true, compress: true, mangle: true })).code;
  },
  async terser(text) {
    const { minify } = await import("terser");
    return (await minify(text, { module: true })).code;
  },
};

test.each(
  Object.keys(minifiers),
)("%s minifies the package once more, and it runs", async (name) => {
  const dist = path.join(packed, "node_modules/apollonius-diagram/dist/esm");
  const out = folder(name);
  for (const file of readdirSync(dist, { recursive: true })) {
    if (!file.endsWith(".js") || file.endsWith("edge.js")) continue;
    const text = readFileSync(path.join(dist, file), "utf8");
    mkdirSync(path.dirname(path.join(out, file)), { recursive: true });
    writeFileSync(path.join(out, file), await minifiers[name](text));
  }
  writeFileSync(
    path.join(out, "main.js"),
    `import { Diagram } from "./index.js";\n${use("./diagnostics.js")}`,
  );
  expect(
    runScriptInNode(`globalThis.report = console.log; import("./bundles/${name}/main.js")`),
  ).toBe(expected.main);
});

describeInBrowsers("what other bundlers made", (browser) => {
  test("runs", async () => {
    expect(browser).toBeDefined();
    const names = [...Object.keys(bundlers), ...Object.keys(minifiers)];
    const page = (name) => ({
      html: `<script type="module" src="/bundles/${name}/main.js"></script>`,
    });
    const results = await runPages(
      browser,
      Object.fromEntries(names.map((name) => [name, page(name)])),
      {},
    );
    expect(results).toEqual(Object.fromEntries(names.map((name) => [name, expected.main])));
  });
});
