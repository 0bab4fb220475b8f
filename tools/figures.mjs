// Measured figures: docs/figures.json, which the commands that measure write (`npm run bench`,
// `mutants`, `coverage`, `fuzz`), each with its date and the commit that it measured; and the
// quotations of them in documents.
//
//   npm run figures      brings the quotations up to date
//
// In a document: <!--figure:bench.build.wasm-->1.53<!--end-->. A test names the quotations that
// differ from the file.
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { root } from "./toolchain/folders.mjs";
import { capture, SetUpError } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";

const file = path.join(root, "docs/figures.json");
export const kQuotingDocuments = ["README.md", "web/pages/home.md", "web/pages/comparison.md"];

export const readFigures = () => JSON.parse(readFileSync(file, "utf8"));

/** The commit that is measured, and whether sources differ from it. */
export function measuredCommit() {
  const hash = capture("git", ["rev-parse", "--short", "HEAD"], { cwd: root }).trim();
  const paths = ["src", "wasm", "tests", "bench", "package.json"];
  const changes = capture("git", ["status", "--porcelain", "--", ...paths], { cwd: root });
  return hash + (changes.trim() === "" ? "" : " and uncommitted changes");
}

/**
 * Replaces a command's figures by those that it has measured.
 * @param {string} command @param {object | ((before: any) => object)} measured the figures, or how
 * they follow from those before
 */
export function recordFigures(command, measured) {
  const all = readFigures();
  const own = typeof measured === "function" ? measured(all[command]) : measured;
  const date = new Date().toISOString().slice(0, 10);
  all[command] = { date, commit: measuredCommit(), ...own };
  writeFileSync(`${file}.new`, `${JSON.stringify(all, null, 2)}\n`);
  renameSync(`${file}.new`, file);
}

/** Whole numbers in groups of three, others with three digits, texts as they are. */
function shown(value) {
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value)) return value.toLocaleString("en").replaceAll(",", " ");
  return value.toPrecision(3);
}

/** A document with its quotations as the figures are. */
export function quoted(text, figures, name) {
  return text.replace(/<!--figure:([\w.-]+)-->.*?<!--end-->/g, (_, key) => {
    const value = key.split(".").reduce((inner, part) => inner?.[part], figures);
    if (value === undefined) throw new SetUpError(`${name}: docs/figures.json has no ${key}`);
    return `<!--figure:${key}-->${shown(value)}<!--end-->`;
  });
}

/** Documents whose quotations are not up to date; brings them up to date if `write`. */
export function updateQuotations({ write }) {
  const figures = readFigures();
  return kQuotingDocuments.filter((name) => {
    const place = path.join(root, name);
    const text = readFileSync(place, "utf8");
    const now = quoted(text, figures, name);
    if (write && now !== text) writeFileSync(place, now);
    return now !== text;
  });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  await main(() => {
    const changed = updateQuotations({ write: true });
    console.log(changed.length > 0 ? `Updated ${changed.join(", ")}` : "All are up to date.");
  });
