// npm run build: the package's dist/ from src/ and wasm/.
//
//   dist/esm/{index,core,shapes,sphere,treemap,diagnostics,wasm}.js, *.d.ts    the entries, ES
//                                      modules. Those of core, shapes and sphere carry that part
//                                      of the wasm as text.
//   dist/esm/{embedded,errors}.js      index.js only re-exports these, so that a bundle that needs
//                                      only errors gets no more
//   dist/esm/{core,shapes,sphere,treemap}/part.js    the code of a folder of wasm/package, which
//                                      the entries share
//   dist/esm/*edge.js                  entries for runtimes that compile nothing: they import the
//                                      compiled parts
//   dist/cjs/                          CommonJS, the same
//   dist/apollonius.js                 for a script tag: the default entry as a global
//   dist/{core,shapes,sphere}.wasm     the parts (toolchain/split_wasm.mjs)
//
//   npm run build -- --debug           the same in build/debug/dist, with the names of the C++
//                                      functions and a source map beside the wasm
import { createHash } from "node:crypto";
import {
  chmodSync,
  copyFileSync,
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
import { parts, splitWasm } from "./toolchain/split_wasm.mjs";
import { ensureBuildTools, main } from "./toolchain/setup.mjs";

const sources = path.join(root, "wasm/package");
const examples = path.join(root, "docs/examples");
const types = path.join(root, "build/types/wasm/package");
const { name, version } = JSON.parse(readFileSync(path.join(root, "package.json"), "utf8"));
const own = { name, version };
const entries = ["index", "core", "shapes", "sphere", "treemap", "diagnostics", "wasm"];
const inner = ["embedded", "errors"];
const edges = ["edge", "core_edge", "shapes_edge", "sphere_edge", "treemap_edge"];
/** Folders of the sources whose code is a file of its own. */
const rooms = ["core", "shapes", "sphere", "treemap"];
/** Files of these that are part of the entries: lists of names, and what these do when imported. */
const ofEntries = /\/(api|methods)\.ts$/;

/** Control characters that bundlers write as escapes. */
const controls = [7, 8, 11, 12, 27];
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
  const unfit = [...Object.keys(escapes).map(Number), ...controls];
  const low = codes
    .slice(0, 128)
    .filter((code) => !unfit.includes(code))
    .sort((a, b) => counts[a] - counts[b]);
  const high = codes.slice(128).sort((a, b) => counts[b] - counts[a]);
  const swaps = unfit.map((code) => [code, low.shift()]);
  // Not all that would make the file shorter: the order of the others means something, and helps
  // compression. The limit is the best of some from 1/280 to 1/120, for pages and the whole package.
  for (let k = 0; counts[high[k]] > counts[low[k]] + bytes.length / 180; ++k)
    swaps.push([low[k], high[k]]);
  for (const [a, b] of swaps) [codes[a], codes[b]] = [b, a];
  const texts = codes.map((code) => escapes[code] ?? String.fromCharCode(code));
  const characters = Array.from(bytes, (byte) => texts[byte]).join("");
  // A page may have the file between its script tags: none of those begins or ends in here.
  return { literal: `"${characters.replaceAll(/<(?=[!/])/g, "<\\")}"`, swaps: swaps.flat() };
}

/** A section of WebAssembly that says something and does nothing. */
function sectionOf(name, content) {
  const text = Buffer.from(`${String.fromCharCode(name.length)}${name}${content}`);
  return Buffer.concat([Buffer.of(0, text.length), text]); // both less than 128
}

/** Stands for the text of a part of the wasm until all else is minified. */
const placeholderOf = (part) => `__APOLLONIUS_${part}__`;

/**
 * Lets a bundle import files of `built` (which the sources call build/wasm, in a debug build, too).
 * esbuild would print its own loaders' strings full of escapes.
 */
function wasmAsText(built, texts) {
  return {
    name: "wasm-as-text",
    setup(build) {
      build.onResolve({ filter: /\/build\/wasm\/[\w.]+$/ }, ({ path: file }) => ({
        path: path.join(built, path.basename(file)),
      }));
      build.onLoad({ filter: /\.wasm$/ }, ({ path: file }) => {
        const part = path.basename(file, ".wasm");
        const { swaps } = texts[part];
        return {
          contents: `export const text = ${placeholderOf(part)}, swaps = [${swaps}];`,
          loader: "js",
        };
      });
    },
  };
}

const classes = [
  "ApolloniusError",
  "Diagram",
  "SphericalDiagram",
  "SphericalVoronoi",
  "Voronoi",
  "VoronoiWindow",
];
const ownNames = new RegExp(`\\b_(${classes.join("|")})\\b`, "g");

/**
 * Minifies a text, except the names of the classes, which users see in debuggers and errors.
 * Terser's result is 9 % smaller than esbuild's, with brotli.
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

const isOutput = (name) => [...entries, ...inner, ...edges].includes(name);

/** The folder whose file holds the code of a source; "" if an entry holds it. */
function roomOf(file) {
  const [folder, ...rest] = path.relative(sources, file).split(path.sep);
  return rest.length > 0 && rooms.includes(folder) && !ofEntries.test(file) ? folder : "";
}

/** The names that sources outside of a room import, by room and file of it. */
function namesBetweenRooms() {
  const found = Object.fromEntries(rooms.map((room) => [room, {}]));
  const statement = /^(?:import|export) (\{[^}]*\}|\*(?: as \w+)?) from "(\.[^"]*)\.js";/gm;
  for (const name of readdirSync(sources, { recursive: true })) {
    if (!name.endsWith(".ts") || name.endsWith(".d.ts")) continue;
    const file = path.join(sources, name);
    const text = readFileSync(file, "utf8");
    for (const [, list, from] of text.matchAll(statement)) {
      const target = path.resolve(path.dirname(file), `${from}.ts`);
      const room = roomOf(target);
      if (room === "" || room === roomOf(file)) continue;
      if (list.startsWith("*"))
        throw new Error(`${name} imports all of ${from}.js: name what it needs`);
      const names = list
        .slice(1, -1)
        .split(",")
        .map((one) => one.trim().split(" as ")[0]);
      const values = names.filter((one) => one !== "" && !one.startsWith("type "));
      const ofFile = `./${path.relative(path.join(sources, room), target).replace(/ts$/, "js")}`;
      found[room][ofFile] = new Set([...(found[room][ofFile] ?? []), ...values]);
    }
  }
  return found;
}

/** Lets a bundle import other files of dist/ instead of containing them. */
function apart(own) {
  const folder = path.dirname(path.join(sources, own));
  const external = (name) => {
    const relative = path.relative(folder, path.join(sources, `${name}.js`));
    return { path: relative.startsWith(".") ? relative : `./${relative}`, external: true };
  };
  return {
    name: "apart",
    setup(build) {
      build.onResolve({ filter: /\.wasm\?module$/ }, ({ path: file }) => ({
        path: `../${path.basename(file)}`,
        external: true,
      }));
      build.onResolve({ filter: /^\..*\.js$/ }, ({ path: file, resolveDir, kind }) => {
        if (kind === "entry-point") return undefined;
        const target = path.resolve(resolveDir, file).replace(/js$/, "ts");
        const name = path.relative(sources, target).replace(/\.ts$/, "");
        if (isOutput(name)) return external(name);
        const room = roomOf(target);
        return room !== "" && own !== `${room}/part` ? external(`${room}/part`) : undefined;
      });
    },
  };
}

/** Makes the files of dist/ in `fresh`. */
async function bundle(fresh, built) {
  const { build, transform } = await import("esbuild"); // not before `npm ci` may have installed it
  const texts = Object.fromEntries(
    parts.map((part) => [part, asString(readFileSync(path.join(built, `parts/${part}.wasm`)))]),
  );
  const write = async (file, code, mark = "") => {
    let small = await minified(code);
    for (const part of parts) small = small.replace(placeholderOf(part), () => texts[part].literal);
    mkdirSync(path.dirname(path.join(fresh, file)), { recursive: true });
    writeFileSync(path.join(fresh, file), mark + small);
  };
  const bundled = async (entry, plugins = []) => {
    const { outputFiles } = await build({
      ...entry,
      format: "esm",
      bundle: true,
      target: "es2022",
      charset: "utf8",
      logLevel: "warning",
      legalComments: "none",
      write: false,
      define: { VERSION: JSON.stringify(own.version) },
      plugins: [wasmAsText(built, texts), ...plugins],
    });
    return outputFiles[0].text;
  };
  const between = namesBetweenRooms();
  const codeOf = (name) => {
    const room = rooms.find((candidate) => name === `${candidate}/part`);
    if (room === undefined)
      return bundled({ entryPoints: [path.join(sources, `${name}.ts`)] }, [apart(name)]);
    const lines = Object.entries(between[room]).map(
      ([file, names]) => `export { ${[...names].join(", ")} } from ${JSON.stringify(file)};`,
    );
    const stdin = { contents: lines.join("\n"), resolveDir: path.join(sources, room) };
    return bundled({ stdin }, [apart(name)]);
  };
  for (const name of [...entries, ...inner, ...rooms.map((room) => `${room}/part`)]) {
    const code = await codeOf(name);
    await write(`esm/${name}.js`, code);
    const settings = { format: "cjs", platform: "node", target: "es2022", charset: "utf8" };
    await write(`cjs/${name}.js`, (await transform(code, settings)).code);
  }
  for (const name of edges) await write(`esm/${name}.js`, await codeOf(name));
  // A script tag's file is read in the page's encoding, be it windows-1252, unless a byte order
  // mark says UTF-8.
  const script = await bundled({ entryPoints: [path.join(sources, "script.ts")] });
  await write("apollonius.js", `(() => {${script}})();`, "\uFEFF");
}

/** The declaration files that the entries reach; those of inner files stay out of the package. */
function publicDeclarations() {
  const reached = new Set();
  const visit = (name) => {
    if (reached.has(name)) return;
    reached.add(name);
    const text = readFileSync(path.join(types, name), "utf8");
    for (const [, module] of text.matchAll(/(?:from|^import) "(\.{1,2}\/.*?)\.js"/gm))
      visit(path.join(path.dirname(name), `${module}.d.ts`));
  };
  for (const entry of entries) visit(`${entry}.d.ts`);
  return [...reached];
}

/** A fingerprint of all that dist/ is made from. */
function fingerprint(built) {
  const inputs = [
    ...readdirSync(sources, { recursive: true })
      .filter((name) => /\.(ts|mjs|json)$/.test(name))
      .map((name) => path.join(sources, name)),
    fileURLToPath(import.meta.url),
    ...["examples", "hover_examples"].map((name) => path.join(root, `tools/${name}.mjs`)),
    ...readdirSync(examples).map((name) => path.join(examples, name)),
    path.join(root, "package.json"),
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
  await bundle(fresh, built);
  // Not before `npm ci` may have installed TypeScript.
  const { examplesAdded } = await import("./hover_examples.mjs");
  for (const name of publicDeclarations()) {
    const text = examplesAdded(name, readFileSync(path.join(types, name), "utf8"));
    for (const format of ["esm", "cjs"]) {
      const file = path.join(fresh, format, name);
      mkdirSync(path.dirname(file), { recursive: true });
      writeFileSync(file, text);
    }
  }
  // With the version: Observable Framework keeps bundles by it.
  const ofFolder = { ...own, type: "commonjs" };
  writeFileSync(path.join(fresh, "cjs/package.json"), `${JSON.stringify(ofFolder)}\n`);
  for (const part of parts) {
    const file = path.join(fresh, `${part}.wasm`);
    const bytes = readFileSync(path.join(built, `parts/${part}.wasm`));
    const marked = [bytes, sectionOf(own.name, `${part} ${own.version}`)];
    writeFileSync(file, Buffer.concat(marked));
    chmodSync(file, 0o644);
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
