// clang++ with libFuzzer and the sanitizers' runtime, for fuzzing.
import { ensureInstalled, newestPackage } from "./apt.mjs";
import { capture, SetUpError, succeeds, which } from "./process.mjs";

const versions = Array.from({ length: 30 }, (_, k) => 40 - k); // 40 … 11

/** Has this clang++ libFuzzer's runtime? */
function hasRuntime(program) {
  return succeeds("sh", [
    "-c",
    `echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long)` +
      ` { return 0; }' |` +
      ` "$1" -x c++ - -fsanitize=fuzzer,address,undefined -o /dev/null`,
    "sh",
    program,
  ]);
}

function find() {
  return (
    ["clang++", ...versions.map((version) => `clang++-${version}`)]
      .filter((name) => which(name))
      .find(hasRuntime) ?? null
  );
}

/** The name of a clang++ that links with -fsanitize=fuzzer. */
export function ensureFuzzingClang() {
  const there = find();
  if (there) return there;
  const newest = newestPackage("clang-", /^clang-(\d+)$/);
  const version = /\d+/.exec(newest ?? "")?.[0];
  if (!version)
    throw new SetUpError(
      "no clang++ with libFuzzer: none is installed, and apt has no package clang-<version>",
    );
  const runtime = `libclang-rt-${version}-dev`;
  // Before version 14 it is part of another package.
  const isThere = capture("apt-cache", ["pkgnames", runtime]).split("\n").includes(runtime);
  ensureInstalled(
    [`clang-${version}`, isThere ? runtime : `libclang-common-${version}-dev`],
    "fuzzing",
  );
  const found = find();
  if (!found)
    throw new SetUpError(`clang-${version} is installed, but cannot link with -fsanitize=fuzzer`);
  return found;
}
