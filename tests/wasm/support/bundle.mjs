// Bundles a page that uses the packed package with one bundler, as its users would:
//
//   node bundle.mjs vite|webpack|rollup|esbuild
//
// into build/packed/bundles/NAME/: main.js (default entry), core.js (that of queries), sphere.js,
// treemap.js, error.js (which needs only ApolloniusError) and, except for rollup, streamed.js (the
// entry with a .wasm of its own). Prints the warnings as a JSON array.
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { packed } from "./install_packed.mjs";

const diagnostics = 'import { validate } from "apollonius-diagram/diagnostics";\n';
const use =
  `${diagnostics}const d = new Diagram([0, 0, 1, 9, 0, 2]);\n` +
  "globalThis.report(`${d.find(8, 0)} ${d.size} ${validate(d)}`);\n";
const main = `import { Diagram } from "apollonius-diagram";\n${use}`;
const core = `import { Diagram } from "apollonius-diagram/core";\n${use}`;
const sphere =
  'import { SphericalDiagram } from "apollonius-diagram/sphere";\n' +
  `${diagnostics}const d = new SphericalDiagram([0, 0, 1, 90, 0, 2]);\n` +
  "globalThis.report(`${d.find(80, 0)} ${d.size} ${validate(d)}`);\n";
const treemap =
  'import { treemap } from "apollonius-diagram/treemap";\n' +
  "globalThis.report(typeof treemap().shape([0, 0, 2, 1]));\n";
const error =
  'import { ApolloniusError } from "apollonius-diagram";\n' +
  'globalThis.report(new ApolloniusError("broken", "why").message);\n';
const streamed = (address) =>
  `import { Diagram, load } from "apollonius-diagram/wasm";\n${address}\n` +
  `await load({ core: wasm });\n${use}`;

const [name] = process.argv.slice(2);
const source = path.join(packed, "bundles", `${name}-source`);
const out = path.join(packed, "bundles", name);
for (const folder of [source, out]) rmSync(folder, { recursive: true, force: true });
mkdirSync(source, { recursive: true });

function write(file, text) {
  writeFileSync(path.join(source, file), text);
  return path.join(source, file);
}
const entries = (address) => ({
  main: write("main.js", main),
  core: write("core.js", core),
  sphere: write("sphere.js", sphere),
  treemap: write("treemap.js", treemap),
  error: write("error.js", error),
  ...(address && { streamed: write("streamed.js", streamed(address)) }),
});

const bundlers = {
  async vite() {
    const { build } = await import("vite");
    const warnings = [];
    const silent = {
      hasWarned: false,
      info() {},
      warn: (text) => warnings.push(text),
      warnOnce: (text) => warnings.push(text),
      error: (text) => warnings.push(text),
      clearScreen() {},
      hasErrorLogged: () => false,
    };
    await build({
      root: source,
      base: "./",
      configFile: false,
      customLogger: silent,
      build: {
        outDir: out,
        emptyOutDir: false,
        target: "es2022",
        modulePreload: false,
        assetsDir: "",
        rollupOptions: {
          input: entries('import wasm from "apollonius-diagram/core.wasm?url";'),
          output: { entryFileNames: "[name].js" },
        },
      },
    });
    return warnings;
  },

  async webpack() {
    const { default: webpack } = await import("webpack");
    const stats = await new Promise((resolve, reject) =>
      webpack(
        {
          mode: "production",
          context: source,
          entry: entries('const wasm = new URL("apollonius-diagram/core.wasm", import.meta.url);'),
          output: { path: out, filename: "[name].js", publicPath: "auto" },
          target: ["web", "es2022"],
          performance: false,
          optimization: { minimize: false }, // that takes 9 s; dist/ is minified already
        },
        (error, result) => (error ? reject(error) : resolve(result)),
      ),
    );
    const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true });
    return [...errors, ...warnings].map(({ message }) => message);
  },

  async rollup() {
    const { rollup } = await import("rollup");
    const warnings = [];
    const installed = createRequire(path.join(packed, "package.json"));
    const bundle = await rollup({
      input: entries(),
      onwarn: (warning) => warnings.push(warning.message),
      // All that @rollup/plugin-node-resolve would do here.
      plugins: [
        {
          name: "resolve",
          resolveId: (id) =>
            id.startsWith("apollonius-diagram")
              ? installed.resolve(id).replace("cjs", "esm")
              : null,
        },
      ],
    });
    await bundle.write({ dir: out, format: "es" });
    return warnings;
  },

  async esbuild() {
    const { build } = await import("esbuild");
    const { warnings } = await build({
      entryPoints: entries(
        'import address from "apollonius-diagram/core.wasm";\n' +
          "const wasm = new URL(address, import.meta.url);",
      ),
      bundle: true,
      minify: true,
      format: "esm",
      outdir: out,
      loader: { ".wasm": "file" },
      logLevel: "silent",
      target: "es2022",
    });
    return warnings.map(({ text }) => text);
  },
};

console.log(JSON.stringify(await bundlers[name]()));
