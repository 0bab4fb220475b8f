// Cards, in which readers can change a program and run it (web/recipes/cards.ts). A recipe in
// Markdown, a block of code with the tag `js recipe`, is one. A block that has a program of its own
// gets one in a template, for when the reader asks (web/figure/reference.ts).

/** The text of the last heading before a token: it says what a program is for. */
function titleBefore(tokens, index) {
  for (let k = index; k >= 0; k--)
    if (tokens[k].type === "heading_open")
      return tokens[k + 1].children.map(({ content }) => content).join("");
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

/** A plugin for markdown-it. The environment's `programs` are by the text of a block. */
export function recipes(markdown) {
  const { fence } = markdown.renderer.rules;
  markdown.renderer.rules.fence = (tokens, k, options, environment, self) => {
    const { info, content } = tokens[k];
    const card = (code) => cardHtml(titleBefore(tokens, k), code, markdown.utils.escapeHtml);
    if (info.trim() === "js recipe") return card(content.trimEnd());
    const html = fence(tokens, k, options, environment, self);
    const program = environment.programs?.get(content);
    if (!program) return html;
    const template = `<template class="program" data-pagefind-ignore>${card(program)}</template>`;
    return html.trimEnd() + template;
  };
}
