// The package as users get it: packed by npm, installed into build/packed, a project of its own. A
// debug build is packed from build/debug and installed below it.
import { copyFileSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../../tools/toolchain/folders.mjs";
import { capture } from "../../../tools/toolchain/process.mjs";

export const packed = path.join(root, "build/packed");
export const packedDebug = path.join(root, "build/debug/packed");

export function installPacked() {
  return install(packed, root);
}

/** Installs build/debug/dist as the package. */
export function installPackedDebug() {
  const source = path.join(root, "build/debug");
  copyFileSync(path.join(root, "package.json"), path.join(source, "package.json"));
  return install(packedDebug, source);
}

function install(packed, source) {
  rmSync(packed, { recursive: true, force: true });
  mkdirSync(packed, { recursive: true });
  const [{ filename }] = JSON.parse(
    capture("npm", ["pack", "--json", "--loglevel=error", "--pack-destination", packed], {
      cwd: source,
    }),
  );
  writeFileSync(
    path.join(packed, "package.json"),
    JSON.stringify({ name: "packed-consumer", private: true, type: "module" }),
  );
  // `import` of the bare name resolves against the importing file's folder, so the tests go through
  // a file that is here.
  writeFileSync(path.join(packed, "consumer.mjs"), 'export * from "apollonius-diagram";\n');
  for (const entry of ["sphere", "treemap", "diagnostics"])
    writeFileSync(
      path.join(packed, `${entry}.mjs`),
      `export * from "apollonius-diagram/${entry}";\n`,
    );
  capture(
    "npm",
    ["install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", `./${filename}`],
    { cwd: packed },
  );
  return path.join(packed, filename);
}
