// Where things are.
import { homedir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");

/**
 * Tools of this project's own, outside the clone so that a second clone finds them.
 * cmake/FindBoostMultiprecision.cmake looks in the same place.
 */
export const toolchain =
  process.env.APOLLONIUS_TOOLCHAIN ??
  path.join(
    process.env.XDG_CACHE_HOME ?? path.join(homedir(), ".cache"),
    "apollonius-diagram",
    "toolchain",
  );

/** The oldest Emscripten that the project is known to work with. */
export const oldestEmscripten = "3.1.69";

/** Compares dotted version numbers; like a comparison function of sort. */
export function compareVersions(a, b) {
  const [left, right] = [a, b].map((version) => version.split(/[^0-9]+/).map(Number));
  for (let k = 0; k < 3; ++k) {
    const difference = (left[k] ?? 0) - (right[k] ?? 0);
    if (difference !== 0) return difference;
  }
  return 0;
}
