// Numbers that stand in C++ and in TypeScript are the same. (TypeScript needs them before a module
// is compiled, so it cannot ask the module.)
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../tools/toolchain/folders.mjs";

const read = (file) => readFileSync(path.join(root, file), "utf8");

/** The value of `const kName = …;` in a package's file, `inline constexpr … kName = …;` in C++. */
function constantOf(file, name) {
  const value = new RegExp(`\\b${name} = ([^;]+);`).exec(read(file))[1];
  const shift = /^std::size_t\{1\} << (\d+)$/.exec(value);
  const power = /^2 \*\* (\d+)$/.exec(value);
  return shift || power ? 2 ** Number((shift ?? power)[1]) : Number(value);
}

test.each(["kSmallestMagnitude", "kLargestMagnitude", "kMostSites"])("%s", (name) => {
  const value = constantOf("src/apollonius/types.h", name);
  expect(value).not.toBeNaN();
  expect(constantOf("wasm/package/core/arguments.ts", name)).toBe(value);
});

test("kFinestTolerance", () => {
  const value = constantOf("src/apollonius/spherical_diagram.h", "kFinestTolerance");
  expect(value).toBeGreaterThan(0);
  expect(constantOf("wasm/package/sphere/spherical_arguments.ts", "kFinestTolerance")).toBe(value);
});

test("drawing commands", () => {
  const [, list] = /enum class Command[^{]*\{([^}]*)\}/.exec(read("src/apollonius/path.h"));
  const names = [...list.matchAll(/^\s*(k\w+),/gm)].map(([, name]) => name);
  expect(names).toEqual(["kMove", "kLine", "kCurve", "kClose"]);
  for (const [number, name] of names.slice(0, 3).entries())
    expect(constantOf("wasm/package/core/path.ts", name)).toBe(number);
});
