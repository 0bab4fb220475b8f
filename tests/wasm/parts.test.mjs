// The part of the module that each call needs, and the parts' imports of each other.
import { readFileSync } from "node:fs";
import path from "node:path";
import { expect, test } from "@jest/globals";
import { packed } from "./support/install_packed.mjs";

// Compiles core, and refuses all that comes later.
const { Module } = WebAssembly;
let compiled = 0;
WebAssembly.Module = new Proxy(Module, {
  construct(target, list) {
    if (compiled > 0) throw new WebAssembly.CompileError("refused");
    ++compiled;
    return Reflect.construct(target, list);
  },
});
const { Diagram } = await import("../../build/packed/consumer.mjs");
const { validate } = await import("../../build/packed/diagnostics.mjs");
const { SphericalDiagram } = await import("../../build/packed/sphere.mjs");
const { calls } = await import("./support/calls.mjs");

const circles = [0, 0, 10, 50, 5, 8, 20, 40, 5, 45, 45, 12, 0, 0, 3];

const needed = {
  "Diagram.voronoi": "core", // a view, which computes nothing yet
  "Diagram.render": "shapes",
  "Diagram.renderSites": "shapes",
  "Diagram.renderHull": "shapes",
  "Diagram.smallestEnclosingCircle": "shapes",
};
const partOf = (name) => needed[name] ?? (name.startsWith("Voronoi.") ? "shapes" : "core");

test.each(calls.map(([name, { use }]) => [name, use]))("%s", async (name, use) => {
  const diagram = new Diagram(circles);
  const error = await (async () => use(diagram))().catch((thrown) => thrown);
  expect([name, error?.code === "not-loaded" ? "shapes" : "core"]).toEqual([name, partOf(name)]);
  if (!/clear|dispose/.test(name)) expect(validate(diagram)).toBeNull();
});

test("a sphere needs a part of its own, and is refused without it", () => {
  expect(() => new SphericalDiagram()).toThrow(expect.objectContaining({ code: "not-loaded" }));
  expect(compiled).toBe(1);
});

test("the parts import core, and core none of them", () => {
  const importsOf = (part) => {
    const bytes = readFileSync(
      path.join(packed, `node_modules/apollonius-diagram/dist/${part}.wasm`),
    );
    return [...new Set(Module.imports(new Module(bytes)).map(({ module }) => module))].sort();
  };
  expect(importsOf("core")).toEqual(["env"]);
  expect(importsOf("shapes")).toEqual(["core"]);
  expect(importsOf("sphere")).toEqual(["core"]);
});
