// The package as users load it: ES modules, CommonJS, the entry with a separate .wasm, workers, a
// strict policy, types.
import { readFileSync, statSync } from "node:fs";
import path from "node:path";
import { build } from "esbuild";
import { root } from "../../tools/toolchain/folders.mjs";
import { packed } from "./support/install_packed.mjs";
import { runInNode, runScriptInNode } from "./support/node.mjs";
import { compileUsers } from "./support/types.mjs";

const use = "const d = new Diagram([0, 0, 1, 9, 0, 2]); console.log(d.find(8, 0), d.size);";

test("import", () => {
  expect(runInNode(`import { Diagram } from "apollonius-diagram"; ${use}`)).toBe("1 2");
});

test("require", () => {
  expect(runScriptInNode(`const { Diagram } = require("apollonius-diagram"); ${use}`)).toBe("1 2");
});

test("the example for CommonJS", () => {
  const file = path.join(root, "web/examples/commonjs.cjs");
  expect(runScriptInNode(readFileSync(file, "utf8"))).toBe("0 1");
});

test("load compiles ahead, once or often", () => {
  expect(
    runInNode(`
    import { Diagram, load } from "apollonius-diagram";
    await Promise.all([load(), load()]);
    await load();
    ${use}`),
  ).toBe("1 2");
});

test("a diagram made while load is under way is not lost", () => {
  expect(
    runInNode(`
    import { Diagram, load } from "apollonius-diagram";
    const loading = load();
    const early = new Diagram([0, 0, 1]);
    await loading;
    console.log(early.insert(5, 5, 1), new Diagram([1, 1, 1]).find(0, 0), early.size);`),
  ).toBe("1 0 2");
});

test("import compiles nothing and is no promise", () => {
  expect(
    runScriptInNode(`
    let compiled = 0;
    const Module = WebAssembly.Module;
    WebAssembly.Module = new Proxy(Module, {
      construct(target, args) { ++compiled; return Reflect.construct(target, args); },
    });
    for (const name of ["compile", "instantiate", "compileStreaming", "instantiateStreaming"]) {
      const original = WebAssembly[name];
      WebAssembly[name] = (...args) => { ++compiled; return original(...args); };
    }
    const before = Object.keys(globalThis).length;
    const { Diagram } = require("apollonius-diagram");
    const atImport = [compiled, Object.keys(globalThis).length - before];
    new Diagram(); new Diagram();
    console.log(JSON.stringify([atImport, compiled]));`),
  ).toBe("[[0,0],1]");
});

test("no code is made from strings", () => {
  const more = `
    try { d.insert(NaN, 0); } catch (error) { console.log(error.code); }
    console.log(d.voronoi().render().length > 0, d.vertices().sites.length, d.validate());`;
  const options = ["--disallow-code-generation-from-strings"];
  const printed = "1 2\nnot-finite\ntrue 0 null";
  expect(runInNode(`import { Diagram } from "apollonius-diagram"; ${use}${more}`, options)).toBe(
    printed,
  );
  expect(
    runScriptInNode(`const { Diagram } = require("apollonius-diagram"); ${use}${more}`, options),
  ).toBe(printed);
});

test.each([
  ["require", 'const { Diagram } = require("apollonius-diagram");'],
  ["import", 'const { Diagram } = await import("apollonius-diagram");'],
])("in a worker, by %s", (_, get) => {
  expect(
    runScriptInNode(`
    const { Worker } = require("node:worker_threads");
    const worker = new Worker(\`(async () => {
      const { parentPort } = require("node:worker_threads");
      ${get}
      parentPort.postMessage(new Diagram([0, 0, 1, 9, 0, 2]).find(8, 0));
    })()\`, { eval: true });
    worker.on("message", (id) => console.log(id));`),
  ).toBe("1");
});

test("two copies of the package in one process do not disturb each other", () => {
  expect(
    runInNode(`
    import { createRequire } from "node:module";
    import { Diagram } from "apollonius-diagram";
    const other = createRequire(process.cwd() + "/x.js")("apollonius-diagram").Diagram;
    const [a, b] = [new Diagram([0, 0, 1]), new other([0, 0, 1, 5, 5, 1])];
    console.log(a.size, b.size, a instanceof other);`),
  ).toBe("1 2 false");
});

const bytes = 'readFileSync("node_modules/apollonius-diagram/dist/apollonius.wasm")';
const elsewhere = `((code) => runInNewContext(code)(${bytes}))`;
test.each([
  ["bytes", bytes],
  ["a compiled module", `new WebAssembly.Module(${bytes})`],
  ["one of another realm", `${elsewhere}("(data) => new WebAssembly.Module(data)")`],
  ["bytes of another realm", `${elsewhere}("(data) => new Uint8Array(data).buffer")`],
  ["a response", `new Response(${bytes}, { headers: { "content-type": "application/wasm" } })`],
  ["a promise of a response of unknown type", `Promise.resolve(new Response(${bytes}))`],
  ["an address", `"data:application/wasm;base64," + ${bytes}.toString("base64")`],
])("the entry with a separate .wasm loads %s", (_, source) => {
  expect(
    runInNode(`
    import { readFileSync } from "node:fs";
    import { runInNewContext } from "node:vm";
    import { Diagram, load } from "apollonius-diagram/wasm";
    await load(${source});
    ${use}`),
  ).toBe("1 2");
  expect(
    runInNode(`import { Diagram } from "apollonius-diagram/wasm";
    try { new Diagram(); } catch (error) { console.log(error.code, error.message); }`),
  ).toMatch(/^not-loaded .*await load\(source\)/);
});

const page = "<!doctype html><title>Home</title>";
test.each([
  ["no address", '"nowhere:7"', /^not-loaded nowhere:7 cannot be fetched/],
  ["another answer", 'new Response("", { status: 404 })', /^not-loaded .* answered 404/],
  [
    "a file",
    '"file:///nowhere/7"',
    /^not-loaded file:\/\/\/nowhere\/7 cannot be fetched: of a file/,
  ],
  [
    "a file's URL",
    'new URL("file:///nowhere/7")',
    /cannot be fetched: of a file give the bytes, load\(await readFile\(new URL\(…\)\)\)$/,
  ],
  [
    "no wasm",
    "new Uint8Array(8)",
    /^not-loaded source is no WebAssembly: it begins with "(\\u0000){8}"\./,
  ],
  ["no bytes", "new ArrayBuffer(0)", /^not-loaded source is no WebAssembly: it begins with ""\./],
  [
    "a view of something else",
    `new TextEncoder().encode("__${page}").subarray(2)`,
    /^not-loaded source is no WebAssembly: it begins with "<!doctype html><title>Home<\/title>"/,
  ],
  [
    "a page instead of it",
    `new Response("${page}", { headers: { "content-type": "text/html; charset=utf-8" } })`,
    /^not-loaded the response \(text\/html; charset=utf-8\) is no WebAssembly: it begins with "</,
  ],
  [
    "a page's address",
    `"data:text/html,${page}"`,
    /^not-loaded data:text\/html,.* \(text\/html\) is no WebAssembly: it begins with "</,
  ],
  [
    "much of something else, of which it says the beginning",
    'new TextEncoder().encode("<".repeat(1e6))',
    /^not-loaded source is no WebAssembly: it begins with "<{40}"\. The file is apollonius\.wasm/,
  ],
  [
    "what has only the beginning of wasm",
    "Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 77)",
    /^not-loaded WebAssembly cannot be compiled here/,
  ],
  [
    "a page that says it is wasm",
    `new Response("${page}", { headers: { "content-type": "application/wasm" } })`,
    /^not-loaded .*is no WebAssembly: it begins with/,
  ],
  ["nothing", "undefined", /^bad-option source is undefined, expected an address/],
])("the entry with a separate .wasm refuses %s", (_, source, expected) => {
  expect(
    runInNode(`
    import { ApolloniusError, load } from "apollonius-diagram/wasm";
    await load(${source}).catch((error) =>
      console.log(error instanceof ApolloniusError && error.code, error.message));`),
  ).toMatch(expected);
});

test("where nothing may be compiled, the error says what to do; later, it works", () => {
  expect(
    runInNode(`
    const { Module, compile } = WebAssembly;
    const refuse = () => { throw new WebAssembly.CompileError("disallowed by embedder"); };
    WebAssembly.Module = new Proxy(Module, { construct: refuse });
    WebAssembly.compile = async () => refuse();
    const { ApolloniusError, Diagram, load } = await import("apollonius-diagram");
    const attempts = [() => new Diagram(), () => Diagram.from([[1, 2]]), load];
    for (const attempt of attempts) {
      try { await attempt(); } catch (error) {
        console.log(error instanceof ApolloniusError, error.code, error.cause.name,
          /disallowed by embedder.*'wasm-unsafe-eval'.*load\\(\\)/.test(error.message));
      }
    }
    WebAssembly.Module = Module;
    console.log(new Diagram([0, 0, 1]).size);`).split("\n"),
  ).toEqual([...Array(3).fill("true not-loaded CompileError true"), "1"]);
});

test("no memory to begin with is a lack of memory", () => {
  expect(
    runInNode(`
    const { Instance } = WebAssembly;
    WebAssembly.Instance = new Proxy(Instance, {
      construct() { throw new RangeError("could not allocate memory"); },
    });
    const { Diagram } = await import("apollonius-diagram");
    try { new Diagram(); } catch (error) { console.log(error.code); }`),
  ).toBe("out-of-memory");
});

test("types: ES modules, CommonJS, NodeNext and Bundler resolution, old and new libraries", () => {
  compileUsers(path.join(root, "node_modules/typescript/bin/tsc"));
}, 120_000);

// docs/LOADING.md. An import map does the same where there is no bundler.
test.each([
  ["with a name that is redirected, the sphere works in the module that was loaded", true],
  ["else it brings the default entry", false],
])("the sphere beside the entry with a separate .wasm: %s", async (_, isRedirected) => {
  const contents = `
    import { readFileSync } from "node:fs";
    import { Diagram, load } from "apollonius-diagram/wasm";
    import { SphericalDiagram } from "apollonius-diagram/sphere";
    await load(readFileSync("node_modules/apollonius-diagram/dist/apollonius.wasm"));
    ${use}
    console.log(new SphericalDiagram([0, 0, 0, 90, 0, 0]).find(80, 0));`;
  const redirect = {
    name: "redirect",
    setup: (bundler) =>
      bundler.onResolve({ filter: /^apollonius-diagram$/ }, ({ kind, resolveDir }) =>
        bundler.resolve("apollonius-diagram/wasm", { kind, resolveDir }),
      ),
  };
  const outfile = path.join(packed, "beside_wasm.mjs");
  await build({
    stdin: { contents, resolveDir: packed },
    bundle: true,
    platform: "node",
    format: "esm",
    outfile,
    plugins: isRedirected ? [redirect] : [],
  });
  expect(runInNode('import "./beside_wasm.mjs";')).toBe("1 2\n1");
  // The default entry has the wasm as text.
  expect(statSync(outfile).size < 250_000).toBe(isRedirected);
});
