// Recipes of web/examples beside the libraries of tests/strangers, bundled by esbuild as their
// users would: for a page, or for Node, where a server renders.
import { cpSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import path from "node:path";
import { build } from "esbuild";
import { compile, compileModule } from "svelte/compiler";
import { compileScript, parse } from "vue/compiler-sfc";
import { root } from "../../../tools/toolchain/folders.mjs";
import { capture } from "../../../tools/toolchain/process.mjs";

const modules = path.join(root, "tests/strangers/node_modules");

/** A copy of web/examples that finds the libraries. */
export const recipes = path.join(root, "build/recipes");
const programs = path.join(recipes, "programs");

/** Makes the copy. */
export function copyRecipes() {
  rmSync(recipes, { recursive: true, force: true });
  const filter = (from) => path.basename(from) !== "cluster";
  cpSync(path.join(root, "web/examples"), recipes, { recursive: true, filter });
  symlinkSync(modules, path.join(recipes, "node_modules"));
  mkdirSync(programs);
}

/** Single-file components of Vue, as its plugins for bundlers compile them. */
const vueFiles = (isServer) => ({
  name: "vue",
  setup({ onLoad }) {
    onLoad({ filter: /\.vue$/ }, ({ path: filename }) => {
      const { descriptor } = parse(readFileSync(filename, "utf8"), { filename });
      const templateOptions = { ssr: isServer, ssrCssVars: [] };
      const options = { id: path.basename(filename), inlineTemplate: true, templateOptions };
      return { contents: compileScript(descriptor, options).content };
    });
  },
});

/** Components of Svelte, and modules with its runes. */
const svelteFiles = (isServer) => ({
  name: "svelte",
  setup({ onLoad }) {
    const options = { generate: isServer ? "server" : "client", dev: true };
    onLoad({ filter: /\.svelte(\.js)?$/ }, ({ path: filename }) => {
      const how = filename.endsWith(".js") ? compileModule : compile;
      const { js, warnings } = how(readFileSync(filename, "utf8"), { ...options, filename });
      return { contents: js.code, warnings: warnings.map(({ message }) => ({ text: message })) };
    });
  },
});

/** For CommonJS modules in an ES module of Node's. */
const kRequire =
  'import { createRequire } from "node:module"; const require = createRequire(import.meta.url);';

async function bundled(program, { name = "program.jsx", isServer = false } = {}) {
  // A file, so that the plugins see it; what it imports from "./" is an example.
  const file = path.join(programs, `${isServer ? "server" : "browser"}_${name}`);
  writeFileSync(file, program.replaceAll(/"\.\/(?=\w+\.\w+")/g, '"../'));
  const { outputFiles, warnings } = await build({
    entryPoints: [file],
    bundle: true,
    write: false,
    platform: isServer ? "node" : "browser",
    format: isServer ? "esm" : "iife",
    banner: { js: isServer ? kRequire : "" },
    jsx: "automatic",
    jsxDev: false,
    define: {
      "process.env.NODE_ENV": '"development"',
      __VUE_OPTIONS_API__: "false",
      __VUE_PROD_DEVTOOLS__: "false",
      __VUE_PROD_HYDRATION_MISMATCH_DETAILS__: "true",
    },
    loader: { ".css": "empty", ".png": "empty" },
    alias: {
      "apollonius-diagram": path.join(root, "dist/esm/index.js"),
      "apollonius-diagram/core": path.join(root, "dist/esm/core.js"),
      "apollonius-diagram/shapes": path.join(root, "dist/esm/shapes.js"),
      "apollonius-diagram/sphere": path.join(root, "dist/esm/sphere.js"),
    },
    plugins: [vueFiles(isServer), svelteFiles(isServer)],
    logLevel: "silent",
  });
  const ours = warnings.filter(({ pluginName }) => pluginName); // of the recipes' compilers
  if (ours.length > 0) throw new Error(ours.map(({ text }) => text).join("\n"));
  return outputFiles[0].text;
}

/** A script for a page, of a program that may import examples ("./…") and what they import. */
export const bundledForPage = (program, name) => bundled(program, { name });

/** Returns what such a program prints in Node. */
export async function printedByServer(program, name) {
  const file = path.join(programs, `${name}.mjs`);
  writeFileSync(file, await bundled(program, { name, isServer: true }));
  return capture(process.execPath, [file], { env: { NODE_OPTIONS: "" } });
}

/** A module of a library as one script, for a worker. */
export async function bundledModule(name) {
  const { outputFiles } = await build({
    entryPoints: [path.join(modules, name)],
    bundle: true,
    write: false,
    format: "iife",
    logLevel: "silent",
  });
  return outputFiles[0].text;
}
