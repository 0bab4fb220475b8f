// The package as users load it: ES modules, CommonJS, the entry with a separate .wasm, workers, a
// strict policy, types.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
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

test.each([
  ["apollonius-diagram", 2],
  ["apollonius-diagram/core", 1],
  ["apollonius-diagram/shapes", 1],
  ["apollonius-diagram/sphere", 2],
  ["apollonius-diagram/treemap", 2],
])("load of %s compiles its %i parts, once", (entry, count) => {
  expect(
    runInNode(`
    let compiled = 0;
    const { compile } = WebAssembly;
    WebAssembly.compile = (bytes) => (++compiled, compile(bytes));
    const { load } = await import("${entry}");
    const result = await load();
    await load();
    console.log(result, compiled);`),
  ).toBe(`undefined ${count}`);
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
    console.log(d.voronoi().render().length > 0, d.vertices().sites.length, validate(d));`;
  const options = ["--disallow-code-generation-from-strings"];
  const printed = "1 2\nnot-finite\ntrue 0 null";
  const imports = `import { Diagram } from "apollonius-diagram";
    import { validate } from "apollonius-diagram/diagnostics";`;
  expect(runInNode(`${imports} ${use}${more}`, options)).toBe(printed);
  const requires = `const { Diagram } = require("apollonius-diagram");
    const { validate } = require("apollonius-diagram/diagnostics");`;
  expect(runScriptInNode(`${requires} ${use}${more}`, options)).toBe(printed);
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

test("objects of another copy, and proxies, are named; snapshots go to another copy", () => {
  expect(
    runInNode(`
    import { createRequire } from "node:module";
    import { Diagram } from "apollonius-diagram";
    import { renderHull, voronoi } from "apollonius-diagram/shapes";
    import { SphericalDiagram } from "apollonius-diagram/sphere";
    const require = createRequire(process.cwd() + "/x.js");
    const others = [
      new (require("apollonius-diagram").Diagram)([0, 0, 1, 5, 5, 1]),
      new (require("apollonius-diagram/sphere").SphericalDiagram)([0, 0, 1, 5, 5, 1]),
    ];
    const wrong = [...others, new Proxy(new Diagram(), {})];
    const messageOf = (call) => {
      try { call(); } catch (error) { return error.code + error.message; }
    };
    const uses = [
      (it) => voronoi(it).cellAreas(), (it) => renderHull(it),
      (it) => Diagram.prototype.find.call(it, 0, 0),
      (it) => SphericalDiagram.prototype.find.call(it, 0, 0),
    ];
    for (const it of wrong)
      console.log(uses.every((use) =>
        /^bad-option.*no proxy, and not of another copy .*fromBytes\\(other\\.toBytes/.test(
          messageOf(() => use(it)))));
    const own = messageOf(() => voronoi(new SphericalDiagram()));
    const none = messageOf(() => voronoi({}));
    console.log(/another copy/.test(own + none), own === none);
    console.log(Diagram.fromBytes(others[0].toBytes()).size, Diagram.from(others[0]).size,
      SphericalDiagram.fromBytes(others[1].toBytes()).size);`).split("\n"),
  ).toEqual(["true", "true", "true", "false true", "2 2 2"]);
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

const bytes = 'readFileSync("node_modules/apollonius-diagram/dist/core.wasm")';
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
    await load({ core: ${source} });
    ${use}`),
  ).toBe("1 2");
  expect(
    runInNode(`import { Diagram } from "apollonius-diagram/wasm";
    try { new Diagram(); } catch (error) { console.log(error.code, error.message); }`),
  ).toMatch(/^not-loaded .*`await load\(\{ core: … \}\)` before the first diagram/);
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
    /cannot be fetched: of a file give the bytes, await readFile\(new URL\(…\)\)$/,
  ],
  [
    "no wasm",
    "new Uint8Array(8)",
    /^not-loaded core is no WebAssembly: it begins with "(\\u0000){8}"\./,
  ],
  ["no bytes", "new ArrayBuffer(0)", /^not-loaded core is no WebAssembly: it begins with ""\./],
  [
    "a view of something else",
    `new TextEncoder().encode("__${page}").subarray(2)`,
    /^not-loaded core is no WebAssembly: it begins with "<!doctype html><title>Home<\/title>"/,
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
    /^not-loaded core is no WebAssembly: it begins with "<{40}"\. The file is core\.wasm/,
  ],
  [
    "what has only the beginning of wasm",
    "Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 77)",
    /^not-loaded core is cut off or damaged: /,
  ],
  [
    "a file that was cut off",
    `${bytes}.subarray(0, 50_000)`,
    /^not-loaded core is cut off or damaged: /,
  ],
  [
    "a promise of a response that there is not",
    "Promise.reject(new TypeError('offline'))",
    /^not-loaded the response for core cannot be fetched$/,
  ],
  [
    "a response that ends early",
    "new Response(new ReadableStream({ pull: (to) => to.error(new TypeError('lost')) }))",
    /^not-loaded the response ended early$/,
  ],
  [
    "a page that says it is wasm",
    `new Response("${page}", { headers: { "content-type": "application/wasm" } })`,
    /^not-loaded .*is no WebAssembly: it begins with/,
  ],
  ["nothing", "undefined", /^bad-option core is undefined, expected an address/],
])("the entry with a separate .wasm refuses %s", (_, source, expected) => {
  expect(
    runInNode(`
    import { readFileSync } from "node:fs";
    import { ApolloniusError, load } from "apollonius-diagram/wasm";
    await load({ core: ${source} }).catch((error) =>
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

// Makes calls fail for lack of memory: the program says how many go well before one throws.
const kNoMemory = `
  let left = Infinity;
  const fail = () => { throw new RangeError("could not allocate memory"); };
  const failing = (make) => new Proxy(make, {
    construct: (target, list) => (left-- > 0 ? Reflect.construct(target, list) : fail()),
    apply: (target, self, list) => (left-- > 0 ? Reflect.apply(target, self, list) : fail()),
  });
  const codeOf = async (call) => {
    try { await call(); } catch (error) { return error.code ?? String(error); }
    return "none";
  };`;
test.each([
  ["Instance", "WebAssembly.Instance = failing(WebAssembly.Instance);"],
  ["Module", "WebAssembly.Module = failing(WebAssembly.Module);"],
  // Only the text of a part is as long.
  [
    "Uint8Array",
    `globalThis.Uint8Array = new Proxy(Uint8Array, {
      construct: (target, list, made) =>
        list[0] > 5e4 && left-- <= 0 ? fail() : Reflect.construct(target, list, made),
    });`,
  ],
])("without memory for %s, the first use says so, and a later one works", (_, replace) => {
  expect(
    runInNode(`
    ${kNoMemory}
    ${replace}
    const { Diagram } = await import("apollonius-diagram");
    const { SphericalDiagram } = await import("apollonius-diagram/sphere");
    const { validate } = await import("apollonius-diagram/diagnostics");
    const found = [];
    left = 0;
    found.push(await codeOf(() => new Diagram()));
    left = Infinity;
    const d = new Diagram([0, 0, 1, 9, 0, 2]);
    for (const use of [() => d.voronoi().render(), () => new SphericalDiagram()]) {
      left = 0;
      found.push(await codeOf(use), d.find(8, 0));
      left = Infinity;
      found.push(await codeOf(use));
    }
    console.log(found.join(" "), validate(d));`),
  ).toBe(`out-of-memory ${"out-of-memory 1 none ".repeat(2)}null`);
});

test.each([
  ["Instance", "WebAssembly.Instance = failing(WebAssembly.Instance);"],
  ["compile", "WebAssembly.compile = failing(WebAssembly.compile);"],
])("without memory for %s, load says so, and a later one works", (_, replace) => {
  expect(
    runInNode(`
    import { readFileSync } from "node:fs";
    ${kNoMemory}
    ${replace}
    for (const [entry, sources] of [
      ["apollonius-diagram"],
      ["apollonius-diagram/wasm", { ${partsOf(["core"])} }],
    ]) {
      const { load } = await import(entry);
      left = 0;
      console.log(await codeOf(() => load(sources)));
      left = Infinity;
    }
    const { Diagram, load } = await import("apollonius-diagram");
    await load();
    console.log(new Diagram([0, 0, 1]).find(0, 0));`).split("\n"),
  ).toEqual(["out-of-memory", "out-of-memory", "0"]);
});

test("at the end of the stack, the first use is no lack of memory", () => {
  expect(
    runInNode(`
    const { Diagram } = await import("apollonius-diagram");
    const seen = new Set();
    const use = () => {
      try { use(); } catch (error) { seen.add(error.code ?? error.name); }
      new Diagram();
    };
    try { use(); } catch (error) { seen.add(error.code ?? error.name); }
    console.log([...seen].join(), new Diagram([0, 0, 1]).find(0, 0));`),
  ).toBe("RangeError 0");
});

test("types: ES modules, CommonJS, all ways of resolution, old and new libraries", () => {
  compileUsers(path.join(root, "node_modules/typescript/bin/tsc"));
});

const partsOf = (names) =>
  names.map((name) => `${name}: readFileSync("node_modules/apollonius-diagram/dist/${name}.wasm")`);
const useAll = `
  console.log(new SphericalDiagram([0, 0, 0, 90, 0, 0]).find(80, 0));
  console.log(d.voronoi([0, 0, 10, 10]).cellAreas().length);`;

test("the entry with separate files has all names, and takes parts one by one", () => {
  expect(
    runInNode(`
    import { readFileSync } from "node:fs";
    import { Diagram, SphericalDiagram, load, treemap } from "apollonius-diagram/wasm";
    await load({ ${partsOf(["core"])} });
    ${use}
    const codeOf = (call) => { try { call(); } catch (error) { return error.message; } };
    const layout = treemap().shape({ x: 0, y: 0, r: 1 }).size([2, 1]);
    console.log(codeOf(() => new SphericalDiagram()), layout.size().join());
    console.log(codeOf(() => layout.shape([0, 0, 1, 0, 0, 1])), layout.size().join());
    console.log(codeOf(() => d.voronoi().cellAreas()), d.find(8, 0));
    await load({ ${partsOf(["shapes", "sphere"])} });
    ${useAll}`).split("\n"),
  ).toEqual([
    "1 2",
    expect.stringMatching(/`await load\(\{ sphere: … \}\)` before .* 2,1$/),
    expect.stringMatching(/`await load\(\{ shapes: … \}\)` before .* 2,1$/),
    expect.stringMatching(/`await load\(\{ shapes: … \}\)` before .* 1$/),
    "1",
    "2",
  ]);
});

const kOrders = [
  ["core", "shapes", "sphere"],
  ["core", "sphere", "shapes"],
  ["shapes", "core", "sphere"],
  ["shapes", "sphere", "core"],
  ["sphere", "core", "shapes"],
  ["sphere", "shapes", "core"],
];
test.each(kOrders)("parts may be given in any order: %s, %s, %s", (...order) => {
  const ways = {
    "as bytes": (sources) => sources,
    "as modules": (sources) =>
      sources.map((one) => one.replace(/: (.*)/, ": new WebAssembly.Module($1)")),
  };
  for (const way of Object.values(ways)) {
    const given = way(partsOf(order)).map((source) => `{ ${source} }`);
    const use = (loading) => `
      import { readFileSync } from "node:fs";
      import { Diagram, SphericalDiagram, load } from "apollonius-diagram/wasm";
      const there = new Set();
      const attempt = (parts, call) => {
        const missing = parts.find((part) => !there.has(part));
        try {
          call();
          if (missing) console.log("done without", missing);
        } catch (error) {
          if (!missing || !error.message.includes(\`load({ \${missing}: … })\`)) console.log(error);
        }
      };
      const attempts = () => {
        attempt(["core"], () => new Diagram([0, 0, 1]).find(0, 0));
        attempt(["core", "shapes"], () => new Diagram([0, 0, 1]).voronoi().cellAreas());
        attempt(["core", "sphere"], () => new SphericalDiagram([0, 0, 1]).find(0, 0));
      };
      ${loading}`;
    const one = (source, k) => `await load(${source}); there.add("${order[k]}"); attempts();`;
    expect(runInNode(use(`attempts(); ${given.map(one).join("\n")}`))).toBe("");
    const all = `await Promise.all([${given.map((source) => `load(${source})`)}]);`;
    const added = order.map((part) => `there.add("${part}");`).join("");
    expect(runInNode(use(`${all} ${added} attempts();`))).toBe("");
  }
});

test.each(["core", "shapes", "sphere"])("another file than that of %s is named", (part) => {
  const file = (name) => `readFileSync("node_modules/apollonius-diagram/dist/${name}.wasm")`;
  const others = ["core", "shapes", "sphere"].filter((other) => other !== part);
  const own = new RegExp(
    `^not-loaded ${part} is given WebAssembly (.*), expected ${part} [\\d.]+, the`,
  );
  // an empty module; and one of a version that there is not
  const none = "Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)";
  const text = `${file(part)}.toString("latin1").replace(/ [\\d.]+$/, " 0.1.0")`;
  const old = `Buffer.from(${text}, "latin1")`;
  const givens = [
    ...others.map(file),
    old,
    none,
    `Uint8Array.of(...${none}, 2, 8, 1, 1, 97, 1, 98, 3, 126, 0)`,
  ];
  const output = runInNode(`
    import { readFileSync } from "node:fs";
    import { Diagram, SphericalDiagram, load } from "apollonius-diagram/wasm";
    for (const given of [${givens}])
      for (const source of [given, new WebAssembly.Module(given)])
        await load({ ${part}: source }).catch(({ code, message }) => console.log(code, message));
    await load({ ${partsOf(["core", "shapes", "sphere"])} });
    const globe = new SphericalDiagram([0, 0, 1]);
    console.log(new Diagram([0, 0, 1]).voronoi().cellAreas().length, globe.size);`);
  const said = output
    .split("\n")
    .map((line) => own.exec(line)?.[1].replace(/[\d.]+$/, "version") ?? line);
  const names = [...others, part].map((name) => `${name} version`);
  expect(said).toEqual([
    ...[...names, "of something else", "of something else"].flatMap((one) => [one, one]),
    "1 1",
  ]);
});

test("parts without their section, as tools leave them that make modules smaller, load", () => {
  const stripped = (part) =>
    `${part}: without(readFileSync("node_modules/apollonius-diagram/dist/${part}.wasm"))`;
  expect(
    runInNode(`
    import { readFileSync } from "node:fs";
    import { Diagram, SphericalDiagram, load } from "apollonius-diagram/wasm";
    const mark = "apollonius-diagram";
    const without = (bytes) => bytes.subarray(0, bytes.lastIndexOf(mark) - 3);
    await load({ ${["core", "shapes", "sphere"].map(stripped)} });
    ${use}
    ${useAll}`).split("\n"),
  ).toEqual(["1 2", "1", "2"]);
});

test.each([
  ["an address where parts are expected", '"core.wasm"', /^bad-option sources is the string/],
  ["a response", "new Response()", /^bad-option sources is an object, expected \{ core/],
  ["an unknown part", "{ cor: new Uint8Array() }", /^bad-option options\.cor is unknown/],
])("the entry with separate files refuses %s", (_, sources, expected) => {
  expect(
    runInNode(`
    import { load } from "apollonius-diagram/wasm";
    await load(${sources}).catch((error) => console.log(error.code, error.message));`),
  ).toMatch(expected);
});

test("diagrams are the same objects, whatever entry made them", () => {
  expect(
    runInNode(`
    import { Diagram, load } from "apollonius-diagram/core";
    await load();
    const d = new Diagram([0, 0, 1, 9, 0, 2]);
    console.log(d.find(8, 0));
    const { voronoi, render, renderSites, renderHull } = await import("apollonius-diagram/shapes");
    console.log(voronoi(d, [0, 0, 10, 10]).cellAreas().length);
    console.log([render, renderSites, renderHull].map((draw) => draw(d).length > 0).join(" "));
    const full = await import("apollonius-diagram");
    const wasm = await import("apollonius-diagram/wasm");
    console.log(full.Diagram === Diagram, wasm.Diagram === Diagram, d instanceof full.Diagram);
    console.log(d.voronoi([0, 0, 10, 10]).cellAreas().length, d.renderHull() === renderHull(d));
    console.log(full.Diagram.fromBytes(d.toBytes()).find(8, 0));`).split("\n"),
  ).toEqual(["1", "2", "true true true", "true true true", "2 true", "1"]);
});

test("a call of a part that is not imported says which import brings it", () => {
  const calls = [
    "voronoi([0, 0, 1, 1])",
    "edges({ clearance: true })",
    "render()",
    "renderSites()",
    "renderHull()",
    "smallestEnclosingCircle()",
  ];
  const lines = runInNode(`
    import { ApolloniusError, Diagram } from "apollonius-diagram/core";
    const d = new Diagram([0, 0, 1, 9, 0, 2]);
    const names = () => Object.getOwnPropertyNames(Diagram.prototype).sort().join();
    const before = names();
    const calls = [${calls.map((call) => `() => d.${call}`)}];
    const said = (call) => {
      try { call(); return "done"; } catch (error) {
        return error instanceof ApolloniusError ? error.code + " " + error.message : error.name;
      }
    };
    calls.forEach((call) => console.log(said(call)));
    console.log(d.edges().sites.length);
    const shapes = await import("apollonius-diagram/shapes");
    console.log(calls.map(said).filter((one) => /^not-loaded/.test(one)).length);
    console.log(Object.keys(shapes).join());
    const { Diagram: whole } = await import("apollonius-diagram");
    console.log(whole === Diagram, names() === before, calls.map(said).join());`).split("\n");
  const names = calls.map((call) => /^\w+/.exec(call)[0]);
  const inShapes = lines.at(-2).split(",");
  for (const [k, name] of names.entries()) {
    expect(lines[k]).toMatch(
      new RegExp(
        `^not-loaded diagram\\.${name} comes with "apollonius-diagram", ` +
          `${name}\\(diagram\\) with "apollonius-diagram/shapes": import one$`,
      ),
    );
    expect(inShapes).toContain(name);
  }
  expect(lines.slice(names.length)).toEqual([
    "2",
    "6",
    lines.at(-2),
    `true true ${Array(6).fill("done").join()}`,
  ]);
});

test("diagnostics bring no wasm, and work on diagrams of every entry", () => {
  const entries = ["", "/core", "/sphere", "/wasm"].map((name) => `apollonius-diagram${name}`);
  for (const entry of entries) {
    const [name, sources] = entry.endsWith("wasm")
      ? ["Diagram", `{ ${partsOf(["core"])} }`]
      : [entry.endsWith("sphere") ? "SphericalDiagram" : "Diagram", ""];
    const asked = (get) => `
      const { levels, predicateCounts, validate } = ${get}("apollonius-diagram/diagnostics");
      const codeOf = (call) => { try { return call(); } catch (error) { return error.code; } };
      console.log(codeOf(predicateCounts), codeOf(() => validate({})), codeOf(() => levels({})));
      const { ${name}: Made, load } = ${get}("${entry}");
      (async () => {
        await load(${sources});
        const d = new Made([0, 0, 1, 40, 0, 2, 0, 40, 3]);
        console.log(validate(d), codeOf(() => String(levels(d))), typeof predicateCounts().ties);
        d.dispose();
        console.log(codeOf(() => validate(d)), codeOf(() => levels(d)));
      })();`;
    const seen = (text) => text.split("\n");
    const ofPlane = name === "Diagram" ? "1,2,1" : "bad-option";
    const expected = [
      "not-loaded bad-option bad-option",
      `null ${ofPlane} number`,
      "disposed disposed",
    ];
    const read = 'const { readFileSync } = await import("node:fs");';
    expect(seen(runInNode(`${read} ${asked("await import")}`))).toEqual(expected);
    const required = 'const { readFileSync } = require("node:fs");';
    expect(seen(runScriptInNode(`${required} ${asked("require")}`))).toEqual(expected);
  }
});

test("a part is compiled at its first use; where it cannot be, a later call tries again", () => {
  expect(
    runInNode(`
    const { Module } = WebAssembly;
    let compiled = 0, refusal = null;
    WebAssembly.Module = new Proxy(Module, {
      construct(target, list) {
        if (refusal) throw refusal;
        ++compiled;
        return Reflect.construct(target, list);
      },
    });
    const { Diagram } = await import("apollonius-diagram");
    const { SphericalDiagram } = await import("apollonius-diagram/sphere");
    const { validate } = await import("apollonius-diagram/diagnostics");
    const d = new Diagram([0, 0, 1, 9, 0, 2]);
    const view = d.voronoi();
    d.kNearest(0, 0, 2); d.edges(); d.hull(); d.triangulation(); d.toBytes(); validate(d);
    const codeOf = (call) => { try { call(); } catch (error) { return error.code; } };
    console.log(compiled);
    refusal = new WebAssembly.CompileError("no");
    console.log(codeOf(() => view.render()), codeOf(() => new SphericalDiagram()), d.find(8, 0));
    refusal = null;
    console.log(view.render() !== "", new SphericalDiagram().size, compiled, validate(d));`).split(
      "\n",
    ),
  ).toEqual(["1", "not-loaded not-loaded 1", "true 0 3 null"]);
});
