// Scripts run in a Node of their own, in the folder where the packed package is installed.
import { capture } from "../../../tools/toolchain/process.mjs";
import { packed } from "./install_packed.mjs";

/** Returns what an ES module prints, without the last newline. */
export function runInNode(source, options = []) {
  return capture(process.execPath, [...options, "--input-type=module", "--eval", source], {
    cwd: packed,
    env: cleanEnv,
  }).trimEnd();
}

/** Returns what a CommonJS script prints, without the last newline. */
export function runScriptInNode(source, options = []) {
  return capture(process.execPath, [...options, "--input-type=commonjs", "--eval", source], {
    cwd: packed,
    env: cleanEnv,
  }).trimEnd();
}

const cleanEnv = { NODE_OPTIONS: "" };
