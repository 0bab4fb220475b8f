// The examples of docs/examples: docs/API.md shows them (api_reference.mjs), and
// tests/wasm/examples.test.mjs runs them.
//
// A file is about one part of the reference, which its first line names. Then comes what all of its
// examples begin with, if they share something, and below the heading of a call what shows how to
// use it. A heading with several calls, ", " between them, is about them all.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { root } from "./toolchain/folders.mjs";

const folder = path.join(root, "docs/examples");
const kTitle = /^# Examples: (.+) of `(.+)`\n/;

/** The blocks of code in a piece of Markdown. */
const codeIn = (text) => [...text.matchAll(/^```js\n([\s\S]*?)^```$/gm)].map(([, code]) => code);

/**
 * The files, each as { file, entry, part, setUp, examples }: the entry of the package and the
 * part of its reference that the examples are about, the code that they share (or ""), and the
 * examples as { calls, text, codes }.
 */
export function readExamples() {
  const files = readdirSync(folder).filter((name) => name.endsWith(".md"));
  return files.sort().map((name) => {
    const file = `docs/examples/${name}`;
    const [head, ...sections] = readFileSync(path.join(root, file), "utf8").split(/^## /m);
    const title = kTitle.exec(head);
    if (!title) throw new Error(`${file}: the first line is not "# Examples: … of \`entry\`"`);
    const [, part, entry] = title;
    const examples = sections.map((section) => {
      const [, heading, text] = /^(.*)\n([\s\S]*)$/.exec(section);
      return { calls: heading.split(", "), text: text.trim(), codes: codeIn(text) };
    });
    return { file, entry, part, setUp: codeIn(head)[0] ?? "", examples };
  });
}
