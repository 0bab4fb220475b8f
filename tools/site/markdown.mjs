// Markdown to HTML: prose, code with its colours, figures, addresses.
//
// A figure is a paragraph of its own, an image whose address is the figure's name and whose text is
// its caption: ![Two circles, and where both are equally near.](figure:two_circles). Its first
// picture, if it is the first of a page, is drawn where the site is built.
import GithubSlugger from "github-slugger";
import hljs from "highlight.js";
import MarkdownIt from "markdown-it";
import { recipes } from "./recipes.mjs";

const escaped = (text) => MarkdownIt().utils.escapeHtml(text);

function highlight(code, language) {
  if (!hljs.getLanguage(language)) return escaped(code);
  return hljs.highlight(code, { language }).value;
}

const markdown = new MarkdownIt({ html: true, linkify: false, highlight }).use(recipes);

markdown.core.ruler.push("anchors", ({ tokens, env }) => {
  const slugger = new GithubSlugger(); // so that links in documents lead there, too
  const given = env.anchors?.values();
  for (const [k, token] of tokens.entries()) {
    if (token.type !== "heading_open") continue;
    const text = tokens[k + 1].children.map(({ content }) => content).join("");
    token.attrSet("id", given?.next().value ?? slugger.slug(text));
  }
});

const kFigure = /<p><img src="figure:(\w+)" alt="([^"]*)"><\/p>/g;

/** A figure before its script has come: its first picture, if there is one, and its caption. */
function figureHtml(name, caption, poster) {
  return `<figure data-figure="${name}" id="${name}">
<div class="stage" role="group" aria-label="${caption}">${poster}</div>
<figcaption>${caption}</figcaption>
</figure>`;
}

const kCode =
  /<pre><code class="language-(\w+)">([\s\S]*?)<\/code><\/pre>(<template[\s\S]*?<\/template>)?/g;
const codeHtml = (language, code, program) =>
  `<div class="code"><pre tabindex="0"><code class="language-${language}">${code}</code></pre>` +
  '<button type="button" class="copy" data-pagefind-ignore>Copy</button>' +
  (program ? `<button type="button" class="run" data-pagefind-ignore>Run</button>${program}` : "") +
  "</div>";

/**
 * @param {{
 *   address?: (target: string) => string, anchors?: string[], programs?: Map<string, string>
 * }} page
 *   `address` turns a link of a document of docs/ into one of the site, or says by null that there
 *   is nothing to lead to; `anchors` are those of its headings; `programs` are what its blocks of
 *   code run, by their text
 * @param {string} text Markdown
 * @param {Map<string, string>} posters first pictures, by the name of the figure
 */
export function htmlOf(page, text, posters) {
  const html = markdown
    .render(text, { anchors: page.anchors, programs: page.programs })
    .replace(kFigure, (_, name, caption, at, all) => {
      // The first figure of a page is seen before its script has come, on phones too.
      const isFirst = !all.slice(0, at).includes('<img src="figure:');
      const kinds = isFirst ? ["wide", "narrow"] : ["wide"];
      const poster = kinds.map((kind) => posters.get(`${name}-${kind}`) ?? "").join("");
      return figureHtml(name, caption, poster);
    })
    .replace(kCode, (_, language, code, program) => codeHtml(language, code, program))
    .replaceAll("<pre><code>", '<pre tabindex="0"><code>')
    .replaceAll("<th></th>", "<td></td>")
    .replaceAll("<table>", '<div class="table" tabindex="0"><table>')
    .replaceAll("</table>", "</table></div>");
  const { address } = page;
  if (!address) return html;
  return html
    .replace(/<a href="([^"#][^"]*)">([\s\S]*?)<\/a>/g, (_, target, text) => {
      const href = address(target);
      return href ? `<a href="${href}">${text}</a>` : text;
    })
    .replace(/<img src="([^"]+)"/g, (_, target) => `<img src="${address(target)}"`);
}
