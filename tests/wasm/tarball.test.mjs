// The tarball itself: its files, its size, and the findings of linters of packages.
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";
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

const isOfEntry = /^dist\/(esm|cjs)\/(\w+\.js|\w+\/part\.js|(\w+\/)?\w+\.d\.ts)$/;

test("holds what users need and no more", () => {
  const entries = ["index", "core", "shapes", "sphere", "treemap", "diagnostics", "wasm"].flatMap(
    (name) =>
      ["esm", "cjs"].flatMap((format) => [
        `dist/${format}/${name}.js`,
        `dist/${format}/${name}.d.ts`,
      ]),
  );
  expect(files).toEqual(
    expect.arrayContaining([
      ...entries,
      "dist/core.wasm",
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
    "dist/apollonius.js",
    "dist/cjs/package.json",
    "dist/core.wasm",
    "dist/shapes.wasm",
    "dist/sphere.wasm",
    "docs/SNAPSHOTS.md",
    "docs/THIRD_PARTY.md",
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

// `npm run check -- strangers` compiles users with such compilers.
test("has types that TypeScript before 5.7 knows, where those of arrays are not generic", () => {
  const generic = files
    .filter((file) => file.endsWith(".d.ts"))
    .flatMap((file) => {
      const text = readFileSync(path.join(installed, file), "utf8");
      return [...text.matchAll(/\b(?:BigInt|BigUint|Float|Int|Uint)\d+\w*Array</g)].map(
        ([found]) => [file, found],
      );
    });
  expect(generic).toEqual([]);
});

test("needs no other package and runs nothing when it is installed", () => {
  const { dependencies, peerDependencies, optionalDependencies, scripts } = JSON.parse(
    readFileSync(path.join(installed, "package.json"), "utf8"),
  );
  expect({ dependencies, peerDependencies, optionalDependencies }).toEqual({});
  expect(Object.keys(scripts).filter((name) => /install|prepare|postpack/.test(name))).toEqual([]);
});

// A page's download is in sizes.test.mjs. The whole package is what somebody downloads who installs
// it: the wasm in four forms (ES module, CommonJS, script tag, files), and documents.
const kUnpacked = 3_098_500;
test("the whole package is within its limit", () => {
  const unpacked = files.reduce((sum, file) => sum + statSync(path.join(installed, file)).size, 0);
  process.stdout.write(`bytes unpacked ${unpacked}, packed ${statSync(tarball).size}\n`);
  expect(unpacked).toBeLessThanOrEqual(kUnpacked);
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
      { excludeEntrypoints: ["./core.wasm", "./shapes.wasm", "./sphere.wasm"] },
    );
    const problems = all.filter(({ resolutionKind }) => resolutionKind !== "node10");
    console.log(JSON.stringify({ types: types.kind, problems }));`,
    ],
    { cwd: root },
  );
  expect(JSON.parse(output)).toEqual({ types: "included", problems: [] });
});
