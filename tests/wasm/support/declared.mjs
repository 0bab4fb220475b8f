// The declarations of the packed package, as TypeScript's compiler reads them.
import path from "node:path";
import ts from "typescript";
import { packed } from "./install_packed.mjs";

export const entries = ["index", "core", "shapes", "sphere", "treemap", "wasm"];

/** A program of the entries' declarations: its checker, and the exports of each by name. */
export function declared(folder = path.join(packed, "node_modules/apollonius-diagram/dist/esm")) {
  const files = entries.map((entry) => path.join(folder, `${entry}.d.ts`));
  const program = ts.createProgram(files, {
    strict: true,
    exactOptionalPropertyTypes: true,
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.ESNext,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    lib: ["lib.es2023.d.ts", "lib.esnext.disposable.d.ts", "lib.dom.d.ts"],
    types: [],
  });
  const checker = program.getTypeChecker();
  const resolved = (symbol) =>
    symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
  const exportsOf = Object.fromEntries(
    entries.map((entry, k) => {
      const module = checker.getSymbolAtLocation(program.getSourceFile(files[k]));
      const all = checker.getExportsOfModule(module);
      return [entry, new Map(all.map((symbol) => [symbol.name, resolved(symbol)]))];
    }),
  );
  const isOwn = (symbol) =>
    symbol?.declarations?.some((one) => one.getSourceFile().fileName.startsWith(folder)) ?? false;
  return { checker, exportsOf, isOwn };
}

/**
 * The parameters of a signature, of which the last may be a tuple of names: { name, type,
 * isOptional }.
 */
export function parametersOf(checker, signature) {
  return signature.getParameters().flatMap((symbol) => {
    const declaration = symbol.valueDeclaration;
    const type = checker.getTypeOfSymbol(symbol);
    if (!declaration?.dotDotDotToken || !checker.isTupleType(type)) {
      const isOptional = declaration !== undefined && checker.isOptionalParameter(declaration);
      return [{ name: symbol.name, type, isOptional }];
    }
    const { elementFlags, labeledElementDeclarations } = type.target;
    return checker.getTypeArguments(type).map((element, k) => ({
      name: labeledElementDeclarations[k].name.getText(),
      type: element,
      isOptional: (elementFlags[k] & ts.ElementFlags.Optional) !== 0,
    }));
  });
}

/** The names of the properties of a type, in whichever of its parts. */
export function keysOf(checker, type) {
  const parts = type.isUnion() ? type.types : [type];
  return [...new Set(parts.flatMap((part) => checker.getPropertiesOfType(part)))]
    .map(({ name }) => name)
    .filter((name, k, all) => all.indexOf(name) === k);
}

/** A member's name, that of a symbol as it is written; null for a private one. */
export function nameOf({ name }) {
  if (name.includes("#")) return null;
  return name.replace(/^__@(\w+)@\d+$/, "Symbol.$1");
}

/**
 * The package's own types that exported functions and classes take or give, and that are not
 * exported themselves, each with a way to it: "sphere > SphericalDiagram > UpdateOptions". A class
 * that is only extended (also by an exported one of its name) need not be exported, but the types
 * that its members take and give must be.
 */
export function forgottenExports({ checker, isOwn }, exported, entry) {
  const all = new Set(exported);
  const names = new Set([...all].map(({ name }) => name));
  const forgotten = new Map();
  const seen = new Map([false, true].map((isBase) => [isBase, new Set()]));
  const visitNode = (node, way, isBase) => {
    if (ts.isTypeReferenceNode(node)) visit(node.typeName, way, isBase);
    if (ts.isImportTypeNode(node)) visit(node.qualifier, way, isBase);
    if (ts.isExpressionWithTypeArguments(node)) visit(node.expression, way, true);
    if (ts.isTypeParameterDeclaration(node) && isBase) return;
    const isExtended = isBase || ts.isHeritageClause(node);
    ts.forEachChild(node, (child) => visitNode(child, way, isExtended));
  };
  const visit = (name, way, isBase) => visitSymbol(checker.getSymbolAtLocation(name), way, isBase);
  const visitSymbol = (symbol, way, isBase) => {
    if (symbol === undefined || symbol.flags & ts.SymbolFlags.TypeParameter) return;
    const isAliased = symbol.flags & ts.SymbolFlags.Alias;
    const target = isAliased ? checker.getAliasedSymbol(symbol) : symbol;
    if (!isOwn(target) || seen.get(isBase).has(target)) return;
    seen.get(isBase).add(target);
    const further = `${way} > ${target.name}`;
    const isExtended = seen.get(true).has(target) && names.has(target.name);
    const isImport = target.declarations.some((one) => one.type && ts.isImportTypeNode(one.type));
    if (!all.has(target) && !isBase && !isExtended && !isImport)
      forgotten.set(target.name, further);
    for (const declaration of target.declarations) {
      // An alias extends all that it is made of; a class or an interface has members.
      const isAlias =
        ts.isTypeAliasDeclaration(declaration) || ts.isVariableDeclaration(declaration);
      ts.forEachChild(declaration, (child) => {
        if (!isBase || !ts.isTypeParameterDeclaration(child))
          visitNode(child, further, isBase && isAlias);
      });
    }
  };
  for (const symbol of all) visitSymbol(symbol, entry, false);
  return [...forgotten.values()];
}
