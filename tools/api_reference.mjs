// npm run docs: docs/API.md from the comments and types of wasm/package, and docs/examples.
// tests/wasm/reference.test.mjs fails where the two disagree.
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { readExamples } from "./examples.mjs";
import { root } from "./toolchain/folders.mjs";
import { ensureNpmPackages } from "./toolchain/npm_packages.mjs";

ensureNpmPackages();
// Not before `npm ci` may have installed them.
const { default: ts } = await import("typescript");
const { slug } = await import("github-slugger");

export const referenceFile = path.join(root, "docs/API.md");

const entries = [
  ["apollonius-diagram", "index.ts"],
  ["apollonius-diagram/core", "core.ts"],
  ["apollonius-diagram/shapes", "shapes.ts"],
  ["apollonius-diagram/sphere", "sphere.ts"],
  ["apollonius-diagram/treemap", "treemap.ts"],
  ["apollonius-diagram/diagnostics", "diagnostics.ts"],
  ["apollonius-diagram/wasm", "wasm.ts"],
];
const preface = `<!-- Made by npm run docs: edit wasm/package and docs/examples instead. -->

# API reference

Lengths are in the unit of the input, areas in its square. Counter-clockwise is meant with y up; on
a screen, y down, it looks clockwise. n is the number of sites, d the number of a site's neighbours.
A call that fails throws an [ApolloniusError](#class-apolloniuserror) with a \`code\` and changes
nothing. Where there is nothing to return, an id is -1, a list is empty, anything else is null;
numbers in an array by id are NaN, or 0 if they are areas or lengths. In examples, the comment after
a line is its result, rounded to the digits shown.
`;

/**
 * The declarations of an export: of an interface that extends a class of its own name, as in
 * wasm/package/shapes/methods.ts, first those of that class, to which it adds.
 */
function declarationsOf(checker, symbol) {
  const added = symbol.declarations.filter(ts.isInterfaceDeclaration);
  const bases = added.flatMap((one) => checker.getTypeAtLocation(one).getBaseTypes?.() ?? []);
  const base = bases.find((one) => one.symbol?.name === symbol.name);
  return base ? [...base.symbol.declarations, ...added] : symbol.declarations;
}

/**
 * The exports of an entry by name, in the order of the files; `additions` are what another file
 * adds to a class, and further signatures.
 */
function exportsOf(checker, program, file) {
  const source = program.getSourceFile(path.join(root, "wasm/package", file));
  return checker.getExportsOfModule(checker.getSymbolAtLocation(source)).map((symbol) => {
    const target = symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
    const [declaration, ...additions] = declarationsOf(checker, target);
    return { name: symbol.name, declaration, additions };
  });
}

/** The comment of a declaration, as Markdown. */
function comment(declaration) {
  const docs = ts.getJSDocCommentsAndTags(declaration).filter(ts.isJSDoc);
  return docs
    .map((doc) => ts.getTextOfJSDocComment(doc.comment) ?? "")
    .join("\n")
    .trim();
}

/**
 * The declaration without comment, body and modifiers that say nothing to a reader, on one line.
 */
function signature(declaration) {
  const source = declaration.getSourceFile().text;
  const end = declaration.body ? declaration.body.getStart() : declaration.end;
  let text = source
    .slice(declaration.getStart(), end)
    .replace(/\/\*\*[\s\S]*?\*\/|\/\/.*$/gm, "")
    .replace(/\s+/g, " ")
    .trim();
  text = text
    .replace(/;$/, "")
    .replace(/^export (async )?/, "")
    .replace(/^(override |public |declare )+/, "");
  if (ts.isGetAccessor(declaration)) text = text.replace(/^get (\w+)\(\)/, "readonly $1");
  return text;
}

/**
 * The signature of a member whose parameters are a tuple of the surface's names, with those names:
 * as editors show it.
 */
function spelledOut(member, declaration, checker) {
  const ofMembers = checker.getTypeAtLocation(declaration).getProperty(memberName(member));
  const found = checker
    .getTypeOfSymbol(ofMembers)
    .getCallSignatures()
    .find((one) => one.declaration === member);
  const flags =
    ts.TypeFormatFlags.NoTruncation | ts.TypeFormatFlags.UseAliasDefinedOutsideCurrentScope;
  const text = checker.signatureToString(found, member, flags);
  return (
    memberName(member) +
    text
      .replace(/(\?: [^,)]*?) \| undefined(?=[,)])/g, "$1")
      .replace(/<ArrayBuffer(Like)?>/g, "")
      .replace(new RegExp(`: ${declaration.name.text}$`), ": this")
  );
}

function isPublic(member) {
  if (ts.getCombinedModifierFlags(member) & ts.ModifierFlags.Abstract) return false; // another's
  if (ts.getJSDocTags(member).some((tag) => tag.tagName.text === "internal")) return false;
  const hidden = ts.ModifierFlags.Private | ts.ModifierFlags.Protected;
  if ((ts.getCombinedModifierFlags(member) & hidden) !== 0) return false;
  return member.name === undefined || !ts.isPrivateIdentifier(member.name);
}

function memberName(member) {
  if (ts.isConstructorDeclaration(member)) return "constructor";
  if (ts.isCallSignatureDeclaration(member)) return "()";
  if (ts.isConstructSignatureDeclaration(member)) return "new";
  return member.name.getText().replace(/^\[(.*)\]$/, "$1");
}

/**
 * The public names of the package: per entry a list of { name, kind, text, code, members: { name,
 * text, code, isStatic }[] }. A name that an earlier entry has with the same declaration is left
 * out.
 */
export function describePackage() {
  const config = ts.readConfigFile(
    path.join(root, "wasm/package/tsconfig.json"),
    ts.sys.readFile,
  ).config;
  const { options } = ts.convertCompilerOptionsFromJson(
    config.compilerOptions,
    path.join(root, "wasm/package"),
  );
  const files = entries.map(([, file]) => path.join(root, "wasm/package", file));
  const program = ts.createProgram(
    [...files, path.join(root, "wasm/package/core/native/wasm_file.d.ts")],
    {
      ...options,
      noEmit: true,
    },
  );
  const checker = program.getTypeChecker();
  const seen = new Set();
  return entries.map(([entry, file]) => {
    const all = exportsOf(checker, program, file);
    const fresh = all.filter(({ declaration }) => !seen.has(declaration) && seen.add(declaration));
    return {
      entry,
      exports: all.map(({ name }) => name),
      described: fresh.map((one) => describe(one, checker)),
    };
  });
}

/** The members that an interface or a class has from those that it extends, as declarations. */
function inheritedBy(declaration, checker) {
  const isOurs = (node) =>
    node.getSourceFile().fileName.startsWith(path.join(root, "wasm/package"));
  return (declaration.heritageClauses ?? [])
    .filter((clause) => clause.token === ts.SyntaxKind.ExtendsKeyword)
    .flatMap((clause) => clause.types)
    .map((type) => checker.getTypeAtLocation(type))
    .flatMap((type) => (type.isIntersection() ? type.types : [type]))
    .flatMap((type) => {
      const [base] = type.symbol.declarations;
      // Otherwise Pick, say, of one of ours.
      const members = type.getProperties().flatMap(({ declarations }) => declarations);
      return isOurs(base) ? [...base.members] : members.filter(isOurs);
    });
}

/**
 * The name of each member's section in its class: the last line before it of the form
 * `// --- Name ---`. Members before the first such line build objects.
 */
function groupsOf(members) {
  return new Map(
    members.map((member) => {
      const before = member.getSourceFile().text.slice(member.parent.pos, member.getStart());
      const sections = [...before.matchAll(/^ +\/\/ --- (.+?) -+$/gm)];
      return [member, sections.at(-1)?.[1] ?? "Building"];
    }),
  );
}

/** The inherited member of the name of a member; if there is none, that one itself. */
function overriddenBy(member, inherited) {
  return inherited.find((one) => one.name?.getText() === member.name?.getText()) ?? member;
}

function describe({ name, declaration, additions }, checker) {
  const kind = ts.isClassDeclaration(declaration)
    ? "class"
    : ts.isInterfaceDeclaration(declaration)
      ? "interface"
      : ts.isTypeAliasDeclaration(declaration)
        ? "type"
        : ts.isFunctionDeclaration(declaration)
          ? "function"
          : "const";
  const members = [];
  const inherited = inheritedBy(declaration, checker);
  const own =
    kind === "class" || kind === "interface"
      ? [declaration, ...additions.filter(ts.isInterfaceDeclaration)].flatMap((one) => [
          ...one.members,
        ])
      : [];
  const ownNames = new Set(own.map((member) => member.name?.getText()));
  const others = inherited.filter((member) => !ownNames.has(member.name?.getText()));
  const all = kind === "class" ? [...own, ...inherited] : [...others, ...own];
  const groups = groupsOf(all);
  for (const member of all.filter(isPublic)) {
    if (ts.isClassStaticBlockDeclaration(member) || ts.isSemicolonClassElement(member)) continue;
    const described = {
      name: memberName(member),
      text: comment(member) || comment(overriddenBy(member, inherited)),
      code: /\.\.\.args: |: S\[/.test(signature(member))
        ? spelledOut(member, declaration, checker)
        : signature(member),
      group: groups.get(member),
      isStatic: (ts.getCombinedModifierFlags(member) & ts.ModifierFlags.Static) !== 0,
    };
    const overloaded = members.find(
      (other) => other.name === described.name && other.isStatic === described.isStatic,
    );
    if (!overloaded) members.push(described);
    // the one with the body is not public, and a property has one type
    else if (!member.body && !ts.isPropertySignature(member))
      overloaded.code += `\n${described.code}`;
  }
  // The one of several signatures that has the body is not public.
  const signatures = [declaration, ...additions].filter((one) => !one.body || one === declaration);
  const parameters = (declaration.typeParameters ?? []).map((parameter) => parameter.getText());
  return {
    name,
    kind,
    title: parameters.length > 0 ? `${name}<${parameters.join(", ")}>` : name,
    text: comment(declaration),
    code: members.length > 0 ? null : signatures.map(signature).join("\n"),
    members,
  };
}

const fenced = (code, language = "ts") => `\`\`\`${language}\n${code.trimEnd()}\n\`\`\`\n`;

/** The name of a part in headings of docs/examples; its own may go on with types. */
const nameOfPart = ({ kind, name }) => `${kind} ${name}`;
const headingOfPart = ({ kind, title }) => `${kind} ${title.replaceAll("<", "\\<")}`;

function headingOfMember({ name }, member) {
  const instance = `${name[0].toLowerCase()}${name.slice(1)}`;
  if (member.name === "constructor") return `new ${name}`;
  if (member.isStatic) return `${name}.${member.name}`;
  if (member.name.startsWith("Symbol.")) return `${instance}[${member.name}]`;
  return `${instance}.${member.name}`;
}

/** The calls of an entry, as their headings name them, in their order. */
export function callsOf({ described }) {
  return described.flatMap((part) => {
    if (part.kind === "function") return [nameOfPart(part)];
    return part.kind === "class" ? part.members.map((one) => headingOfMember(part, one)) : [];
  });
}

/**
 * The examples below each call of an entry: { text, part }, `part` naming the part of the reference
 * that has what the example begins with. What is about several calls is below the last.
 */
function examplesByCall({ entry, described }, files) {
  const order = described.flatMap((part) => [nameOfPart(part), ...callsOf({ described: [part] })]);
  const shown = new Map();
  for (const { file, part, setUp, examples } of files) {
    const named = [part, ...examples.flatMap(({ calls }) => calls)];
    const unknown = named.find((name) => !order.includes(name));
    if (unknown) throw new Error(`${file}: ${entry} has no "${unknown}"`);
    for (const { calls, text } of examples) {
      const last = order.findLast((name) => calls.includes(name));
      if (shown.has(last)) throw new Error(`${file}: "${last}" has an example already`);
      shown.set(last, { text: text.replaceAll("](../", "]("), part: setUp && part });
    }
  }
  return shown;
}

/** Functions that give what docs/examples has for an entry, as Markdown. */
function examplesFor(one) {
  const files = readExamples().filter(({ entry }) => entry === one.entry);
  const byCall = examplesByCall(one, files);
  const linkTo = (name) => {
    const part = one.described.find((other) => nameOfPart(other) === name);
    return `[${name}](#${slug(headingOfPart(part))})`;
  };
  return {
    /** The code that the examples of a part begin with. */
    beginning(part) {
      const { setUp } = files.find((file) => file.part === nameOfPart(part)) ?? {};
      return setUp ? [`The examples of this ${part.kind} begin with:\n`, fenced(setUp, "js")] : [];
    },
    /** The text below a heading of a part. */
    of(call, part) {
      if (!byCall.has(call)) return [];
      const { text, part: first } = byCall.get(call);
      const isElsewhere = first && first !== nameOfPart(part);
      const begins = isElsewhere
        ? `After what the examples of ${linkTo(first)} begin with:\n\n`
        : "";
      return [`${begins}${text}\n`];
    },
  };
}

/** Sections that most readers skip. */
const kLast = ["Saving", "Lifetime"];

function markdownOf(part, examples) {
  const { kind, text, code, members } = part;
  const lines = [`## ${headingOfPart(part)}\n`, `${text}\n`];
  if (code !== null) lines.push(fenced(code));
  if (kind === "interface") {
    lines.push(
      fenced(
        members
          .map((member) =>
            `${member.text.replace(/^/gm, "// ")}\n${member.code}`.replace(/^\/\/ \n/, ""),
          )
          .join("\n"),
      ),
    );
  }
  lines.push(...examples.beginning(part), ...examples.of(nameOfPart(part), part));
  if (kind === "interface") return lines.join("\n");
  const named = [...new Set(members.map(({ group }) => group))];
  const groups = [
    ...named.filter((name) => !kLast.includes(name)),
    ...kLast.filter((name) => named.includes(name)),
  ];
  for (const group of groups) {
    if (groups.length > 1) lines.push(`### ${group}\n`);
    for (const member of members.filter((one) => one.group === group)) {
      const heading = headingOfMember(part, member);
      lines.push(
        `${groups.length > 1 ? "####" : "###"} ${heading}\n`,
        fenced(member.code),
        ...(member.text ? [`${member.text}\n`] : []),
        ...examples.of(heading, part),
      );
    }
  }
  return lines.join("\n");
}

/** The calls that only one surface has, and why (tools/surfaces.json), as Markdown. */
function surfaces() {
  const table = JSON.parse(readFileSync(path.join(root, "tools/surfaces.json"), "utf8"));
  const said = ({ plane, sphere, reason }) => {
    const names = (plane ?? sphere).split("; ").map((part) => {
      const [of, ...rest] = part.split(".");
      const own = plane ? of : `Spherical${of}`;
      const members = rest.join(".").split(", ");
      return `\`${own}\`: ${members.map((member) => `\`${member}\``).join(", ")}`;
    });
    return `- ${names.join("; ")}. ${reason}`;
  };
  const kinds = [
    ["Only one of the two surfaces has these members", table.members],
    ["these parameters", table.parameters],
    ["these options", table.options],
    ["these answers", table.answers],
  ];
  return kinds.map(([title, list]) => `${title}:\n\n${list.map(said).join("\n")}\n`);
}

export function reference() {
  const described = describePackage();
  for (const { file, entry } of readExamples())
    if (!described.some((one) => one.entry === entry))
      throw new Error(`${file}: the package has no entry ${entry}`);
  return [
    preface,
    ...described.flatMap((one) => {
      const names = one.exports.map((name) => `\`${name}\``);
      const examples = examplesFor(one);
      return [
        `# Entry \`${one.entry}\`\n\nExports ${names.join(", ")}.\n`,
        ...(one.entry.endsWith("/sphere") ? surfaces() : []),
        ...one.described.map((part) => markdownOf(part, examples)),
      ];
    }),
  ]
    .join("\n")
    .replace(/\n{3,}/g, "\n\n");
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  writeFileSync(referenceFile, reference());
