// The page as it is served: build/web/ from web/, files that any static server can hand out. Its
// modules and the package's default entry are bundled, so that a visitor waits for few requests.
//
//   build/web/main.js                    says what failed, if anything does, and loads the rest
//   build/web/start-….js, chunk-….js     the page and the package; what workers need of them too is
//                                        apart, and loaded once
//   build/web/sets/build_worker.js       the workers
//   build/web/motion/fit_worker.js
//   build/web/sets/random_sets.js        for tests and benchmarks
//   build/web/index.html, style.css, …   as they are in web/
//
// web/examples/ is not there: examples are served as they are to be read.
import { mkdirSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { root } from "./toolchain/folders.mjs";

const source = path.join(root, "web");
/** Where it goes. */
export const builtPage = path.join(root, "build/web");
const entries = ["main", "sets/build_worker", "motion/fit_worker", "sets/random_sets"];
const copied = ["index.html", "style.css", "icon.svg", "data/cities.json", "data/land.json"];
// The package's files are there already; the workers are asked for by their names.
const packageEntry = path.join(root, "dist/esm/index.js");

const settings = {
  entryPoints: entries.map((entry) => path.join(source, `${entry}.ts`)),
  outbase: source,
  outdir: builtPage,
  alias: { "apollonius-diagram": packageEntry },
  bundle: true,
  splitting: true,
  format: "esm",
  target: "es2022",
  charset: "utf8",
  minify: true,
  sourcemap: true,
  legalComments: "none",
  logLevel: "warning",
  write: false,
};

/** All files below a folder, as paths. */
function filesIn(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const file = path.join(folder, entry.name);
    return entry.isDirectory() ? filesIn(file) : [file];
  });
}

/** Whoever reads the file meanwhile sees the old one or the new one, whole. */
function replaceFile(file, contents) {
  mkdirSync(path.dirname(file), { recursive: true });
  const fresh = `${file}.${process.pid}.tmp`;
  writeFileSync(fresh, contents);
  renameSync(fresh, file);
}

const isSame = (file, contents) => {
  try {
    return readFileSync(file).equals(contents);
  } catch {
    return false;
  }
};

/** Writes what has changed, and removes what is no part of the page any more. */
const written = {
  name: "written",
  setup(build) {
    build.onEnd(({ errors, outputFiles }) => {
      if (errors.length > 0) return;
      const wanted = new Map(outputFiles.map((file) => [file.path, Buffer.from(file.contents)]));
      for (const name of copied)
        wanted.set(path.join(builtPage, name), readFileSync(path.join(source, name)));
      for (const [file, contents] of wanted)
        if (!isSame(file, contents)) replaceFile(file, contents);
      for (const file of filesIn(builtPage))
        if (!wanted.has(file) && !file.endsWith(".tmp")) rmSync(file, { force: true });
    });
  },
};

/** Builds it once. dist/ must be there (build.mjs). */
export async function buildPage() {
  const { build } = await import("esbuild"); // not before `npm ci` may have installed it
  await build({ ...settings, plugins: [written] });
}

/** Builds it, and again whenever its modules change; resolves to a function that ends that. */
export async function watchPage() {
  const { context } = await import("esbuild");
  const watched = await context({ ...settings, plugins: [written] });
  await watched.rebuild();
  await watched.watch();
  return () => watched.dispose();
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await buildPage();
