// A recipe in Markdown: a block of code with the tag `js recipe`, below a heading that says what it
// is for. It becomes a card, in which readers can change the program and run it
// (web/recipes/cards.ts).

/** The text of the last heading before a token. */
function titleBefore(tokens, index) {
  for (let k = index; k >= 0; k--)
    if (tokens[k].type === "heading_open") return tokens[k + 1].content;
  throw new Error("a recipe has no heading");
}

const cardHtml = (title, code, escaped) => `<div class="recipe">
<div class="program">
<textarea aria-label="Program: ${escaped(title)}" rows="${code.split("\n").length}" wrap="off"
 spellcheck="false" autocapitalize="off" autocomplete="off">
${escaped(code)}</textarea>
<div class="controls"><button type="button" class="run">Run</button>
<button type="button" class="reset">Reset</button>
<button type="button" class="copy-page">Copy as one HTML file</button>
<small>or Ctrl + Enter</small></div>
</div>
<div class="result"></div>
</div>
`;

/** A plugin for markdown-it. */
export function recipes(markdown) {
  const { fence } = markdown.renderer.rules;
  markdown.renderer.rules.fence = (tokens, k, ...rest) => {
    const { info, content } = tokens[k];
    if (info.trim() !== "js recipe") return fence(tokens, k, ...rest);
    return cardHtml(titleBefore(tokens, k), content.trimEnd(), markdown.utils.escapeHtml);
  };
}
