// npm run lint: what can be said of the sources without building them. Changes nothing.
//
//   - the layout (tools/format.mjs; `npm run format` mends it)
//   - Biome's rules for JavaScript and TypeScript (.biome.jsonc)
//   - the types of the page's JavaScript, which its comments give (web/tsconfig.json)
import path from "node:path";
import { pathToFileURL } from "node:url";
import { format } from "./format.mjs";
import { root } from "./toolchain/folders.mjs";
import { ensureNpmPackages } from "./toolchain/npm_packages.mjs";
import { run } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";

export function lint() {
  ensureNpmPackages();
  format({ write: false });
  const modules = path.join(root, "node_modules");
  run(path.join(modules, ".bin/biome"), ["lint", "--error-on-warnings", "."], { cwd: root });
  run(process.execPath, [path.join(modules, "typescript/bin/tsc"), "-p", path.join(root, "web")]);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await main(lint);
