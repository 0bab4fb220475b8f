// npm run sizes: the download of a page for each use of the package and of its peers: a bundle by
// esbuild, minified, with brotli. It needs dist/ (npm run build). With --write it puts the sizes
// into README.md (figures.mjs). tests/wasm/sizes.test.mjs holds the package to its budgets.
import path from "node:path";
import { pathToFileURL } from "node:url";
import { brotliCompressSync, constants } from "node:zlib";
import { recordFigures, updateQuotations } from "./figures.mjs";
import { root } from "./toolchain/folders.mjs";

/** Uses of the package: the program, and how many bytes its bundle may have at most. */
export const uses = {
  core: {
    code:
      'import { Diagram } from "apollonius-diagram/core"; ' +
      "globalThis.answer = new Diagram([0, 0, 1]).find(0, 0);",
    budget: 102_850,
  },
  default: {
    code:
      'import { Diagram } from "apollonius-diagram"; ' +
      "globalThis.answer = new Diagram([0, 0, 1]).voronoi().render();",
    budget: 189_900,
  },
  sphere: {
    code:
      'import { SphericalDiagram } from "apollonius-diagram/sphere"; ' +
      "globalThis.answer = new SphericalDiagram([0, 0, 1]).find(0, 0);",
    budget: 146_150,
  },
  treemap: {
    code:
      'import { treemap } from "apollonius-diagram/treemap"; ' +
      "globalThis.answer = treemap()(globalThis.root);",
    budget: 197_850,
  },
};

/** Libraries that people know, without weights or without exactness: what each adds to a page. */
const peers = {
  "d3-delaunay": 'import { Delaunay } from "d3-delaunay"; globalThis.answer = Delaunay.from([]);',
  flatbush: 'import Flatbush from "flatbush"; globalThis.answer = new Flatbush(1);',
  "d3-voronoi-treemap":
    'import { voronoiTreemap } from "d3-voronoi-treemap"; globalThis.answer = voronoiTreemap();',
  "d3-geo-voronoi":
    'import { geoVoronoi } from "d3-geo-voronoi"; globalThis.answer = geoVoronoi([]);',
};

const entry = (name) => path.join(root, `dist/esm/${name}.js`);
const alias = {
  "apollonius-diagram": entry("index"),
  ...Object.fromEntries(
    ["core", "shapes", "sphere", "treemap", "diagnostics", "wasm"].map((name) => [
      `apollonius-diagram/${name}`,
      entry(name),
    ]),
  ),
};

function brotliOf(bytes) {
  const params = {
    [constants.BROTLI_PARAM_QUALITY]: 11,
    [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
  };
  return brotliCompressSync(bytes, { params }).length;
}

/** The bundle of a program. */
export async function bundleOf(code) {
  const { build } = await import("esbuild"); // not before `npm ci` may have installed it
  const { outputFiles } = await build({
    stdin: { contents: code, resolveDir: root, loader: "js" },
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    charset: "utf8", // or the wasm's text would be full of escapes
    write: false,
    alias,
    logLevel: "warning",
  });
  return outputFiles[0].contents;
}

/** The bytes of each use and each peer, with brotli. */
export async function measureSizes() {
  const sizes = {};
  for (const [name, { code }] of Object.entries(uses)) sizes[name] = brotliOf(await bundleOf(code));
  for (const [name, code] of Object.entries(peers)) sizes[name] = brotliOf(await bundleOf(code));
  return sizes;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const sizes = await measureSizes();
  for (const [name, bytes] of Object.entries(sizes)) {
    const limit = uses[name] ? `   of ${uses[name].budget}` : "";
    console.log(`${name.padEnd(20)} ${String(bytes).padStart(7)}${limit}`);
  }
  if (process.argv.includes("--write")) {
    const inKilobytes = Object.entries(sizes).map(([name, bytes]) => [name, bytes / 1000]);
    recordFigures("sizes", Object.fromEntries(inKilobytes));
    updateQuotations({ write: true });
  }
}
