// Emscripten: the user's own if it is on PATH and new enough, else the distribution's if new
// enough, else on Debian 12 a private copy of the next Debian's (bookworm.mjs).
import { existsSync, readFileSync, realpathSync } from "node:fs";
import path from "node:path";
import { candidate, codename, ensureInstalled, hasApt } from "./apt.mjs";
import { ensureBookwormEmscripten, privateEmscripten } from "./bookworm.mjs";
import { compareVersions, oldestEmscripten } from "./folders.mjs";
import { SetUpError, which } from "./process.mjs";

/** The folder that holds emcc.py and cmake/, if `emcc` is one and new enough; else null. */
function usableRoot(emcc) {
  if (emcc === null || !existsSync(emcc)) return null;
  const folder = path.dirname(realpathSync(emcc));
  try {
    const version = JSON.parse(
      readFileSync(path.join(folder, "emscripten-version.txt"), "utf8")
        .trim()
        .replace(/^([^"].*)$/, '"$1"'),
    );
    return compareVersions(version, oldestEmscripten) >= 0 ? folder : null;
  } catch {
    return null;
  }
}

/** Sees to it that there is an Emscripten; returns its folder. */
export function ensureEmscripten() {
  const onPath = usableRoot(which("emcc"));
  if (onPath) return onPath;
  if (hasApt() && codename() === "bookworm") {
    ensureBookwormEmscripten();
    return privateEmscripten;
  }
  const version = hasApt() ? candidate("emscripten") : null;
  if (version !== null && compareVersions(version, oldestEmscripten) >= 0) {
    ensureInstalled(["emscripten"], "WebAssembly");
    const installed = usableRoot("/usr/bin/emcc");
    if (installed) return installed;
  }
  throw new SetUpError(
    `Emscripten ${oldestEmscripten} or newer is needed and cannot be installed from here: please` +
      " install the Emscripten SDK (emsdk), run its `emsdk_env.sh` so that `emcc` is on" +
      " PATH, and try again.",
  );
}

/** The toolchain file for `cmake -DCMAKE_TOOLCHAIN_FILE=`. */
export function cmakeToolchainFile(emscripten) {
  return path.join(emscripten, "cmake/Modules/Platform/Emscripten.cmake");
}
