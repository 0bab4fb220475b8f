// Programs that end: each turn of a loop and each call of a function begins with a call of `$turn`,
// which frame.js defines, and which throws once the program has computed for too long without a
// pause. Nothing outside could stop it: a browser may run the sandbox in the page's own process,
// and a worker, which can be ended, has no document to show anything in.
import {
  type AnonymousFunctionDeclaration,
  type Function as AnyFunction,
  type Node,
  parse,
} from "acorn";
import { simple } from "acorn-walk";

/** A program that calls `$turn(line)`; its lines stay. As it is, if it has syntax errors. */
export function withLimitedTime(program: string): string {
  let tree: Node;
  try {
    tree = parse(program, { ecmaVersion: "latest", sourceType: "module", locations: true });
  } catch {
    return program; // the browser says what is wrong
  }
  const inserted: { at: number; text: string }[] = [];
  const surround = ({ start, end }: Node, before: string, after: string) => {
    inserted.push({ at: start, text: before }, { at: end, text: after });
  };
  const turnOf = (node: Node) => `$turn(${node.loc?.start.line})`;
  const loop = (node: Node & { body: Node }) => surround(node.body, `{${turnOf(node)};`, "}");
  const call = (node: AnyFunction | AnonymousFunctionDeclaration) => {
    if (node.body.type !== "BlockStatement") surround(node.body, `(${turnOf(node)},`, ")");
    else inserted.push({ at: node.body.start + 1, text: `${turnOf(node)};` });
  };
  simple(tree, {
    ForStatement: loop,
    ForInStatement: loop,
    ForOfStatement: loop,
    WhileStatement: loop,
    DoWhileStatement: loop,
    Function: call,
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
