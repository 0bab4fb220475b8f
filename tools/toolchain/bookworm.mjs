// Emscripten on Debian 12, whose own is too old for Node 20: the one of Debian 13 in a private
// folder, next to the system's LLVM 19.
//
// Clang, lld and llvm 19 are Debian 12's own, the same upstream release as Debian 13's. Emscripten
// itself is scripts and prebuilt libraries. Only Binaryen's programs need a newer C library than
// Debian 12 has: they get one beside them and are started through its loader. Nothing of the base
// system is upgraded. The folder cannot be moved: its scripts know where they are.
import {
  chmodSync,
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  renameSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import path from "node:path";
import { ensureInstalled, withDownloaded } from "./apt.mjs";
import { boostOfTrixie, keepBoostOfTrixie } from "./boost.mjs";
import { toolchain } from "./folders.mjs";
import { capture, say } from "./process.mjs";

const home = path.join(toolchain, "emscripten-debian");
export const privateEmscripten = path.join(home, "emscripten");

const llvm = "19";
const baseParts = ["clang-19", "lld-19", "llvm-19", "python3", "xz-utils"];
const scripts = ["emscripten", "node-acorn"];
const binaryen = ["binaryen", "libc6", "libstdc++6", "libgcc-s1"];

// Written last, so its presence means a complete installation; a changed recipe gets a new name.
const stamp = path.join(home, ".complete-1");

// Library variants that nothing here links, three quarters of the package. libGL stays: it is
// linked by default.
const libraries = "*/lib/wasm32-emscripten";
const leftOut = [
  "./usr/share/emscripten/test",
  `${libraries}/pic`,
  `${libraries}/lto-pic`,
  "*-ww*.a",
  "*wasmfs*",
  "libwebgpu*",
  "*-tracing*.a",
];

export function ensureBookwormEmscripten() {
  ensureInstalled(baseParts, "WebAssembly (Emscripten)");
  if (existsSync(stamp)) return;
  say(`Emscripten of Debian 13 -> ${home} (once, about half a minute)`);
  mkdirSync(toolchain, { recursive: true });
  rmSync(home, { recursive: true, force: true });
  const work = mkdtempSync(path.join(toolchain, "unpack-"));
  try {
    withDownloaded([...scripts, ...binaryen, boostOfTrixie], { release: "trixie" }, (file) => {
      unpackEmscripten(work, file);
      unpackBinaryen(work, file);
      keepBoostOfTrixie(file(boostOfTrixie));
    });
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
  writeConfiguration();
  writeFileSync(stamp, "");
}

function unpackEmscripten(work, file) {
  const folder = path.join(work, "emscripten");
  mkdirSync(folder);
  mkdirSync(home, { recursive: true });
  capture("sh", [
    "-c",
    'dpkg-deb --fsys-tarfile "$1" | tar -x -C "$2" ' +
      leftOut.map((name) => `--exclude='${name}'`).join(" ") +
      " ./usr/share/emscripten",
    "sh",
    file("emscripten"),
    folder,
  ]);
  renameSync(path.join(folder, "usr/share/emscripten"), privateEmscripten);
  // Emscripten's JavaScript optimizer imports acorn; an import, unlike require, looks only in
  // node_modules folders above it.
  const acorn = path.join(work, "acorn");
  capture("dpkg-deb", ["-x", file("node-acorn"), acorn]);
  cpSync(
    path.join(acorn, "usr/share/nodejs/acorn"),
    path.join(privateEmscripten, "node_modules/acorn"),
    { recursive: true, dereference: true },
  );
}

function unpackBinaryen(work, file) {
  const unpacked = path.join(work, "binaryen");
  for (const name of binaryen) capture("dpkg-deb", ["-x", file(name), unpacked]);
  const target = path.join(home, "binaryen");
  for (const folder of ["bin", "programs", "lib"])
    mkdirSync(path.join(target, folder), { recursive: true });

  const triple = readdirSync(path.join(unpacked, "usr/lib")).find((name) =>
    name.includes("-linux-gnu"),
  );
  const from = path.join(unpacked, "usr/lib", triple);
  const needed = /^(ld-linux.*\.so\.\d+|lib(c|m|stdc\+\+|gcc_s)\.so\.\d+|libbinaryen\.so)$/;
  const found = [from, path.join(from, "binaryen")].filter(existsSync).flatMap((folder) =>
    readdirSync(folder)
      .filter((name) => needed.test(name))
      .map((name) => path.join(folder, name)),
  );
  for (const library of found) {
    cpSync(library, path.join(target, "lib", path.basename(library)), { dereference: true });
  }
  const loader = found
    .map((library) => path.basename(library))
    .find((name) => name.startsWith("ld-linux"));

  const programs = path.join(unpacked, "usr/bin");
  for (const name of readdirSync(programs).filter((program) => program.startsWith("wasm"))) {
    cpSync(path.join(programs, name), path.join(target, "programs", name), { dereference: true });
    script(
      path.join(target, "bin", name),
      `exec '${target}/lib/${loader}' --library-path '${target}/lib' ` +
        `'${target}/programs/${name}' "$@"`,
    );
  }
}

/**
 * Emscripten's settings, and the commands emcc, em++… both in bin/ and where its CMake files expect
 * them.
 */
function writeConfiguration() {
  const config = path.join(privateEmscripten, ".emscripten");
  writeFileSync(
    config,
    [
      "from shutil import which",
      "LLVM_ROOT = '/usr/bin'",
      `LLVM_ADD_VERSION = '${llvm}'`,
      `CLANG_ADD_VERSION = '${llvm}'`,
      `BINARYEN_ROOT = '${home}/binaryen'`,
      `NODE_JS = which('node') or '${process.execPath}'`,
      "FROZEN_CACHE = True",
      "",
    ].join("\n"),
  );
  mkdirSync(path.join(home, "bin"), { recursive: true });
  for (const name of readdirSync(privateEmscripten).filter((entry) => /^em.*\.py$/.test(entry))) {
    const command = name.replace(/\.py$/, "");
    script(
      path.join(home, "bin", command),
      `EM_CONFIG='${config}' exec /usr/bin/python3 '${privateEmscripten}/${name}' "$@"`,
    );
    rmSync(path.join(privateEmscripten, command), { force: true });
    symlinkSync(path.join(home, "bin", command), path.join(privateEmscripten, command));
  }
}

function script(file, line) {
  writeFileSync(file, `#!/bin/sh\n${line}\n`);
  chmodSync(file, 0o755);
}
