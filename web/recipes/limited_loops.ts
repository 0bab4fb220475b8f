// Loops that end: each turn of a program's loops begins with a call of `$turn`, which frame.js
// defines, and which throws once loops have run for too long without a pause. Nothing outside could
// stop them: a browser may run the sandbox in the page's own process, and a worker, which can be
// ended, has no document to show anything in.
import { type Node, parse } from "acorn";
import { simple } from "acorn-walk";

/** A program whose loops call `$turn(line)`; its lines stay. As it is, if it has syntax errors. */
export function withLimitedLoops(program: string): string {
  let tree: Node;
  try {
    tree = parse(program, { ecmaVersion: "latest", sourceType: "module", locations: true });
  } catch {
    return program; // the browser says what is wrong
  }
  const inserted: { at: number; text: string }[] = [];
  const limit = (loop: Node & { body: Node }) => {
    const { body } = loop;
    inserted.push({ at: body.start, text: `{$turn(${loop.loc?.start.line});` });
    inserted.push({ at: body.end, text: "}" });
  };
  simple(tree, {
    ForStatement: limit,
    ForInStatement: limit,
    ForOfStatement: limit,
    WhileStatement: limit,
    DoWhileStatement: limit,
  });
  inserted.sort((a, b) => a.at - b.at);
  let text = "";
  let done = 0;
  for (const one of inserted) {
    text += program.slice(done, one.at) + one.text;
    done = one.at;
  }
  return text + program.slice(done);
}
