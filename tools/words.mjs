// The words that sources and documents avoid, because a reader has to guess what they mean:
// `npm run lint` names each place.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "./toolchain/folders.mjs";
import { capture } from "./toolchain/process.mjs";

const avoided = [
  [/\b(that|which) (is|are) none\b/i, "say what it is, or that it is invalid"],
  [/\bturned out to be none\b/i, "say what it is not"],
  [
    /\b(bytes?|snapshots?|lengths?|data|graphs?) (that |which )?(lie|lies|lied|lying)\b(?! in)/i,
    "say wrong or invalid",
  ],
  [/\bdoors?\b/i, "name the interface or the file"],
  [/\blodgers?\b/i, "say ring within a cell"],
  [/\bhad better\b/i, "say what to do"],
  [/\bso many (?!that)\w+/i, "say `this many`, or name the number"],
  [/\bwhose \w+ (it|that|they) (is|are)\b/i, "turn the sentence round"],
  [
    /^\s*(\/\/+<?|\*|\/\*\*) (Of|What|Whose|Whoever|The same|But for)\b/,
    "begin with a verb or a noun: Returns, Length of, As above",
  ],
];

/** Files of git's that people read and we write: no data, results, lock files. */
function readable() {
  return capture("git", ["ls-files", "-co", "--exclude-standard"], { cwd: root })
    .split("\n")
    .filter((file) => /\.(h|cpp|ts|js|mjs|cmake|md|html)$/.test(file))
    .filter((file) => file !== "tools/words.mjs" && !file.startsWith("bench/results/"));
}

/** The places with an avoided word, as "file:line: word: what to say". */
export function avoidedWords() {
  return readable().flatMap((file) => {
    let text;
    try {
      text = readFileSync(path.join(root, file), "utf8");
    } catch {
      return []; // deleted, and git still lists it
    }
    return text.split("\n").flatMap((line, k) =>
      avoided
        .map(([pattern, advice]) => [pattern.exec(line)?.[0], advice])
        .filter(([word]) => word !== undefined)
        .map(([word, advice]) => `${file}:${k + 1}: "${word}": ${advice}`),
    );
  });
}
