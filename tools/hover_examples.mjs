// Examples in the declarations of dist/: below what an editor says of a call, the first block of
// code that docs/examples has for it.
import ts from "typescript";
import { readExamples } from "./examples.mjs";

/** Declarations that hold calls of a class under another name. */
const classOf = { SurfaceCalls: "Diagram", DynamicDiagram: "Diagram", DiagramClass: "Diagram" };

/** The name of a member, or of a function, in docs/examples. */
function callOf(node) {
  if (ts.isFunctionDeclaration(node)) return `function ${node.name.text}`;
  const own = node.parent.name?.text ?? "";
  const name = classOf[own] ?? own;
  if (ts.isConstructorDeclaration(node) || ts.isConstructSignatureDeclaration(node))
    return `new ${name}`;
  const isStatic =
    own === "DiagramClass" ||
    node.modifiers?.some((one) => one.kind === ts.SyntaxKind.StaticKeyword);
  const object = isStatic ? name : name.charAt(0).toLowerCase() + name.slice(1);
  const member = node.name?.getText() ?? "";
  return member.startsWith("[") ? `${object}${member}` : `${object}.${member}`;
}

/** The comment, as lines without its marks, followed by the code. */
function withExample(comment, code, indent) {
  const said = comment
    .replace(/^\/\*\*\s?|\s*\*\/$/g, "")
    .split("\n")
    .map((line) => line.replace(/^\s*\* ?/, ""))
    .filter((line, k) => k > 0 || line !== "");
  const lines = [...said, "@example", ...code.trimEnd().split("\n")];
  return ["/**", ...lines.map((line) => ` * ${line}`.trimEnd()), " */"].join(`\n${indent}`);
}

/** Adds examples to the text of a declaration file. */
export function examplesAdded(name, text, examples = codeByCall()) {
  const source = ts.createSourceFile(name, text, ts.ScriptTarget.ES2022, true);
  const changes = [];
  const visit = (node) => {
    const doc = node.jsDoc?.at(-1);
    const isCall =
      ts.isFunctionDeclaration(node) || ts.isClassElement(node) || ts.isTypeElement(node);
    const code = doc && isCall ? examples.get(callOf(node)) : undefined;
    // A star and a slash in code would end the comment.
    if (code !== undefined && !code.includes("*/")) changes.push([doc.getStart(), doc.end, code]);
    ts.forEachChild(node, visit);
  };
  visit(source);
  for (const [from, to, code] of changes.reverse()) {
    const indent = /[^\n]*$/.exec(text.slice(0, from))[0];
    text = text.slice(0, from) + withExample(text.slice(from, to), code, indent) + text.slice(to);
  }
  return text;
}

/** The first block of each call of docs/examples. */
function codeByCall() {
  const found = new Map();
  for (const { examples } of readExamples())
    for (const { calls, codes } of examples)
      for (const call of calls) if (codes.length > 0 && !found.has(call)) found.set(call, codes[0]);
  return found;
}
