// npm run docs: docs/API.md from the comments and types of wasm/package.
// tests/wasm/reference.test.mjs fails where the two disagree.
import { writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { root } from "./toolchain/folders.mjs";
import { ensureNpmPackages } from "./toolchain/npm_packages.mjs";

ensureNpmPackages();
const { default: ts } = await import("typescript"); // not before `npm ci` may have installed it

export const referenceFile = path.join(root, "docs/API.md");

const entries = [
  ["apollonius-diagram", "index.ts"],
  ["apollonius-diagram/wasm", "wasm.ts"],
  ["apollonius-diagram/sphere", "sphere.ts"],
  ["apollonius-diagram/treemap", "treemap.ts"],
];
const preface = `# API reference

Made by \`npm run docs\` from the comments in \`wasm/package\`; edit those. Lengths are in the unit
of the input, areas in its square; y points upwards, and counter-clockwise is meant so. n is the
number of sites, d the number of a site's neighbours. Every call that fails throws an
[ApolloniusError](#class-apolloniuserror) with a \`code\` and changes nothing.
`;

/** The exports of an entry by name, in the order of the files. */
function exportsOf(checker, program, file) {
  const source = program.getSourceFile(path.join(root, "wasm/package", file));
  return checker.getExportsOfModule(checker.getSymbolAtLocation(source)).map((symbol) => {
    const target = symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
    return { name: symbol.name, declaration: target.declarations[0] };
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

function isPublic(member) {
  if (ts.getJSDocTags(member).some((tag) => tag.tagName.text === "internal")) return false;
  return (
    member.name === undefined ||
    (!ts.isPrivateIdentifier(member.name) &&
      (ts.getCombinedModifierFlags(member) &
        (ts.ModifierFlags.Private | ts.ModifierFlags.Protected)) ===
        0)
  );
}

function memberName(member) {
  if (ts.isConstructorDeclaration(member)) return "constructor";
  if (ts.isCallSignatureDeclaration(member)) return "()";
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
    [...files, path.join(root, "wasm/package/native/wasm_file.d.ts")],
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

/** The interfaces that one extends, as declarations. */
function basesOf(declaration, checker) {
  const types = (declaration.heritageClauses ?? []).flatMap((clause) => clause.types);
  return types.map((type) => checker.getTypeAtLocation(type).symbol.declarations[0]);
}

function describe({ name, declaration }, checker) {
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
  const inherited =
    kind === "interface" ? basesOf(declaration, checker).flatMap((base) => [...base.members]) : [];
  const own = kind === "class" || kind === "interface" ? [...declaration.members] : [];
  for (const member of [...inherited, ...own].filter(isPublic)) {
    if (ts.isClassStaticBlockDeclaration(member) || ts.isSemicolonClassElement(member)) continue;
    const described = {
      name: memberName(member),
      text: comment(member),
      code: signature(member),
      isStatic: (ts.getCombinedModifierFlags(member) & ts.ModifierFlags.Static) !== 0,
    };
    const overloaded = members.find(
      (other) => other.name === described.name && other.isStatic === described.isStatic,
    );
    if (!overloaded) members.push(described);
    // the one with the body is not public
    else if (!member.body) overloaded.code += `\n${described.code}`;
  }
  const parameters = (declaration.typeParameters ?? []).map((parameter) => parameter.getText());
  return {
    name,
    kind,
    title: parameters.length > 0 ? `${name}<${parameters.join(", ")}>` : name,
    text: comment(declaration),
    code: members.length > 0 ? null : signature(declaration),
    members,
  };
}

const fenced = (code) => `\`\`\`ts\n${code}\n\`\`\`\n`;

function markdownOf({ name, kind, title: heading, text, code, members }) {
  const parts = [`## ${kind} ${heading.replaceAll("<", "\\<")}\n`, `${text}\n`];
  const instance = `${name[0].toLowerCase()}${name.slice(1)}`;
  if (code !== null) parts.push(fenced(code));
  if (kind === "interface") {
    parts.push(
      fenced(
        members
          .map((member) =>
            `${member.text.replace(/^/gm, "// ")}\n${member.code}`.replace(/^\/\/ \n/, ""),
          )
          .join("\n"),
      ),
    );
  } else {
    for (const member of members) {
      const title =
        member.name === "constructor"
          ? `new ${name}`
          : member.isStatic
            ? `${name}.${member.name}`
            : member.name.startsWith("Symbol.")
              ? `${instance}[${member.name}]`
              : `${instance}.${member.name}`;
      parts.push(
        `### ${title}\n`,
        fenced(member.code),
        ...(member.text ? [`${member.text}\n`] : []),
      );
    }
  }
  return parts.join("\n");
}

export function reference() {
  return [
    preface,
    ...describePackage().flatMap(({ entry, exports, described }) => [
      `# Entry \`${entry}\`\n\nExports ${exports.map((name) => `\`${name}\``).join(", ")}.\n`,
      ...described.map(markdownOf),
    ]),
  ]
    .join("\n")
    .replace(/\n{3,}/g, "\n\n");
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  writeFileSync(referenceFile, reference());
