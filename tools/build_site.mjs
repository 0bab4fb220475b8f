// The site as it is served: build/web/ from web/, by Vite: files that any static server can hand
// out, from any folder. dist/ must be there (build.mjs).
//
//   build/web/index.html, why/, …     the pages: web/pages/*.md in the layout of site/page.mjs
//   build/web/playground/             web/playground, bundled
//   build/web/assets/                 scripts, styles, workers, the WebAssembly, with hashes
//   build/web/shared/random_sets.js   for tests and benchmarks
//   build/web/recipes/frame.html      where the programs of that page run
//   build/web/examples/, data/        as they are in web/: to be read and copied
//   build/web/pagefind/               the index of the search
//   build/web/lib/                    what the examples import: the package, modules of d3
//
//   node tools/build_site.mjs         builds it once
import { cpSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { preloads } from "./site/preloads.mjs";
import { root } from "./toolchain/folders.mjs";

const source = path.join(root, "web");
/** The folder into which the site is built. */
export const builtSite = path.join(root, "build/web");
const copied = ["examples", "data", "icon.svg"]; // in web/
const kRandomSets = "shared/random_sets";
/** Modules that every page needs come in one piece, and random circles with it: they are small. */
const kShared =
  /dist\/esm\/(wasm|errors|(core|shapes)\/part)\.js|web\/(shared\/(package|theme|canvas|dom|errors|input|pace)|figure\/(figure|pen))\.ts|preload-helper/;
const isShared = (module) => kShared.test(module) || module.includes(`${kRandomSets}.ts`);

/** The d3 modules that web/examples import, by the import map of its page. */
function librariesOfExamples() {
  const html = readFileSync(path.join(source, "examples/index.html"), "utf8");
  return [...html.matchAll(/"\.\.\/lib\/(d3-[\w-]+)\.mjs"/g)].map((match) => match[1]);
}

/** Copies the frame with its script inside: a sandbox may not load one from another origin. */
function copyFrame() {
  const read = (name) => readFileSync(path.join(source, "recipes", name), "utf8");
  const script = `<script>\n${read("frame.js")}</script>`;
  const html = read("frame.html").replace('<script src="frame.js"></script>', () => script);
  writeFileSync(path.join(builtSite, "recipes/frame.html"), html);
}

function copyTheRest() {
  copyFrame();
  for (const name of copied)
    cpSync(path.join(source, name), path.join(builtSite, name), { recursive: true });
  const library = path.join(builtSite, "lib/apollonius-diagram");
  const esm = path.join(root, "dist/esm");
  mkdirSync(library, { recursive: true });
  for (const name of readdirSync(esm, { recursive: true }))
    if (name.endsWith(".js")) cpSync(path.join(esm, name), path.join(library, name));
  for (const name of librariesOfExamples())
    cpSync(
      path.join(root, `node_modules/${name}/dist/${name}.mjs`),
      path.join(builtSite, `lib/${name}.mjs`),
    );
}

/** Vite's settings; `watch` builds again whenever a file changes. */
async function settings({ isWatching }) {
  const dist = path.join(root, "dist");
  // Not imported before `npm ci` may have installed its packages.
  const { pagesPlugin } = await import("./site/pages_plugin.mjs");
  const pages = await pagesPlugin();
  return {
    root: source,
    base: "./",
    configFile: false,
    publicDir: false,
    logLevel: "warn",
    resolve: {
      alias: [
        // The one entry with the names of those that bring WebAssembly, and without that.
        {
          find: /^apollonius-diagram(\/(sphere|treemap|wasm))?$/,
          replacement: path.join(dist, "esm/wasm.js"),
        },
        {
          find: "apollonius-diagram/diagnostics",
          replacement: path.join(dist, "esm/diagnostics.js"),
        },
        { find: /^apollonius-diagram\/(\w+\.wasm)(?=\?)/, replacement: path.join(dist, "$1") },
      ],
    },
    worker: { format: "es" },
    plugins: [pages, preloads, { name: "the-rest", closeBundle: copyTheRest }],
    build: {
      outDir: builtSite,
      emptyOutDir: true,
      target: "es2022",
      sourcemap: true,
      assetsInlineLimit: 0,
      modulePreload: { polyfill: false },
      watch: isWatching ? {} : null,
      rolldownOptions: {
        input: {
          ...pages.api.inputs,
          playground: path.join(source, "playground/index.html"),
          [kRandomSets]: path.join(source, `${kRandomSets}.ts`),
        },
        preserveEntrySignatures: "allow-extension",
        output: {
          entryFileNames: ({ name }) =>
            name === kRandomSets ? "[name].js" : "assets/[name]-[hash].js",
          codeSplitting: { groups: [{ name: "shared", test: isShared }] },
        },
      },
    },
  };
}

/** Builds it once. */
export async function buildSite() {
  const { build } = await import("vite"); // not before `npm ci` may have installed it
  await build(await settings({ isWatching: false }));
  await makeIndex();
}

/** The index of the search (web/figure/search.ts): of what stands in `main` of the pages. */
async function makeIndex() {
  const pagefind = await import("pagefind");
  const orThrow = ({ errors, ...made }) => {
    if (errors.length > 0) throw new Error(`Pagefind: ${errors.join("; ")}`);
    return made;
  };
  const { index } = orThrow(await pagefind.createIndex());
  orThrow(await index.addDirectory({ path: builtSite }));
  orThrow(await index.writeFiles({ outputPath: path.join(builtSite, "pagefind") }));
  await pagefind.close();
}

/** Builds it, and again whenever a file changes; resolves when it is built for the first time. */
export async function watchSite() {
  const { build } = await import("vite");
  const watcher = await build(await settings({ isWatching: true }));
  await new Promise((resolve, reject) =>
    watcher.on("event", ({ code, error }) => {
      if (code === "END") makeIndex().then(resolve, reject);
      if (code === "ERROR") reject(error);
    }),
  );
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await buildSite();
