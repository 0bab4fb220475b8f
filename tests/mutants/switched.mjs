// Puts all mutants into the sources at once, each behind a switch of its own: one build serves all
// of them, and the environment says which one is on (switch.h). What becomes
//
//     an expression   `a < b`    (mutants::isOn(17) ? (a <= b) : (a < b))
//     a statement     `f(x);`    { if (mutants::isOn(17)) { g(x); } else { f(x); } }
//
// the second where the statement is dropped, or more than an expression changes.
// An expression is what stands between brackets, commas, semicolons, assignments or `return`. What
// must be known when it is compiled (constexpr variables, template arguments) cannot be switched:
// no mutants of such lines.
import { placeOf, tokensOf } from "./tokens.mjs";

const openers = new Set(["(", "[", "{"]),
  closers = new Set([")", "]", "}"]);
const borders = new Set([
  ",",
  ";",
  "=",
  "?",
  ":",
  "+=",
  "-=",
  "*=",
  "/=",
  "%=",
  "&=",
  "|=",
  "^=",
  "<<=",
  "return",
  "else",
  "do",
]);
const statementWords = new Set([
  "if",
  "for",
  "while",
  "return",
  "continue",
  "break",
  "const",
  "throw",
  "auto",
  "case",
]);

/** The number of closing brackets that were opened before the tokens, and of those left open. */
function unmatched(tokens) {
  let closed = 0,
    open = 0;
  for (const { text } of tokens) {
    if (openers.has(text)) ++open;
    if (!closers.has(text)) continue;
    if (open > 0) --open;
    else ++closed;
  }
  return { closed, open };
}

/** Is there a comma outside of all brackets? */
function hasComma(tokens) {
  let depth = 0;
  return tokens.some(({ text }) => {
    depth += openers.has(text) - closers.has(text);
    return text === "," && depth === 0;
  });
}

/**
 * Grows [begin, end) to the expression around it; `closed`, `open`: brackets of the range whose
 * partners are outside.
 */
function expressionAround(tokens, begin, end, { closed, open }) {
  let depth = 0;
  while (begin > 0) {
    const { text } = tokens[begin - 1];
    if (depth === 0 && closed === 0 && (openers.has(text) || text === "}" || borders.has(text)))
      break;
    if (closers.has(text)) ++depth;
    if (openers.has(text) && depth-- === 0) {
      depth = 0;
      --closed;
    }
    --begin;
  }
  for (depth = 0; end < tokens.length; ++end) {
    const { text } = tokens[end];
    if (depth === 0 && open === 0 && (closers.has(text) || borders.has(text))) break;
    if (openers.has(text)) ++depth;
    if (closers.has(text) && depth-- === 0) {
      depth = 0;
      --open;
    }
  }
  return [begin, end];
}

/**
 * Where the mutant is in the file's text, what becomes of it there, and whether that is a
 * statement.
 */
function change(mutant, number, source, tokens) {
  const from = tokensOf(mutant.line),
    to = tokensOf(mutant.becomes);
  const first = placeOf(from, tokens, mutant.file),
    last = first + from.length;
  const textOf = (begin, end) => source.slice(tokens[begin].begin, tokens[end - 1].end);
  let same = 0,
    sameAtEnd = 0;
  while (same < Math.min(from.length, to.length) && from[same].text === to[same].text) ++same;
  while (
    sameAtEnd < Math.min(from.length, to.length) - same &&
    from.at(-1 - sameAtEnd).text === to.at(-1 - sameAtEnd).text
  )
    ++sameAtEnd;
  const gone = unmatched(from.slice(same, from.length - sameAtEnd)),
    come = unmatched(to.slice(same, to.length - sameAtEnd));
  const outside = {
    closed: Math.max(gone.closed, come.closed),
    open: Math.max(gone.open, come.open),
  };
  let begin, end;
  do {
    [begin, end] = expressionAround(tokens, first + same, last - sameAtEnd, outside);
    // several arguments, or a list of them: take the call
    ++outside.closed;
    ++outside.open;
  } while (hasComma(tokens.slice(begin, end)) || tokens[begin]?.text === "{");
  const isStatement =
    mutant.becomes === ";" ||
    (mutant.becomes.endsWith(";") && sameAtEnd === 0) ||
    begin === end ||
    tokens.slice(begin, end).some(({ text }) => statementWords.has(text) || text === ";");
  if (isStatement) {
    return {
      number,
      begin: tokens[first].begin,
      end: tokens[last - 1].end,
      isStatement,
      becomes: mutant.becomes.replace(/\/\/.*/, ""),
    };
  }
  const changed = mutant.becomes.slice(
    to[same]?.begin ?? mutant.becomes.length,
    sameAtEnd < to.length ? to.at(-1 - sameAtEnd).end : 0,
  );
  const before = begin < first + same ? textOf(begin, first + same) : "",
    after = last - sameAtEnd < end ? textOf(last - sameAtEnd, end) : "";
  const middle = same + sameAtEnd < to.length ? changed : "";
  return {
    number,
    begin: tokens[begin].begin,
    end: tokens[end - 1].end,
    isStatement,
    becomes: `${before} ${middle} ${after}`,
  };
}

/**
 * Text from `begin` to `end` with the changes in it, of which the first surround those that follow.
 */
function written(source, begin, end, changes) {
  let text = "",
    at = begin;
  while (changes.length > 0) {
    const [outer, ...rest] = changes;
    const within = rest.filter((other) => other.begin < outer.end);
    if (within.some((other) => other.end > outer.end))
      throw new Error(`mutants overlap: ${outer.becomes}`);
    const unchanged = written(source, outer.begin, outer.end, within),
      isOn = `mutants::isOn(${outer.number})`;
    text +=
      source.slice(at, outer.begin) +
      (outer.isStatement
        ? `{ if (${isOn}) { ${outer.becomes} } else { ${unchanged}\n } }`
        : `(${isOn} ? (${outer.becomes}) : (${unchanged}))`);
    at = outer.end;
    changes = rest.slice(within.length);
  }
  return text + source.slice(at, end);
}

/** `source` with these mutants of one file, [mutant, number], behind their switches. */
export function switched(source, mutants) {
  const tokens = tokensOf(source);
  const changes = mutants.map(([mutant, number]) => change(mutant, number, source, tokens));
  changes.sort((a, b) => a.begin - b.begin || b.end - a.end);
  return written(source, 0, source.length, changes);
}
