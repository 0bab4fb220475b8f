// npm run lint: what can be said of the sources without running them. Changes nothing.
//
//   - the layout (tools/format.mjs; `npm run format` mends it)
//   - Biome's rules for JavaScript and TypeScript (.biome.jsonc)
//   - words that readers have to guess (tools/words.mjs)
//   - the types of the page (web/tsconfig.json), and of the examples' JavaScript, which its
//     comments give (web/examples/tsconfig.json), if dist/ is there; `npm test -- web` checks them
//     with a new one
import { existsSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { format } from "./format.mjs";
import { root } from "./toolchain/folders.mjs";
import { ensureNpmPackages } from "./toolchain/npm_packages.mjs";
import { run, say } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";
import { avoidedWords } from "./words.mjs";

const modules = path.join(root, "node_modules");

/** Layout and rules: needs no build. */
export function lint() {
  ensureNpmPackages();
  format({ write: false });
  run(path.join(modules, ".bin/biome"), ["lint", "--error-on-warnings", "."], { cwd: root });
  const places = avoidedWords();
  if (places.length > 0) throw new Error(`words to replace:\n  ${places.join("\n  ")}`);
}

/** The types of the page and of the examples, with the package's from dist/. */
export function checkPage() {
  const compiler = path.join(modules, "typescript/bin/tsc");
  for (const folder of ["web", "web/examples"])
    run(process.execPath, [compiler, "-p", path.join(root, folder)]);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await main(() => {
    lint();
    if (existsSync(path.join(root, "dist/esm/index.d.ts"))) checkPage();
    else say("the page's types are not checked: there is no dist/ (npm run build)");
  });
}
