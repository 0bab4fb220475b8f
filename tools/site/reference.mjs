// The reference as pages of the site: docs/API.md, a page for each class and each entry, with the
// calls at the side; examples can be run (web/figure/reference.ts). Headings have the anchors that
// they have in docs/API.md.
import { readFileSync } from "node:fs";
import path from "node:path";
import GithubSlugger from "github-slugger";
import { rewritten } from "../example_statements.mjs";
import { readExamples } from "../examples.mjs";
import { root } from "../toolchain/folders.mjs";
import { kSeeAlso } from "./see_also.mjs";

const kFolder = "reference/api";
const kHeading = /^(#{1,4}) (.*)$/;

/** The lines of docs/API.md below each heading: { level, title, anchor, lines }. */
function sections() {
  const slugger = new GithubSlugger();
  const found = [];
  let isCode = false;
  for (const line of readFileSync(path.join(root, "docs/API.md"), "utf8").split("\n")) {
    if (line.startsWith("```")) isCode = !isCode;
    const heading = isCode ? null : kHeading.exec(line);
    if (heading) {
      const title = heading[2].replaceAll("\\<", "<").replaceAll("`", "");
      const level = heading[1].length;
      found.push({ level, title, anchor: slugger.slug(title), heading: line, lines: [] });
    } else found.at(-1)?.lines.push(line);
  }
  return found;
}

const kebab = (name) => name.replace(/(?<=[a-z])[A-Z]/g, "-$&").toLowerCase();

/** The page that a part of the reference is on: a class has one, all else is on its entry's. */
function pageFor({ level, title }, entry) {
  if (level === 2 && title.startsWith("class ")) {
    const name = title.slice("class ".length);
    return { name: kebab(name), title: name, about: `The class ${name}, call by call.` };
  }
  if (level !== 1) return null;
  const of = entry.slice(entry.indexOf("/") + 1);
  return {
    name: of === entry ? "main" : of,
    title: entry,
    about: `Functions and types of the entry ${entry}.`,
  };
}

/** Pages as { name, title, about, sections }, the classes of an entry behind the entry. */
function split() {
  const [overview, ...rest] = sections();
  const pages = [];
  let [ofEntry, current] = [null, null];
  for (const section of rest) {
    const entry = /^Entry (.*)$/.exec(section.title)?.[1];
    const made = pageFor(section, entry);
    if (made) {
      current = { ...made, sections: [] };
      pages.push(current);
      if (section.level === 1) ofEntry = current;
    } else if (section.level === 2) current = ofEntry;
    current.sections.push(section);
  }
  return { overview, pages };
}

/** The code, changed to print each value that a comment behind a statement gives. */
const printing = (code) =>
  rewritten(code, ({ text, value, isDeclared, said }) => {
    if (said.startsWith("throws "))
      return `try {\n  ${text}\n} catch (error) {\n  console.log(String(error));\n}`;
    return `${isDeclared ? `${text}\n` : ""}console.log(${value});`;
  });

/**
 * The programs that readers run for each block of code of the reference, by its text: with what its
 * part begins with.
 */
export function programsByCode() {
  const programs = new Map();
  for (const { setUp, examples } of readExamples()) {
    if (setUp) programs.set(setUp, setUp.trimEnd());
    for (const code of examples.flatMap(({ codes }) => codes))
      programs.set(code, `${setUp}\n${printing(code)}`.trim());
  }
  return programs;
}

const linkList = (items) => `<ul>${items.join("")}</ul>`;
const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** The calls of a page by their group: [group or null, sections][]. */
function callsByGroup({ sections: all }) {
  if (all[0].level === 1) {
    const parts = all.filter(({ level }) => level === 2);
    const isFunction = ({ title }) => title.startsWith("function ");
    return [
      ["Functions", parts.filter(isFunction)],
      ["Types", parts.filter((part) => !isFunction(part))],
    ].filter(([, calls]) => calls.length > 0);
  }
  const groups = [];
  const hasGroups = all.some(({ level }) => level === 4);
  const level = hasGroups ? 4 : 3;
  for (const section of all) {
    if (hasGroups && section.level === 3) groups.push([section.title, []]);
    if (section.level !== level) continue;
    if (groups.length === 0) groups.push([null, []]);
    groups.at(-1)[1].push(section);
  }
  return groups;
}

/** The name of a call in a list. */
const shortOf = ({ title }) =>
  title
    .replace(/^(function|interface|type) /, "")
    .replace(/<.*>$/, "")
    .replace(/^\w+(?=[.[])(?<!Symbol)\.?/, "");

function listOfCalls(page, address) {
  return callsByGroup(page)
    .map(([group, calls]) => {
      const items = calls.map(
        (call) => `<li><a href="${address}#${call.anchor}">${escaped(shortOf(call))}</a></li>`,
      );
      return `${group ? `<p>${escaped(group)}</p>` : ""}${linkList(items)}`;
    })
    .join("");
}

/**
 * The pages, as list.mjs has them: `text` in Markdown, `anchors` of its headings, `side` with what
 * stands beside it, and `programs`. `addressFrom(up)` is documents.mjs's, for links.
 */
export function referencePages(addressFrom) {
  const { overview, pages } = split();
  const programs = programsByCode();
  const pageOf = new Map(
    pages.flatMap((page) => page.sections.map(({ anchor }) => [anchor, page.name])),
  );
  /** A link of docs/API.md, from a page that is `up` above the reference's folder. */
  const addressIn = (up) => (target) => {
    const [kind, rest] = target.split(/:(.*)/);
    if (kind === "api") return `${up}${pageOf.get(rest)}/#${rest}`;
    return kind === "site" ? `${up}../../${rest}` : addressFrom(`${up}../../`)(target);
  };
  const linked = (lines) => lines.join("\n").replaceAll("](#", "](api:");
  /** A line of links to the site's pages about a call. */
  const seeAlso = ({ title }) => {
    const links = (kSeeAlso[title.replace(/<.*>$/, "")] ?? []).map(
      ([address, text]) => `[${text}](site:${address})`,
    );
    return links.length > 0 ? `\nSee also: ${links.join(", ")}.\n` : "";
  };
  const unknown = Object.keys(kSeeAlso).filter(
    (call) =>
      !pages.some((page) => page.sections.some(({ title }) => title.replace(/<.*>$/, "") === call)),
  );
  if (unknown.length > 0) throw new Error(`see_also.mjs: no call is named ${unknown.join(", ")}`);
  const others = (current, up) =>
    linkList(
      pages.map((page) => {
        const here = page === current ? ' aria-current="page"' : "";
        return `<li><a href="${up}${page.name}/"${here}>${page.title}</a></li>`;
      }),
    );
  const ofPage = (page) => ({
    key: `api-${page.name}`,
    folder: `${kFolder}/${page.name}`,
    title: page.title,
    about: page.about,
    address: addressIn("../"),
    text: page.sections
      .map((section) => {
        // Its first heading is that of the page.
        const level = section.level - page.sections[0].level + 1;
        const heading = `${"#".repeat(level)} ${section.heading.replace(/^#+ /, "")}`;
        return `${heading}\n${linked(section.lines)}${seeAlso(section)}`;
      })
      .join("\n"),
    anchors: page.sections.map(({ anchor }) => anchor),
    programs,
    side:
      `<p><a href="../">API</a></p>${others(page, "../")}` +
      `<div class="calls"><p class="of">${page.title}</p>${listOfCalls(page, "")}</div>`,
  });
  const index = pages
    .map((page) => {
      // Old links to calls, which were all on one page, lead here, and from here on.
      const old = callsByGroup(page)
        .flatMap(([, calls]) => calls)
        .map(
          (call) =>
            `<li id="${call.anchor}"><a href="api:${call.anchor}">` +
            `${escaped(shortOf(call))}</a></li>`,
        );
      const first = page.sections[0].anchor;
      return `<h2 id="${first}"><a href="api:${first}">${page.title}</a></h2>${linkList(old)}`;
    })
    .join("\n");
  return [
    {
      key: "api",
      folder: kFolder,
      title: "API",
      about: "Every call with types, errors, costs and examples.",
      group: "Reference",
      address: addressIn(""),
      text:
        `${overview.heading}\n${linked(overview.lines)}\n\n` +
        `<div class="index" data-pagefind-ignore>\n\n${index}\n\n</div>`,
      anchors: [overview.anchor],
      side: `<p><a href="./" aria-current="page">API</a></p>${others(null, "")}`,
    },
    ...pages.map(ofPage),
  ];
}
