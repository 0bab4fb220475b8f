// Boost's multiprecision headers, alone in a folder that is safe on a wasm include path
// (/usr/include is not).
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { codename, hasApt, newestPackage, withDownloaded } from "./apt.mjs";
import { toolchain } from "./folders.mjs";
import { capture, say, SetUpError } from "./process.mjs";

const oldestVersion = 108000; // BOOST_VERSION of 1.80
const boostInclude = path.join(toolchain, "boost", "include");

function isUsable(include) {
  try {
    const version = /^#define BOOST_VERSION (\d+)/m.exec(
      readFileSync(path.join(include, "boost/version.hpp"), "utf8"),
    )?.[1];
    return (
      Number(version) >= oldestVersion &&
      existsSync(path.join(include, "boost/multiprecision/cpp_int.hpp"))
    );
  } catch {
    return false;
  }
}

/**
 * Copies what cpp_int needs in standalone mode; version.hpp last, because it marks the copy as
 * whole.
 */
function keepHeaders(include) {
  rmSync(boostInclude, { recursive: true, force: true });
  mkdirSync(boostInclude, { recursive: true });
  for (const part of ["multiprecision", "config", "config.hpp", "version.hpp"]) {
    cpSync(path.join(include, "boost", part), path.join(boostInclude, "boost", part), {
      recursive: true,
    });
  }
}

function keepHeadersOfPackage(file) {
  const unpacked = mkdtempSync(path.join(tmpdir(), "apollonius-boost-"));
  try {
    capture("dpkg-deb", ["-x", file, unpacked]);
    keepHeaders(path.join(unpacked, "usr/include"));
  } finally {
    rmSync(unpacked, { recursive: true, force: true });
  }
}

/** The version that comes with the private Emscripten; Debian 12's own are older. */
export const boostOfTrixie = "libboost1.88-dev";

export function keepBoostOfTrixie(file) {
  keepHeadersOfPackage(file);
}

/** Sees to it that the headers are in `boostInclude`. */
export function ensureBoost() {
  if (isUsable(boostInclude)) return;
  say(`Boost's multiprecision headers -> ${boostInclude}`);
  const installed = ["/usr/local/include", "/usr/include"].find(isUsable);
  if (installed) return keepHeaders(installed);
  if (hasApt()) {
    if (codename() === "bookworm") {
      return withDownloaded([boostOfTrixie], { release: "trixie" }, (file) =>
        keepHeadersOfPackage(file(boostOfTrixie)),
      );
    }
    const name = newestPackage("libboost1.", /^libboost1\.(\d+)-dev$/);
    if (name) withDownloaded([name], {}, (file) => keepHeadersOfPackage(file(name)));
  }
  if (!isUsable(boostInclude)) {
    throw new SetUpError(
      "Boost's headers, 1.80 or newer, are needed: please install them (Debian's package" +
        " libboost-dev, or your system's), so that /usr/include/boost or" +
        " /usr/local/include/boost has them.",
    );
  }
}
