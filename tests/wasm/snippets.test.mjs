// The code that readers paste compiles in strict TypeScript: of README.md, docs/LOADING.md, the
// recipes, and the examples of docs/API.md.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import ts from "typescript";
import { readExamples } from "../../tools/examples.mjs";
import { root } from "../../tools/toolchain/folders.mjs";
import { packed } from "./support/install_packed.mjs";

const folder = path.join(packed, "snippets");

/** Declares what pages have around the snippets: libraries without types here, contexts. */
const kAround = `
declare module "d3-hierarchy";
declare module "*.wasm?url" { const address: string; export default address; }
declare module "node:fs/promises";
declare module "node:module";
interface ImportMeta { resolve(name: string): string }
declare const context: CanvasRenderingContext2D;
declare const data: any, hierarchy: any, geoPath: any, geoOrthographic: any;
declare const L: any, map: any, maplibre: any;
`;

const blocksOf = (file) =>
  [
    ...readFileSync(path.join(root, file), "utf8").matchAll(/^```js(?: recipe)?\n([\s\S]*?)^```/gm),
  ].map(([, code], k) => [`${file}, block ${k + 1}`, code]);

/** README.md's blocks, each with the block that it continues. */
function readmeBlocks() {
  const blocks = blocksOf("README.md");
  const globe = blocks.find(([, code]) => code.includes("const globe ="))[1];
  return blocks.map(([name, code]) => {
    if (code.startsWith("const view = globe")) return [name, `${globe}${code}`];
    const isWhole = code.includes("import ");
    return [name, isWhole ? code : `import { Diagram } from "apollonius-diagram";\n${code}`];
  });
}

const examples = readExamples().flatMap(({ file, setUp, examples: own }) =>
  own.flatMap(({ calls, codes }) =>
    codes.map((code, k) => [`${file}, ${calls.join(", ")} (${k + 1})`, `${setUp}\n${code}`]),
  ),
);

/** That a parameter or variable has no type, which JavaScript cannot give it. */
const isImplicitAny = ({ code }) => code >= 7000 && code < 7100;

/** Compiles snippets, each a module; returns the compiler's messages. */
function errorsOf(name, snippets, options) {
  const within = path.join(folder, name);
  rmSync(within, { recursive: true, force: true });
  mkdirSync(within, { recursive: true });
  const nameOf = new Map();
  for (const [k, [said, code]] of snippets.entries()) {
    const file = path.join(within, `${k}.mts`);
    writeFileSync(file, `${code}\nexport {};\n`);
    nameOf.set(file, said);
  }
  const around = path.join(within, "around.d.ts");
  writeFileSync(around, kAround);
  const program = ts.createProgram([...nameOf.keys(), around], {
    strict: true,
    noEmit: true,
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.ESNext,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    lib: ["es2023", "esnext.disposable", "dom", "dom.iterable"].map((lib) => `lib.${lib}.d.ts`),
    types: [],
    skipLibCheck: true,
    ...options,
  });
  return ts
    .getPreEmitDiagnostics(program)
    .filter((one) => !isImplicitAny(one))
    .map(({ file, start, messageText }) => {
      const line = file.getLineAndCharacterOfPosition(start).line;
      const snippet = nameOf.get(path.normalize(file.fileName));
      const said = ts.flattenDiagnosticMessageText(messageText, " ");
      return `${snippet}: ${file.text.split("\n")[line]}: ${said}`;
    });
}

test("what pages and programs begin with", () => {
  const snippets = [
    ...readmeBlocks(),
    ...blocksOf("docs/LOADING.md"),
    ...blocksOf("web/pages/recipes.md"),
  ];
  expect(snippets.length).toBeGreaterThan(16);
  expect(errorsOf("pages", snippets)).toEqual([]);
});

// Examples show results that exist; a call's description says when it returns null.
test("examples of single calls, but for what may be null", () => {
  expect(examples.length).toBeGreaterThan(150);
  expect(errorsOf("examples", examples, { strictNullChecks: false })).toEqual([]);
});

test("what would be seen: a wrong argument, a wrong name, what may be null", () => {
  const begin = 'import { Diagram } from "apollonius-diagram"; const d = new Diagram();';
  const wrong = [
    "d.insert('1', 2)",
    "d.fnd(0, 0)",
    "d.nearest(0, 0).distance",
    "const f = (x) => x;",
  ];
  const snippets = wrong.map((code) => [code, `${begin}${code}`]);
  expect(errorsOf("wrong", snippets).map((error) => error.slice(0, error.indexOf(": ")))).toEqual(
    wrong.slice(0, 3),
  );
});
