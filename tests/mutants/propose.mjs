// Proposes mutants: one change of one line each, spread evenly over the files of src/, the same
// ones every time for the same sources.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";

// Patterns of a line, and what each becomes.
const changes = [
  [/ < /, " <= "],
  [/ <= /, " < "],
  [/ > /, " >= "],
  [/ >= /, " > "],
  [/ == /, " != "],
  [/ != /, " == "],
  [/ && /, " || "],
  [/ \|\| /, " && "],
  [/ \+ /, " - "],
  [/ - /, " + "],
  [/ \* /, " + "],
  [/\+ 1\b/, "+ 2"],
  [/- 1\b/, "- 2"],
  [/\bif \((?!constexpr)(.*)\) return/, "if (!($1)) return"],
  [/\btrue\b/, "false"],
  [/\bfalse\b/, "true"],
  [/std::max\b/, "std::min"],
  [/std::min\b/, "std::max"],
  [/kPositive/, "kNegative"],
  [/rotateCcw/, "rotateCw"],
  [/\bnext\(/, "previous("],
  [/\bprevious\(/, "next("],
  [/kUnitRoundoff/, "0"],
  [/^([a-z]\w*(?:\.|->)?\w*\([^=]*\));$/, ";"],
];

const isCode = (line) =>
  !/^(\/\/|#|\*|static_assert|namespace|using|template|inline constexpr)/.test(line) &&
  !/^(friend|case|return;|\[\[)/.test(line) &&
  !/\btemplate\b|operator|include|std::fprintf|invariant\(/.test(line);

function mutantsOf(root, file) {
  const lines = readFileSync(path.join(root, file), "utf8")
    .split("\n")
    .map((line) => line.trim());
  const found = [];
  for (const line of lines) {
    if (!isCode(line) || lines.filter((other) => other === line).length !== 1) continue;
    const [code, comment = ""] = line.split(/(?=\s*\/\/)/, 2);
    for (const [pattern, becomes] of changes) {
      if (pattern.test(code))
        found.push({ file, line, becomes: code.replace(pattern, becomes) + comment });
    }
  }
  return found;
}

export function proposals(root, count) {
  const files = readdirSync(path.join(root, "src"), { recursive: true })
    .map((name) => path.join("src", name).replaceAll("\\", "/"))
    .filter((name) => /\.(cpp|h)$/.test(name))
    .sort();
  const perFile = files
    .map((file) => mutantsOf(root, file))
    .filter((mutants) => mutants.length > 0);
  // long files get more, but not in proportion
  const share = count / perFile.reduce((sum, mutants) => sum + Math.sqrt(mutants.length), 0);
  return perFile.flatMap((mutants) => {
    const wanted = Math.min(
      mutants.length,
      Math.max(1, Math.round(share * Math.sqrt(mutants.length))),
    );
    return Array.from(
      { length: wanted },
      (_, k) => mutants[Math.floor(((k + 0.5) * mutants.length) / wanted)],
    );
  });
}
