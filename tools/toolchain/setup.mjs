// Everything that a build needs, installed where it is missing: fast when nothing is.
//
//   node tools/toolchain/setup.mjs [PART]...
//   PART: boost, emscripten, native, browser, firefox, redis, npm (all by default)
import { pathToFileURL } from "node:url";
import { ensureBoost } from "./boost.mjs";
import { ensureChromium, ensureFirefox } from "./browser.mjs";
import { ensureEmscripten } from "./emscripten.mjs";
import { ensureCmake, ensureNativeTools } from "./native.mjs";
import { ensureNpmPackages } from "./npm_packages.mjs";
import { SetUpError } from "./process.mjs";
import { ensureRedis } from "./redis.mjs";

/** Installs the tools that build the package; returns Emscripten's folder. */
export function ensureBuildTools() {
  ensureNpmPackages();
  ensureCmake();
  const emscripten = ensureEmscripten();
  ensureBoost();
  return emscripten;
}

/**
 * Runs a script's main function; failures that the user can act on are printed without a stack
 * trace.
 */
export async function main(action) {
  try {
    await action();
  } catch (error) {
    console.error(error instanceof SetUpError ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}

const parts = {
  npm: ensureNpmPackages,
  native: ensureNativeTools,
  emscripten: ensureEmscripten,
  boost: ensureBoost,
  browser: ensureChromium,
  firefox: ensureFirefox,
  redis: ensureRedis,
};

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await main(() => {
    const wanted = process.argv.slice(2);
    for (const part of wanted.length > 0 ? wanted : Object.keys(parts)) {
      if (!parts[part])
        throw new SetUpError(`unknown part ${part}: expected ${Object.keys(parts).join(", ")}`);
      console.log(`${part}: ${parts[part]() ?? "ready"}`);
    }
  });
}
