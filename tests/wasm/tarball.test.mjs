// The tarball itself: what is in it, how large it is, and what the linters of packages say.
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { root } from "../../tools/toolchain/folders.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { packed } from "./support/install_packed.mjs";

const installed = path.join(packed, "node_modules/apollonius-diagram");
const tarball = path.join(
  packed,
  readdirSync(packed).find((file) => file.endsWith(".tgz")),
);
const files = readdirSync(installed, { recursive: true }).filter((file) =>
  statSync(path.join(installed, file)).isFile(),
);

function brotli(file) {
  const bytes = readFileSync(path.join(installed, file));
  const params = {
    [constants.BROTLI_PARAM_QUALITY]: 11,
    [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
  };
  return brotliCompressSync(bytes, { params }).length;
}

const isOfEntry = /^dist\/(esm|cjs)\/(\w+\.js|(\w+\/)?\w+\.d\.ts)$/;

test("holds what users need and no more", () => {
  const entries = ["index", "sphere", "treemap", "wasm"].flatMap((name) =>
    ["esm", "cjs"].flatMap((format) => [
      `dist/${format}/${name}.js`,
      `dist/${format}/${name}.d.ts`,
    ]),
  );
  expect(files).toEqual(
    expect.arrayContaining([
      ...entries,
      "dist/apollonius.wasm",
      "dist/cjs/package.json",
      "package.json",
      "LICENSE",
      "README.md",
    ]),
  );
  const others = files.filter((file) => !isOfEntry.test(file));
  expect(others.sort()).toEqual([
    "LICENSE",
    "README.md",
    "dist/apollonius.wasm",
    "dist/cjs/package.json",
    "dist/sphere.wasm",
    "docs/SNAPSHOTS.md",
    "package.json",
  ]);
});

test("holds the documents that comments of its types cite", () => {
  const cited = files
    .filter((file) => file.endsWith(".d.ts"))
    .flatMap((file) => readFileSync(path.join(installed, file), "utf8").match(/docs\/\w+\.md/g));
  expect([...new Set(cited)].filter((file) => file !== null && !files.includes(file))).toEqual([]);
  expect(cited).toContain("docs/SNAPSHOTS.md");
});

test("needs no other package and runs nothing when it is installed", () => {
  const { dependencies, peerDependencies, optionalDependencies, scripts } = JSON.parse(
    readFileSync(path.join(installed, "package.json"), "utf8"),
  );
  expect({ dependencies, peerDependencies, optionalDependencies }).toEqual({});
  expect(Object.keys(scripts).filter((name) => /install|prepare|postpack/.test(name))).toEqual([]);
});

// Every visitor of a page loads it. What this costs in speed, and where there is room:
// bench/README.md, "Size".
// 95 KB and 1 MB were the limits of what there was on 2026-11-22; what came after is listed.
const kLimit = 95_000;
const kLater = {
  "pick, search, filters": 2_000,
  fromAsync: 1_300,
  "iteration, equality, JSON, errors that guess": 1_600,
  "regions as windows": 13_300,
  fitAreas: 5_600,
  "levels, counts of predicates": 900,
  "snap rounding of regions' sides": 500,
  "pieces of edges stay near their region, cells begin at one edge": 200,
  "polygons that tile the window": 6_500,
  "fits beside the page, distances to the last place, views": 2_400,
  "drawing compiled for speed": 300,
  "one interface for windows": 500,
  "neighbours of a large cell in a tree, for regions": 1_900,
  "the sphere's registration, and the way to its part of the module": 5_700,
  "sides of regions swept, rings around holes in trees": 1_800,
  "cells cut at a distance": 3_400,
  "empty circles, projections, natural neighbours": 2_400,
  "filters of find and pick, pickMany": 800,
  "all cells' paths at once, the window as a thing, d3's arrays": 2_900,
  "areas of polygons summed, edges that come to one place swept": 1_200,
};
// of which documents 60 000, levels and counts of predicates 14 000, vertices of circles on a grid
// 4 000 (1 218 bytes of wasm in three files), snap rounding 4 500 (1 352), and polygons that tile
// the window, with what came beside them, 91 000 (17 000), drawing for speed 3 400 (1 111),
// one interface for windows 10 000 (3 058), transactions 3 000 (900), neighbours in a tree 12 000
// (4 613), the sphere 283 000 (48 000 of wasm in four files, 19 000 in three, its entry and types),
// sweep and trees for regions 10 600 (3 535), the treemap 64 000 (its entry 23 000 and types 9 000,
// twice), cells cut at a distance 54 000 (8 000), filters of find and pick 15 000 (800), empty
// circles, projections and natural neighbours 36 000, paths of all cells, window and d3's arrays
// 30 000 (5 400), the sphere: hidden sites in snapshots, ties of
// walks, areas of cut cells 11 000 (2 000)
const kLaterUnpacked = 881_000;
const kTreemap = 9_000; // its entry, beside the default one
const later = Object.values(kLater).reduce((sum, bytes) => sum + bytes, 0);
test("sizes: the default entry and the whole package are within their limits", () => {
  const unpacked = files.reduce((sum, file) => sum + statSync(path.join(installed, file)).size, 0);
  const sizes = {
    esm: ["index", "embedded", "errors"].reduce(
      (sum, name) => sum + brotli(`dist/esm/${name}.js`),
      0,
    ),
    script: brotli("dist/cjs/index.js"),
    wasm: brotli("dist/apollonius.wasm"),
    code: brotli("dist/esm/wasm.js"),
  };
  process.stdout.write(
    `bytes with brotli: ${JSON.stringify(sizes)}; unpacked ${unpacked}, ` +
      `packed ${statSync(tarball).size}\n`,
  );
  expect(sizes.esm).toBeLessThanOrEqual(kLimit + later);
  expect(sizes.script).toBeLessThanOrEqual(kLimit + later); // the same with its wrapper
  expect(brotli("dist/esm/treemap.js")).toBeLessThanOrEqual(kTreemap);
  expect(sizes.wasm + sizes.code).toBeLessThan(sizes.esm);
  expect(unpacked).toBeLessThanOrEqual(1_000_000 + kLaterUnpacked);
});

test("docs/LOADING.md says how large the entries are", () => {
  const loading = readFileSync(path.join(root, "docs/LOADING.md"), "utf8");
  const [entry, code, wasm] = [
    /compiled synchronously at the first use.*\| (\d+) KB \|/,
    /streamed.*\| (\d+) \+ \d+ KB/,
    /streamed.*\+ (\d+) KB/,
  ].map((pattern) => 1000 * Number(pattern.exec(loading)[1]));
  for (const [said, file] of [
    [entry, "dist/esm/embedded.js"],
    [code, "dist/esm/wasm.js"],
    [wasm, "dist/apollonius.wasm"],
  ]) {
    expect(Math.abs(said - brotli(file))).toBeLessThan(2000);
  }
});

test("is ready to be published: npm corrects nothing, all addresses are of one repository", () => {
  const { repository, homepage, bugs } = JSON.parse(
    readFileSync(path.join(installed, "package.json"), "utf8"),
  );
  const [, address] = /^git\+(https:\/\/[^ ]+\/apollonius-diagram)\.git$/.exec(repository.url);
  expect([repository.type, homepage, bugs.url]).toEqual([
    "git",
    `${address}#readme`,
    `${address}/issues`,
  ]);
  const { status, stderr } = spawnSync("npm", ["publish", tarball, "--dry-run", "--offline"], {
    cwd: packed,
    encoding: "utf8",
  });
  expect(stderr).not.toMatch(/auto-corrected/);
  expect(status).toBe(0);
});

test("publint finds nothing", () => {
  capture(process.execPath, [
    path.join(root, "node_modules/publint/src/cli.js"),
    "run",
    tarball,
    "--strict",
  ]);
});

test("the types are not wrong, however they are resolved", () => {
  // In a Node of its own: it brings a TypeScript that Jest need not load.
  const output = capture(
    process.execPath,
    [
      "--input-type=module",
      "--eval",
      `
    import { readFileSync } from "node:fs";
    import { checkPackage, createPackageFromTarballData } from "@arethetypeswrong/core";
    const { types, problems: all } = await checkPackage(
      createPackageFromTarballData(readFileSync(${JSON.stringify(tarball)})),
      { excludeEntrypoints: ["./apollonius.wasm"] },
    );
    const problems = all.filter(({ resolutionKind }) => resolutionKind !== "node10");
    console.log(JSON.stringify({ types: types.kind, problems }));`,
    ],
    { cwd: root },
  );
  expect(JSON.parse(output)).toEqual({ types: "included", problems: [] });
});
