// npm run format: lays out all C++ (.clang-format), TypeScript and JavaScript (.biome.jsonc).
//
//   node tools/format.mjs [--write]     without it only says which files are not laid out so
import { readdirSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { root } from "./toolchain/folders.mjs";
import { ensureNpmPackages } from "./toolchain/npm_packages.mjs";
import { run } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";

const program = (name) => path.join(root, "node_modules/.bin", name);

export function format({ write }) {
  ensureNpmPackages();
  const cpp = ["src", "wasm", "bench", "tests"].flatMap((folder) =>
    readdirSync(path.join(root, folder), { recursive: true })
      .filter((name) => /^(?!.*node_modules).*\.(cpp|h)$/.test(name)) // tests/strangers has one
      .map((name) => path.join(folder, name)),
  );
  const layout = write ? ["-i"] : ["--dry-run", "--Werror"];
  run(program("clang-format"), [...layout, ...cpp], { cwd: root });
  run(program("biome"), write ? ["format", "--write", "."] : ["format", "."], { cwd: root });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  await main(() => format({ write: process.argv.includes("--write") }));
