// C++ as a sequence of tokens, so that a mutant finds its place however the source is laid out.

const token = new RegExp(
  [
    /\/\/[^\n]*|\/\*[\s\S]*?\*\//, // comments, which are left out
    /"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'/,
    /[A-Za-z_]\w*/,
    /\.?\d(?:[eEpP][+-]|'?[\w.])*/,
    // >> as > >: it closes two lists of template arguments
    /::|->|<<=|>>=|<<|<=|>=|==|!=|&&|\|\||\+\+|--|[-+*/%&|^]=|\S/,
  ]
    .map((part) => part.source)
    .join("|"),
  "g",
);

/** Tokens with their places: { text, begin, end }. */
export function tokensOf(source) {
  const tokens = [];
  for (const match of source.matchAll(token)) {
    if (/^\/[/*]/.test(match[0])) continue;
    tokens.push({ text: match[0], begin: match.index, end: match.index + match[0].length });
  }
  return tokens;
}

/** Does not depend on layout or comments. */
export const normalized = (source) =>
  tokensOf(source)
    .map(({ text }) => text)
    .join(" ");

/** Index of the token where `pattern` starts in `tokens`; throws unless it is there once. */
export function placeOf(pattern, tokens, where) {
  const places = [];
  for (let k = 0; k + pattern.length <= tokens.length; ++k) {
    if (pattern.every(({ text }, n) => tokens[k + n].text === text)) places.push(k);
  }
  const shown = pattern.map(({ text }) => text).join(" ");
  if (places.length !== 1) throw new Error(`${where} has ${places.length} places with: ${shown}`);
  return places[0];
}
