// npm run build: the package's dist/ from src/ and wasm/.
//
//   dist/esm/{index,wasm}.js, *.d.ts    ES modules; index.js only names what is in embedded.js and
//                                       errors.js, so that who needs no more gets no more
//   dist/esm/edge.js                    the default entry for runtimes that compile nothing: it
//                                       imports the compiled module
//   dist/cjs/{index,wasm}.js, *.d.ts    CommonJS, the same; index.js is also the file for a script
//                                       tag, with the global `apollonius`
//   dist/{esm,cjs}/sphere.js, *.d.ts    the diagram of the sphere, in the module of the default
//                                       entry, which it imports by the package's name, with the
//                                       second part of the wasm (toolchain/split_wasm.mjs) as text
//   dist/esm/sphere_edge.js             the same, which imports that part
//   dist/apollonius.wasm                for the entry `apollonius-diagram/wasm`; the default entry
//                                       carries it as text
//   dist/sphere.wasm                    for sphere_edge.js
//
//   npm run build -- --debug            the same in build/debug/dist, with the names of the C++
//                                       functions and a source map beside the wasm
import { createHash } from "node:crypto";
import {
  chmodSync,
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { buildWasmModule } from "./toolchain/cmake.mjs";
import { root } from "./toolchain/folders.mjs";
import { withBuildLock } from "./toolchain/lock.mjs";
import { run } from "./toolchain/process.mjs";
import { splitWasm } from "./toolchain/split_wasm.mjs";
import { ensureBuildTools, main } from "./toolchain/setup.mjs";

const sources = path.join(root, "wasm/package");
const types = path.join(root, "build/types/wasm/package");
const entries = ["index", "wasm"];
// Bundled by themselves: an entry, and the same for runtimes that compile nothing.
const spheres = { esm: ["sphere", "sphere_edge"], cjs: ["sphere"] };
const treemaps = ["treemap"]; // of JavaScript only
const inner = { esm: ["edge", "embedded", "errors"], cjs: [] };

/** Characters that a string literal cannot have as they are; NUL, HTML would read as U+FFFD. */
const escapes = { 0: "\\x00", 10: "\\n", 13: "\\r", 34: '\\"', 92: "\\\\" };

/**
 * The wasm as a string literal of one character a byte. In UTF-8, half of the characters up to 255
 * are one byte each and half are two with few first ones, so that a server's compression sees the
 * wasm itself: 2 % more than the file alone, where base64 costs 38 %. As no character is beyond 255,
 * engines keep one byte for each. The most frequent bytes of the second half, and those that would
 * have to be escaped, change places with the rarest of the first.
 */
function asString(bytes) {
  const counts = new Uint32Array(256);
  for (const byte of bytes) ++counts[byte];
  const codes = [...counts.keys()];
  const unfit = Object.keys(escapes).map(Number);
  const low = codes
    .slice(0, 128)
    .filter((code) => !unfit.includes(code))
    .sort((a, b) => counts[a] - counts[b]);
  const high = codes.slice(128).sort((a, b) => counts[b] - counts[a]);
  const swaps = unfit.map((code) => [code, low.shift()]);
  // Not all that would make the file shorter: the order of the others means something, and helps
  // compression.
  for (let k = 0; counts[high[k]] > counts[low[k]] + bytes.length / 384; ++k)
    swaps.push([low[k], high[k]]);
  for (const [a, b] of swaps) [codes[a], codes[b]] = [b, a];
  const texts = codes.map((code) => escapes[code] ?? String.fromCharCode(code));
  const characters = Array.from(bytes, (byte) => texts[byte]).join("");
  // A page may have the file between its script tags: none of those begins or ends in here.
  return { literal: `"${characters.replaceAll(/<(?=[!/])/g, "<\\")}"`, swaps: swaps.flat() };
}

/**
 * Lets a bundle import what is in `built` (which the sources call build/wasm, in a debug build,
 * too), and one of the parts of the wasm as `asString` has it. esbuild would print its own loaders'
 * strings full of escapes.
 */
function wasmAsText(built, part) {
  const { literal, swaps } = asString(readFileSync(path.join(built, `parts/${part}.wasm`)));
  const placeholder = "__APOLLONIUS_WASM__";
  return {
    name: "wasm-as-text",
    setup(build) {
      build.onResolve({ filter: /\/build\/wasm\/[\w.]+$/ }, ({ path: file }) => ({
        path: path.join(built, path.basename(file)),
      }));
      build.onResolve({ filter: /\.wasm\?module$/ }, ({ path: file }) => ({
        path: `../${path.basename(file)}`,
        external: true,
      }));
      build.onLoad({ filter: /\.wasm$/ }, () => ({
        contents: `export const text = ${placeholder}, swaps = [${swaps}];`,
        loader: "js",
      }));
      build.onEnd(async ({ outputFiles }) => {
        for (const { path: file, text } of outputFiles) {
          const small = await minified(text);
          mkdirSync(path.dirname(file), { recursive: true });
          writeFileSync(file, byteOrderMark(file) + small.replace(placeholder, () => literal));
        }
      });
    },
  };
}

/**
 * A script tag's file is read in the page's encoding, be it windows-1252, unless a byte order mark
 * says UTF-8. Modules are always UTF-8; Node and bundlers skip the mark.
 */
function byteOrderMark(file) {
  return file.endsWith("cjs/index.js") ? "\uFEFF" : "";
}

const classes = ["ApolloniusError", "Diagram", "SphericalDiagram", "Voronoi"];
const ownNames = new RegExp(`\\b_(${classes.join("|")})\\b`, "g");

/**
 * Minified, but for the names of the classes, which users see in debuggers and errors. Terser's
 * result is 9 % smaller than esbuild's, with brotli.
 */
async function minified(text) {
  const { minify } = await import("terser"); // not before `npm ci` may have installed it
  // esbuild calls a class _Diagram where that is about itself.
  const { code } = await minify(text.replaceAll(ownNames, "$1"), {
    module: true,
    ecma: 2022,
    compress: { passes: 2 },
    mangle: { reserved: classes },
    format: { max_line_len: 1000 }, // Node prints the line of an uncaught error
  });
  // Where Node reads the names of a CommonJS module's exports; to others it is dead code.
  const [names = ""] = /^0 && \(module\.exports = \{[^}]*\}\)/m.exec(text) ?? [];
  return `${code}\n${names.replaceAll(/\s/g, "")}\n`;
}

// Where there is no CommonJS, what is exported becomes a global.
const scriptTag = {
  banner: { js: "(function(module){" },
  footer: {
    js:
      '})(typeof module=="object"&&module.exports?module:' +
      "{set exports(names){globalThis.apollonius=names}});",
  },
};

/** Lets bundles import errors.js, once, and not hold it; index.js and edge.js hold no other, too. */
const errorsApart = {
  name: "errors-apart",
  setup(build) {
    const file = "./errors.js"; // as the bundles see it, whatever folder asks
    build.onResolve({ filter: /^\.{1,2}\/errors\.js$/ }, ({ namespace }) =>
      namespace === "errors" ? { path: file, external: true } : { path: file, namespace: "errors" },
    );
    build.onResolve({ filter: /^\.\/(embedded|wasm)\.js$/ }, ({ path: file }) => ({
      path: file,
      external: true,
    }));
    build.onLoad({ filter: /./, namespace: "errors" }, () => ({
      contents: `export { ApolloniusError } from ${JSON.stringify(file)};`,
    }));
  },
};

/** Lets other entries take the running module and the classes from the default entry. */
const fromDefaultEntry = {
  name: "from-default-entry",
  setup(build) {
    build.onResolve({ filter: /\/(diagram|errors|module)\.js$/ }, ({ path: file }) => ({
      path: path.basename(file),
      namespace: "default-entry",
    }));
    build.onResolve({ filter: /^apollonius-diagram$/ }, ({ path: name }) => ({
      path: name,
      external: true,
    }));
    build.onLoad({ filter: /diagram|errors/, namespace: "default-entry" }, () => ({
      contents: `export { ApolloniusError, Diagram } from "apollonius-diagram";`,
    }));
    build.onLoad({ filter: /module/, namespace: "default-entry" }, () => ({
      contents:
        `import { Diagram } from "apollonius-diagram";` +
        `export const { runningModule, setSphereSource } = ` +
        `Diagram[Symbol.for("apollonius-diagram.module")];`,
    }));
  },
};

async function bundle(format, outdir, built) {
  const { build } = await import("esbuild"); // not before `npm ci` may have installed it
  const filesOf = (names) => names.map((name) => path.join(sources, `${name}.ts`));
  const common = {
    outdir,
    format,
    bundle: true,
    target: "es2022",
    charset: "utf8",
    logLevel: "warning",
    legalComments: "none",
    write: false,
    ...(format === "cjs" && { platform: "node" }),
  };
  await build({
    ...common,
    entryPoints: filesOf([...entries, ...inner[format]]),
    ...(format === "cjs"
      ? { ...scriptTag, plugins: [wasmAsText(built, "apollonius")] }
      : { plugins: [wasmAsText(built, "apollonius"), errorsApart] }),
  });
  await build({
    ...common,
    entryPoints: filesOf(spheres[format]),
    plugins: [wasmAsText(built, "sphere"), fromDefaultEntry],
  });
  await build({
    ...common,
    entryPoints: filesOf(treemaps),
    plugins: [wasmAsText(built, "apollonius"), fromDefaultEntry],
  });
}

/** The declaration files that the entries reach; those of inner files stay out of the package. */
function publicDeclarations() {
  const reached = new Set();
  const visit = (name) => {
    if (reached.has(name)) return;
    reached.add(name);
    const text = readFileSync(path.join(types, name), "utf8");
    for (const [, module] of text.matchAll(/from "(\.{1,2}\/.*?)\.js"/g))
      visit(path.join(path.dirname(name), `${module}.d.ts`));
  };
  for (const entry of [...entries, "sphere", ...treemaps]) visit(`${entry}.d.ts`);
  return [...reached];
}

/** A fingerprint of all that dist/ is made from. */
function fingerprint(built) {
  const inputs = [
    ...readdirSync(sources, { recursive: true })
      .filter((name) => /\.(ts|mjs|json)$/.test(name))
      .map((name) => path.join(sources, name)),
    fileURLToPath(import.meta.url),
    ...["wasm", "mjs", "d.mts"].map((kind) => path.join(built, `apollonius.${kind}`)),
    path.join(root, "tools/toolchain/split_wasm.mjs"),
    path.join(root, "package-lock.json"),
  ];
  const hash = createHash("sha256");
  for (const input of inputs) hash.update(input).update(readFileSync(input));
  return hash.digest("hex");
}

/**
 * Makes dist/ beside itself and then puts it in place, so that a server or a test never sees half
 * of it.
 */
async function makeDist(emscripten, built, dist, options) {
  splitWasm(emscripten, built, options);
  if (options?.debug) {
    // The sources take the module's types from build/wasm; those of both builds are the same.
    const release = path.join(root, "build/wasm");
    mkdirSync(release, { recursive: true });
    copyFileSync(path.join(built, "apollonius.d.mts"), path.join(release, "apollonius.d.mts"));
  }
  run(process.execPath, [path.join(root, "node_modules/typescript/bin/tsc"), "-p", sources]);
  const fresh = path.join(root, "build/dist");
  rmSync(fresh, { recursive: true, force: true });
  const declarations = publicDeclarations();
  for (const format of ["esm", "cjs"]) {
    const folder = path.join(fresh, format);
    mkdirSync(folder, { recursive: true });
    await bundle(format, folder, built);
    for (const name of declarations) cpSync(path.join(types, name), path.join(folder, name));
  }
  // With the version: Observable Framework keeps bundles by it.
  const { name, version } = JSON.parse(readFileSync(path.join(root, "package.json"), "utf8"));
  const own = { name, version, type: "commonjs" };
  writeFileSync(path.join(fresh, "cjs/package.json"), `${JSON.stringify(own)}\n`);
  for (const part of ["apollonius.wasm", "sphere.wasm"]) {
    copyFileSync(path.join(built, "parts", part), path.join(fresh, part));
    chmodSync(path.join(fresh, part), 0o644);
  }
  const map = path.join(built, "apollonius.wasm.map");
  if (existsSync(map)) copyFileSync(map, path.join(fresh, "apollonius.wasm.map"));
  rmSync(dist, { recursive: true, force: true });
  renameSync(fresh, dist);
}

export async function buildPackage() {
  const emscripten = ensureBuildTools();
  const dist = path.join(root, "dist");
  await withBuildLock(async () => {
    const built = buildWasmModule(emscripten);
    const stamp = path.join(root, "build/dist.fingerprint");
    const wanted = fingerprint(built);
    if (existsSync(dist) && existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
    rmSync(stamp, { force: true });
    await makeDist(emscripten, built, dist);
    writeFileSync(stamp, wanted);
  });
}

export async function buildDebug() {
  const debug = { debug: true };
  const emscripten = ensureBuildTools();
  await withBuildLock(() =>
    makeDist(
      emscripten,
      buildWasmModule(emscripten, debug),
      path.join(root, "build/debug/dist"),
      debug,
    ),
  );
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  await main(process.argv.includes("--debug") ? buildDebug : buildPackage);
