// Documentation, types and exports agree: docs/API.md is what the sources say, the package exports
// what it lists, README and the table for d3-delaunay's users leave nothing out.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { Delaunay, Voronoi } from "d3-delaunay";
import ts from "typescript";
import * as consumer from "../../build/packed/consumer.mjs";
import { describePackage, reference, referenceFile } from "../../tools/api_reference.mjs";
import { root } from "../../tools/toolchain/folders.mjs";
import { packed } from "./support/install_packed.mjs";
import { methodsOf } from "./support/methods.mjs";

const described = describePackage();
const classes = described
  .flatMap((entry) => entry.described)
  .filter(({ kind }) => kind === "class");
const require = createRequire(path.join(packed, "package.json"));
const sphere = require("apollonius-diagram/sphere");
/** Classes that users get objects of, but not the class. */
const views = {
  Voronoi: new consumer.Diagram().voronoi().constructor,
  SphericalVoronoi: new sphere.SphericalDiagram().voronoi().constructor,
};
const values = { ...consumer, ...sphere, ...views };
const read = (file) => readFileSync(path.join(root, file), "utf8");

test("docs/API.md is up to date (npm run docs)", () => {
  expect(readFileSync(referenceFile, "utf8")).toBe(reference());
});

test.each(
  described.map(({ entry, exports }) => [entry, exports]),
)("%s exports what is documented, as ES module and CommonJS, and in types", (entry, exports) => {
  const isValue = (name) => !(name in views);
  const named = exports
    .filter(isValue)
    .filter((name) =>
      described
        .flatMap((other) => other.described)
        .some((one) => one.name === name && ["class", "function", "const"].includes(one.kind)),
    );
  expect(Object.keys(require(entry)).sort()).toEqual([...named].sort());
  if (entry === "apollonius-diagram")
    expect(Object.keys(consumer).sort()).toEqual([...named].sort());
  for (const format of ["esm", "cjs"]) {
    const file = path.join(
      packed,
      "node_modules/apollonius-diagram/dist",
      format,
      `${entry.split("/")[1] ?? "index"}.d.ts`,
    );
    const program = ts.createProgram([file], {
      noLib: true,
      types: [],
      module: ts.ModuleKind.ESNext,
      moduleResolution: ts.ModuleResolutionKind.Bundler,
    });
    const checker = program.getTypeChecker();
    const types = checker
      .getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file)))
      .map(({ name }) => name);
    expect(types.sort()).toEqual([...exports].sort());
  }
});

test.each(
  classes.map((one) => [one.name, one]),
)("every member of %s is documented, and every documented one is there", (name, { members }) => {
  const there = methodsOf(values[name])
    .map((key) => (typeof key === "symbol" ? key.description.replace("nodejs.d", "Symbol.d") : key))
    .filter((key) => key !== "nodejs.util.inspect.custom");
  const documented = members
    .filter(({ isStatic, code }) => !isStatic && !/^readonly \w+( =|: ErrorCode)/.test(code))
    .map((member) => member.name);
  // Properties of instances are not on the prototype, and a constructor that is not for users is
  // not documented.
  const isHere = (member) =>
    there.includes(member) ||
    members.some(({ name: other, code }) => other === member && !/^readonly /.test(code));
  expect(documented.filter(isHere).sort()).toEqual(
    there.filter((member) => member !== "constructor" || documented.includes(member)).sort(),
  );
  for (const { name: member } of members.filter(({ isStatic }) => isStatic))
    expect(values[name]).toHaveProperty(member);
});

test("every public name says what it is, and every call of a diagram what it costs", () => {
  const all = described.flatMap((entry) => entry.described);
  const silent = all.flatMap(({ name, text, members }) => [
    ...(text ? [] : [name]),
    ...members.filter((member) => !member.text).map((member) => `${name}.${member.name}`),
  ]);
  expect(silent).toEqual([]);
  const free = all
    .find(({ name }) => name === "Diagram")
    .members.filter(({ text }) => !/\bO\(|\b[Cc]ost\b|As `\w+`/.test(text))
    .map(({ name }) => name);
  expect(free).toEqual([]);
});

test("error codes in the documentation exist, and each is documented", () => {
  const codes = described[0].described.find(({ name }) => name === "ErrorCode");
  const known = [...codes.code.matchAll(/"([\w-]+)"/g)].map((match) => match[1]);
  for (const code of known) expect(codes.text).toContain(`- "${code}": `);
  const diagram = classes.find(({ name }) => name === "Diagram");
  const named = diagram.members.flatMap(({ text }) =>
    [...text.matchAll(/"([a-z]+-[a-z]+|disposed)"/g)].map((match) => match[1]),
  );
  expect(named.filter((code) => !known.includes(code))).toEqual([]);
});

test("README's list has every call of a diagram", () => {
  const missing = classes
    .find(({ name }) => name === "Diagram")
    .members.map(({ name }) => name)
    .filter(
      (name) =>
        !/^(constructor|toString|Symbol\.\w+)$/.test(name) &&
        !new RegExp(`\`[^\`]*\\b${name}\\b`).test(read("README.md")),
    );
  expect(missing).toEqual([]);
});

test("the table for d3-delaunay's users has every public name of d3-delaunay", () => {
  const [table] = read("docs/D3_DELAUNAY.md").split("# From d3-geo-voronoi");
  const names = (type, object) =>
    [...Object.getOwnPropertyNames(type.prototype), ...Object.getOwnPropertyNames(object)].filter(
      (name) => !name.startsWith("_") && name !== "constructor",
    );
  const delaunay = new Delaunay([0, 0, 1, 0, 0, 1]);
  const statics = ["from"];
  const missing = [
    ...names(Delaunay, delaunay).map((name) => `delaunay.${name}`),
    ...names(Voronoi, delaunay.voronoi()).map((name) => `voronoi.${name}`),
    ...statics.map((name) => `Delaunay.${name}`),
  ].filter((name) => !table.includes(`\`${name}`));
  expect(missing).toEqual([]);
});

test("the changelog's newest version is the package's", () => {
  expect(/^## (\S+)/m.exec(read("CHANGELOG.md"))[1]).toBe(JSON.parse(read("package.json")).version);
});
