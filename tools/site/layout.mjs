// The frame of each page: head, navigation, the way to the next page.
const kPolicy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; " +
  "img-src 'self' data:; connect-src 'self'; worker-src 'self'; frame-src 'self'; " +
  "base-uri 'none'; form-action 'none'";

const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** The relative address of the site's folder from a page's. */
const rootOf = ({ folder }) => (folder === "" ? "./" : "../".repeat(folder.split("/").length));
const linkTo = (root, page) => `${root}${page.folder === "" ? "" : `${page.folder}/`}`;

function navigation(page, pages) {
  const root = rootOf(page);
  const link = (other) => {
    const current = other === page ? ' aria-current="page"' : "";
    return `<a href="${linkTo(root, other)}"${current}>${escaped(other.title)}</a>`;
  };
  const group = (name) => {
    const items = pages.filter((other) => other.group === name);
    const current = page.group === name ? " data-current" : "";
    return `<details class="group"${current}>
<summary>${name}</summary>
<ul>${items.map((other) => `<li>${link(other)}</li>`).join("")}</ul>
</details>`;
  };
  const single = (key) => link(pages.find((other) => other.key === key));
  return `<header class="bar">
<a class="brand" href="${root}">
<img src="${root}icon.svg" alt="" width="24" height="24">Apollonius diagram
</a>
<nav aria-label="Site">
${group("Explained")}
${single("recipes")}
${group("Reference")}
<a href="${root}examples/">Examples</a>
<button type="button" class="search" title="Search ( / )">Search</button>
<a class="primary" href="${root}playground/">Playground</a>
</nav>
</header>`;
}

/** The page before and the page after, where there are some to read one after the other. */
function neighbors(page, pages) {
  const series = pages.filter(({ group }) => group === page.group);
  if (!page.group || series.length < 2 || page.group === "Reference") return "";
  const at = series.indexOf(page);
  const root = rootOf(page);
  const link = (other, word) =>
    other
      ? `<a href="${linkTo(root, other)}"><small>${word}</small>${escaped(other.title)}</a>`
      : "<span></span>";
  return `<nav class="neighbors" aria-label="Next page">
${link(series[at - 1], "Before")}
${link(series[at + 1], "Next")}
</nav>`;
}

/** The list beside a page: open where there is room for it (page.ts). */
const sideHtml = (side) => `<nav class="side" aria-label="Calls"><details>
<summary>Classes, entries, calls</summary>
${side}
</details></nav>
`;

/** Recipes have few words beside their programs, but are what many look for. */
const weightOf = ({ key }) => (key === "recipes" ? ' data-pagefind-weight="4"' : "");

/** @param {string} body HTML of the page */
export function layout(page, body, pages) {
  const root = rootOf(page);
  const title = page.folder === "" ? page.title : `${page.title} · Apollonius diagram`;
  return `<!doctype html>
<html lang="en" data-root="${root}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="${kPolicy}">
<title>${escaped(title)}</title>
<meta name="description" content="${escaped(page.about)}">
<meta property="og:title" content="${escaped(title)}">
<meta property="og:description" content="${escaped(page.about)}">
<meta property="og:type" content="website">
<meta property="og:image" content="${root}card.png">
<meta property="og:image:width" content="1200">
<meta property="og:image:height" content="630">
<link rel="icon" href="${root}icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="/figure/site.css">
<script type="module" src="/figure/page.ts"></script>
</head>
<body class="${page.key === "home" ? "home" : page.side ? "article has-side" : "article"}">
<a class="skip" href="#content">Skip to the text</a>
${navigation(page, pages)}
${page.side ? sideHtml(page.side) : ""}
<main id="content" tabindex="-1" data-pagefind-body${weightOf(page)}>
${body}
${neighbors(page, pages)}
</main>
<footer class="foot"><p>MIT licence · <code>npm install apollonius-diagram</code></p></footer>
</body>
</html>
`;
}
