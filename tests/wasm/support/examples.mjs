// Runs examples as readers would, and compares what they give with what they say. A comment behind
// a statement is the value of its expression, or of the variable that it declares: as a literal of
// JavaScript; `Uint32Array [1, 2]`; `throws "code"` (of other errors the name); of other objects
// what String() gives. Numbers with decimal places are rounded to these, others are exact; "…" ends
// what is compared, and behind ": " come words.
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";
import { rewritten } from "../../../tools/example_statements.mjs";
import { capture } from "../../../tools/toolchain/process.mjs";
import { packed } from "./install_packed.mjs";

const folder = path.join(packed, "examples");
const runner = fileURLToPath(new URL("run_examples.mjs", import.meta.url));

/** The code with `show(what the statement gives, comment)` for each comment behind a statement. */
const instrumented = (code) =>
  rewritten(code, ({ text, value, isDeclared, said }) => {
    if (value === undefined)
      throw new Error(`a comment behind a statement without a value: ${text}`);
    const shown = `await show(async () => [${value}], ${JSON.stringify(said)});`;
    return isDeclared ? `${text} ${shown}` : shown;
  });

/** Node 20 does not read `using`. */
function forThisNode(code) {
  if (!/\busing\b/.test(code)) return code;
  const { ES2022: target, ESNext: module } = { ...ts.ScriptTarget, ...ts.ModuleKind };
  return ts.transpileModule(code, { compilerOptions: { target, module } }).outputText;
}

/**
 * Runs modules, each with the code that its file begins with, one after another in one process.
 * @param {{ setUp: string, code: string }[]} examples
 * @returns {{ results: { said: string, text: string }[], error?: string }[]} what each comment says
 *   and what its statement gives
 */
export function runExamples(examples) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const [k, { setUp, code }] of examples.entries())
    writeFileSync(path.join(folder, `${k}.mjs`), forThisNode(`${setUp}\n${instrumented(code)}`));
  const output = capture(process.execPath, [runner, folder, examples.length], {
    cwd: packed,
    env: { NODE_OPTIONS: "" },
  });
  return JSON.parse(output);
}

/** The value in a comment: what is before ": ", but for that in quotes and brackets. */
export function valueIn(said) {
  let depth = 0;
  let isQuoted = false;
  for (const [k, sign] of [...said].entries()) {
    if (sign === '"') isQuoted = !isQuoted;
    else if (isQuoted) continue;
    else if ("[{".includes(sign)) ++depth;
    else if ("]}".includes(sign)) --depth;
    else if (depth === 0 && said.startsWith(": ", k)) return said.slice(0, k);
  }
  return said;
}

const kNumber = /-?\d+(?:\.\d+)?(?:e[+-]?\d+)?/g;

/** Writes the value of a statement as the comment does. */
export function writtenAs(value, text) {
  const numbers = value.match(kNumber) ?? [];
  let k = 0;
  const rounded = text.replace(kNumber, (number) => {
    const [, decimals] = /\.(\d+)$/.exec(numbers[k++] ?? "") ?? [];
    return decimals ? Number(number).toFixed(decimals.length) : number;
  });
  const at = value.indexOf("…");
  return at < 0 ? rounded : rounded.slice(0, at) + value.slice(at);
}
