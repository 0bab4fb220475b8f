// Statements of examples (examples.mjs) that have a comment behind them, which says what they give.
import ts from "typescript";

/**
 * `value` is the statement's expression, or the variable that it declares; `said` is the comment.
 * @typedef {{ text: string, value?: string, isDeclared: boolean, said: string }} Statement
 */

/**
 * The code, in which `write` has written these statements anew. The comments stay.
 * @param {string} code
 * @param {(statement: Statement) => string} write
 */
export function rewritten(code, write) {
  const { statements } = ts.createSourceFile("example.js", code, ts.ScriptTarget.Latest, true);
  let made = "";
  let at = 0;
  for (const statement of statements) {
    const [comment] = ts.getTrailingCommentRanges(code, statement.end) ?? [];
    if (!comment) continue;
    const text = statement.getText();
    const declared = statement.declarationList?.declarations[0].name.getText();
    const value = declared ?? statement.expression?.getText();
    const said = code.slice(comment.pos, comment.end).replace(/^\/\/ /, "");
    made += code.slice(at, statement.getStart());
    made += write({ text, value, isDeclared: declared !== undefined, said });
    at = statement.end;
  }
  return made + code.slice(at);
}
