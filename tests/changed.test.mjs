// `npm test -- changed` finds the tests of changed files, and its tables name only existing files.
import { existsSync, readdirSync } from "node:fs";
import path from "node:path";
import { root } from "../tools/toolchain/folders.mjs";
import { clusterPlan, kTestsOfPage, nativePlan, packagePlan, pagePlan } from "./changed.mjs";

const plan = (...files) => Object.fromEntries(nativePlan(files));

test("a test of C++ runs by its suites, a source by the tests that have its name", () => {
  expect(plan("tests/diagram/hint_grid_test.cpp")).toEqual({
    diagram_tests: "HintGrid.*:*/HintGrid.*",
  });
  expect(plan("src/diagram/hint_grid.cpp")).toEqual(plan("tests/diagram/hint_grid_test.cpp"));
  expect(plan("src/base/flat_array.h").base_tests).toMatch(/^FlatArray/);
});

test("a source without a test of its name runs its folder's program", () => {
  expect(plan("src/diagram/updates.cpp")).toEqual({ diagram_tests: "*" });
  expect(Object.keys(plan("src/api/diagram.cpp", "src/apollonius/voronoi.h"))).toEqual([
    "diagram_tests",
    "geometry_tests",
  ]);
  expect(Object.keys(plan("src/api/shapes/region.cpp"))).toEqual(["geometry_tests"]);
  expect(Object.keys(plan("src/api/sphere/spherical_builder.cpp"))).toEqual(["sphere_tests"]);
  expect(Object.keys(plan("tests/support/oracle.cpp"))).toContain("predicate_tests");
  expect(plan("src/predicate/gone.cpp", "README.md", "web/playground/app.ts")).toEqual({});
});

test("the page's tests are those of the folder", () => {
  expect(pagePlan(["web/playground/picture/view.ts"])).toEqual([
    "tests/web/picture.test.mjs",
    "tests/web/view.test.mjs",
    "tests/web/windows.test.mjs",
  ]);
  expect(pagePlan(["web/playground/app.ts"])).toContain("tests/web/page.test.mjs");
  expect(pagePlan(["tests/web/looks.test.mjs"])).toEqual(["tests/web/looks.test.mjs"]);
  expect(pagePlan(["tests/web/support/browser.mjs"])).toEqual(["tests/web/"]);
  expect(pagePlan(["web/examples/cluster/run.mjs", "src/api/diagram.cpp"])).toEqual([]);
});

test("each folder of the page has its tests, and they are there", () => {
  const folders = ["web", "web/playground"]
    .flatMap((folder) => readdirSync(path.join(root, folder), { withFileTypes: true }))
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => name)
    .filter((name) => name !== "playground");
  expect(Object.keys(kTestsOfPage).filter(Boolean).sort()).toEqual(folders.sort());
  for (const name of Object.values(kTestsOfPage).flat())
    expect([name, existsSync(path.join(root, `tests/web/${name}.test.mjs`))]).toEqual([name, true]);
});

test("the package and the cluster example", () => {
  expect(packagePlan(["wasm/package/core/diagram.ts"])[0]).toBe("--testPathIgnorePatterns");
  expect(packagePlan(["tests/wasm/queries.test.mjs"])).toEqual(["--onlyChanged"]);
  expect(packagePlan(["README.md"])).toEqual(["--testPathPatterns", "/wasm/readme\\.test"]);
  expect(packagePlan(["docs/examples/diagram.md", "README.md"])).toEqual([
    "--testPathPatterns",
    "/wasm/readme\\.test",
    "/wasm/(examples|reference)\\.test",
  ]);
  expect(packagePlan(["src/api/diagram.cpp"])).toBeNull();
  expect(clusterPlan(["tests/cluster/tile.test.mjs"])).toBe(true);
  expect(clusterPlan(["web/playground/app.ts"])).toBe(false);
});
