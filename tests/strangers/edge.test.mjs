// The packed package in Cloudflare's own runtime and in Vercel's, which compile only imported
// WebAssembly: bundled as wrangler and Next do, with the conditions of such packages. And in Deno.
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { createInterface } from "node:readline";
import { build } from "esbuild";
import { root } from "../../tools/toolchain/folders.mjs";
import { packed } from "../wasm/support/install_packed.mjs";

const folder = path.join(packed, "edge");
const installed = path.join(packed, "node_modules/apollonius-diagram");
const example = path.join(root, "web/examples/cloudflare_worker.js");

const parts = ["core.wasm", "shapes.wasm", "sphere.wasm"];

/** A worker of one module and the compiled modules that it may import. */
const config = `
using Workerd = import "/workerd/workerd.capnp";
const config :Workerd.Config = (
  services = [(name = "main", worker = .worker)],
  sockets = [(name = "http", address = "127.0.0.1:0", http = (), service = "main")],
);
const worker :Workerd.Worker = (
  modules = [
    (name = "worker.js", esModule = embed "worker.js"),
${parts.map((name) => `    (name = "${name}", wasm = embed "${name}"),`).join("\n")}
  ],
  compatibilityDate = "2025-01-01",
);
`;

async function bundled(source, conditions) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  await build({
    stdin: { contents: source, resolveDir: packed, loader: "js" },
    outfile: path.join(folder, "worker.js"),
    bundle: true,
    format: "esm",
    conditions,
    logLevel: "silent",
    // As wrangler does: modules of their own, compiled.
    plugins: [
      {
        name: "compiled-wasm",
        setup({ onResolve }) {
          onResolve({ filter: /\.wasm(\?module)?$/ }, ({ path: name }) => ({
            path: `./${path.basename(name).replace("?module", "")}`,
            external: true,
          }));
        },
      },
    ],
  });
  for (const name of parts) cpSync(path.join(installed, "dist", name), path.join(folder, name));
  writeFileSync(path.join(folder, "config.capnp"), config);
}

/** Returns the worker's answers to a request for each path. */
async function answers(...paths) {
  const program = path.join(root, "tests/strangers/node_modules/.bin/workerd");
  const child = spawn(program, ["serve", "config.capnp", "--control-fd=3"], {
    cwd: folder,
    stdio: ["ignore", "inherit", "inherit", "pipe"],
  });
  try {
    const lines = createInterface({ input: child.stdio[3] });
    const [line] = await Promise.race([
      once(lines, "line"),
      once(child, "exit").then(([code]) => Promise.reject(new Error(`workerd ended: ${code}`))),
    ]);
    const { port } = JSON.parse(line);
    const texts = [];
    for (const name of paths) {
      const response = await fetch(`http://127.0.0.1:${port}${name}`);
      texts.push(await response.text());
    }
    return texts;
  } finally {
    child.kill();
  }
}

const worker = (imports, body) =>
  `${imports}\nexport default { async fetch(request) {\n` +
  `try { ${body} }\n` +
  "catch (error) { return new Response(`${error.code} ${error.message}`); } } };";
const use = "const d = new Diagram([0, 0, 1, 9, 0, 2]); return new Response(String(d.find(8, 0)));";

test("workerd: the default entry needs nothing but its condition", async () => {
  await bundled(worker('import { Diagram } from "apollonius-diagram";', use), ["workerd"]);
  expect(await answers("/", "/again")).toEqual(["1", "1"]);
});

test("workerd: core alone, and treemaps, each with the parts that it needs", async () => {
  const imports =
    'import { Diagram } from "apollonius-diagram/core";' +
    'import { treemap } from "apollonius-diagram/treemap";' +
    'import { voronoi } from "apollonius-diagram/shapes";' +
    'import { validate } from "apollonius-diagram/diagnostics";';
  const body =
    "const d = new Diagram([0, 0, 1, 9, 0, 2]);" +
    "const area = voronoi(d, [0, 0, 10, 10]).cellAreas().reduce((a, b) => a + b);" +
    "return new Response(`${d.find(8, 0)} ${area.toFixed(6)} ${typeof treemap()} ${validate(d)}`);";
  await bundled(worker(imports, body), ["workerd"]);
  expect(await answers("/")).toEqual(["1 100.000000 function null"]);
});

const importSphere = 'import { SphericalDiagram } from "apollonius-diagram/sphere";';
const useSphere =
  "const s = new SphericalDiagram([0, 0, 0.1, 180, 0, 0.2, 10, 80, 0]);" +
  "const area = s.voronoi().cellAreas().reduce((a, b) => a + b);" +
  "const text = `${s.find(170, 5)} ${s.size} ${(area / Math.PI).toFixed(9)}`;";
const answerOfSphere = "1 3 4.000000000";

test("workerd: the sphere, whose part of the wasm is another file", async () => {
  const body = `${useSphere} return new Response(text);`;
  await bundled(worker(importSphere, body), ["workerd"]);
  expect(await answers("/", "/again")).toEqual([answerOfSphere, answerOfSphere]);
});

test("workerd: the sphere and the plane in one module, restored from bytes", async () => {
  const imports = `import { Diagram } from "apollonius-diagram"; ${importSphere}`;
  const body =
    `${useSphere} const d = new Diagram([0, 0, 1, 9, 0, 2]);` +
    "const again = SphericalDiagram.fromBytes(s.toBytes());" +
    "return new Response(`${d.find(8, 0)} ${again.find(170, 5)} ${text}`);";
  await bundled(worker(imports, body), ["workerd"]);
  expect(await answers("/")).toEqual([`1 1 ${answerOfSphere}`]);
});

/** Returns the answer of Vercel's edge runtime, given the compiled modules from outside. */
async function answerOfVercel(source) {
  const { EdgeRuntime } = await import("edge-runtime");
  const { outputFiles } = await build({
    stdin: { contents: source, resolveDir: packed, loader: "js" },
    bundle: true,
    write: false,
    conditions: ["edge-light"],
    logLevel: "silent",
    plugins: [
      {
        name: "compiled-wasm",
        setup({ onResolve, onLoad }) {
          const namespace = "outside";
          onResolve({ filter: /\.wasm\?module$/ }, ({ path: name }) => ({
            path: path.basename(name).replace("?module", ""),
            namespace,
          }));
          onLoad({ filter: /.*/, namespace }, ({ path: name }) => ({
            contents: `export default compiledModules["${name}"]`,
          }));
        },
      },
    ],
  });
  const compiled = (name) =>
    new WebAssembly.Module(readFileSync(path.join(installed, "dist", name)));
  const compiledModules = Object.fromEntries(parts.map((name) => [name, compiled(name)]));
  const runtime = new EdgeRuntime({
    initialCode: outputFiles[0].text,
    extend: (context) => Object.assign(context, { compiledModules }),
  });
  return (await runtime.dispatchFetch("https://example.com/")).text();
}

test("edge-light: the same, with a module of another realm", async () => {
  const imported = 'import { Diagram, load } from "apollonius-diagram";';
  const answer = `load().then(() => { ${use} })`;
  const source = `${imported} addEventListener("fetch", (e) => e.respondWith(${answer}));`;
  expect(await answerOfVercel(source)).toBe("1");
});

test("edge-light: the sphere", async () => {
  const answer = `(() => { ${useSphere} return new Response(text); })()`;
  const source = `${importSphere} addEventListener("fetch", (e) => e.respondWith(${answer}));`;
  expect(await answerOfVercel(source)).toBe(answerOfSphere);
});

test("Deno, without any permission but to read", () => {
  const source =
    `import { Diagram } from "apollonius-diagram"; ${importSphere} {` +
    "using d = new Diagram([0, 0, 1, 9, 0, 2]);" +
    "console.log(d.find(8, 0), Deno.inspect(d), Diagram.fromBytes(d.toBytes()).size);" +
    `${useSphere} console.log(text); }`;
  writeFileSync(path.join(packed, "deno.mjs"), source);
  const program = path.join(root, "tests/strangers/node_modules/.bin/deno");
  const args = ["run", "--no-remote", "--no-prompt", `--allow-read=${packed}`, "deno.mjs"];
  expect(spawnSync(program, args, { cwd: packed, encoding: "utf8" })).toMatchObject({
    stdout: `1 Diagram { size: 2, hidden: 0 } 2\n${answerOfSphere}\n`,
    stderr: "",
  });
});

test("the entry with a .wasm of its own loads the module that is imported", async () => {
  const source =
    'import { Diagram, load } from "apollonius-diagram/wasm";\n' +
    'import core from "apollonius-diagram/core.wasm";';
  await bundled(worker(source, `await load({ core }); ${use}`), ["workerd"]);
  expect(await answers("/")).toEqual(["1"]);
});

test("without the condition, the error says what to do", async () => {
  await bundled(worker('import { Diagram } from "apollonius-diagram";', use), ["import"]);
  const [answer] = await answers("/");
  expect(answer).toMatch(/^not-loaded WebAssembly cannot be compiled here .* importing the \.wasm/);
});

test("the example", async () => {
  await bundled(readFileSync(example, "utf8"), ["workerd"]);
  expect((await answers("/?x=155&y=88")).map((text) => JSON.parse(text))).toEqual([
    { id: 0, distance: expect.closeTo(5.579, 3) },
  ]);
});
