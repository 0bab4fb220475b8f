// The plane and the sphere have one interface: names of members, names and order of parameters,
// keys of options, and answers are the same in the packed declarations, after translating
// (tools/surfaces.json), and where they are not, that file has the reason.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import {
  declared,
  entries,
  forgottenExports,
  keysOf,
  nameOf,
  parametersOf,
} from "./support/declared.mjs";

const table = JSON.parse(readFileSync(path.join(root, "tools/surfaces.json"), "utf8"));
const all = declared();
const { checker, exportsOf } = all;

const words = Object.keys(table.translated).filter((word) => word !== "Spherical");
const word = new RegExp(`\\b(?:${words.join("|")})\\b`, "g");
/** A declaration of the sphere in the words of the plane. */
const translated = (text) =>
  text
    .replace(word, (found) => table.translated[found])
    .replaceAll("Spherical", table.translated.Spherical);

/** A call by its overloads: sequences of names, the fewest arguments, options, answers. */
function callOf(signatures) {
  const lists = signatures.map((signature) => parametersOf(checker, signature));
  const options = lists.flat().filter(({ name }) => name === "options");
  const answers = signatures.map((one) => translated(checker.typeToString(one.getReturnType())));
  return {
    parameters: [...new Set(lists.map((list) => list.map(({ name }) => translated(name)).join()))],
    least: Math.min(...lists.map((list) => list.filter(({ isOptional }) => !isOptional).length)),
    options: new Set(
      options.flatMap(({ type }) => keysOf(checker, checker.getNonNullableType(type))),
    ),
    answer: [...new Set(answers)].sort().join(" | "),
  };
}

/** The members of a type by name. */
function membersOf(type) {
  const members = new Map();
  for (const property of type.getProperties()) {
    const name = nameOf(property);
    if (name === null || name === "prototype") continue;
    const own = checker.getTypeOfSymbol(property);
    const signatures = own.getCallSignatures();
    const isCall = signatures.length > 0;
    members.set(
      translated(name),
      isCall ? callOf(signatures) : { answer: translated(checker.typeToString(own)) },
    );
  }
  return members;
}

/** The members of a class, statics and constructor included, or of a type without a value. */
function classOf(symbol) {
  const members = membersOf(checker.getDeclaredTypeOfSymbol(symbol));
  if (symbol.valueDeclaration === undefined) return members;
  const value = checker.getTypeOfSymbol(symbol);
  for (const [name, call] of membersOf(value)) members.set(name, call);
  const makers = value.getConstructSignatures();
  const isForUsers = makers.every(({ declaration }) => {
    const modifiers = declaration?.modifiers ?? [];
    return !modifiers.some((one) => one.getText() === "private");
  });
  if (isForUsers) members.set("constructor", callOf(makers));
  return members;
}

const differenceOf = (own, others) => [...own].filter((one) => !others.has(one));
const bySurface = (own, others) => [
  ["plane", differenceOf(own, others)],
  ["sphere", differenceOf(others, own)],
];

/** Lists the differences of two maps of members: "plane members Diagram.search". */
function differences(of, plane, sphere) {
  const found = [];
  const add = (...said) => found.push(said.join(" "));
  for (const [surface, names] of bySurface(new Set(plane.keys()), new Set(sphere.keys())))
    for (const name of names) add(surface, "members", `${of}.${name}`);
  for (const [name, ours] of plane) {
    const theirs = sphere.get(name);
    if (theirs === undefined) continue;
    const call = `${of}.${name}`;
    if (ours.answer !== theirs.answer) add("answers", call, ours.answer, "/", theirs.answer);
    if (!ours.parameters !== !theirs.parameters) add("one is no call:", call);
    if (!ours.parameters || !theirs.parameters) continue;
    // Where one takes no options, their keys are what differs.
    const isWithout = ours.options.size === 0 || theirs.options.size === 0;
    const names = (list) => (isWithout ? list.replace(/,?options$/, "") : list);
    const lists = (all) => [...new Set(all.map(names))].sort().join("; ");
    if (lists(ours.parameters) !== lists(theirs.parameters) || ours.least !== theirs.least)
      add("parameters", call, lists(ours.parameters), "/", lists(theirs.parameters));
    for (const [surface, keys] of bySurface(ours.options, theirs.options))
      for (const key of keys) add(surface, "options", `${call}({ ${key} })`);
  }
  return found;
}

/** The types of records, without options, that both surfaces have by one name. */
const records = [...exportsOf.sphere].flatMap(([name, symbol]) => {
  const other = exportsOf.index.get(translated(name));
  const isRecord = /^(Listed)?Spherical/.test(name) && other && !/Options$|Voronoi$/.test(name);
  return isRecord && name !== "SphericalDiagram" ? [[translated(name), other, symbol]] : [];
});

const found = [
  ...["Diagram", "Voronoi"].flatMap((name) =>
    differences(
      name,
      classOf(exportsOf.index.get(name)),
      classOf(exportsOf.sphere.get(`Spherical${name}`)),
    ),
  ),
  ...records.flatMap(([name, plane, sphere]) =>
    differences(name, ...[plane, sphere].map((one) => classOf(one))),
  ),
];

/** An entry of the table as beginnings of differences: "Voronoi.a, b; Diagram.c" names three. */
function namedBy(kind, entry) {
  const surface = "plane" in entry ? "plane" : "sphere";
  return entry[surface].split("; ").flatMap((part) => {
    const [of] = part.split(".");
    return part
      .slice(of.length + 1)
      .split(", ")
      .map((name) => {
        const isOneSided = kind === "members" || kind === "options";
        const call = kind === "parameters" ? name.replace(/\(.*/, "") : name;
        return `${isOneSided ? `${surface} ` : ""}${kind} ${of}.${call}`;
      });
  });
}

const explained = ["members", "parameters", "options", "answers"].flatMap((kind) =>
  table[kind].flatMap((entry) => namedBy(kind, entry)),
);
const isExplainedBy = (difference, beginning) =>
  difference === beginning || difference.startsWith(`${beginning} `);

test("the plane and the sphere differ in what tools/surfaces.json gives a reason for", () => {
  const isUnexplained = (one) => !explained.some((other) => isExplainedBy(one, other));
  expect(found.filter(isUnexplained)).toEqual([]);
});

test("tools/surfaces.json explains no difference that there is not", () => {
  const isStale = (one) => !found.some((difference) => isExplainedBy(difference, one));
  expect(explained.filter(isStale)).toEqual([]);
});

test("what is compared is what there is: both classes, both views, records", () => {
  const plane = classOf(exportsOf.index.get("Diagram"));
  expect(plane.get("find")).toEqual({
    parameters: ["x,y,options"],
    least: 2,
    options: new Set(["filter", "maxDistance"]),
    answer: "number",
  });
  expect(plane.get("constructor").parameters).toEqual(["xyr,options"]);
  expect(plane.get("from").parameters).toEqual([
    "items,options",
    "items,x,y,options",
    "items,x,y,r,options",
    "xyr,options",
  ]);
  expect(classOf(exportsOf.index.get("Voronoi")).get("contains").parameters).toEqual(["id,x,y"]);
  expect(records.map(([name]) => name)).toEqual(
    expect.arrayContaining(["Site", "Sites", "Vertices", "ListedSite", "EmptyCircle", "Measures"]),
  );
});

// A program that exports a call's result writes its type into declarations, and so must have its
// name.
test.each(entries)("%s exports every type that what it exports takes or gives", (entry) => {
  // The diagrams that functions of shapes take are of core.
  const others = entry === "shapes" ? exportsOf.core.values() : [];
  const exported = [...exportsOf[entry].values(), ...others];
  expect(forgottenExports(all, exported, entry)).toEqual([]);
});

test("a type that is not exported is found, in parameters, answers and bases' members", () => {
  const without = (...names) =>
    [...exportsOf.sphere].flatMap(([name, symbol]) => (names.includes(name) ? [] : [symbol]));
  const names = ["UpdateOptions", "SphericalVoronoi", "NearbyLists", "SphericalGeometry"];
  const forgotten = forgottenExports(all, without(...names), "sphere");
  expect(forgotten.map((way) => way.split(" > ").at(-1)).sort()).toEqual(names.sort());
});

// The default entry's class repeats the static calls of core's, and they give its own diagrams.
test("the default entry's Diagram is made as core's is", () => {
  const [whole, core] = [exportsOf.index, exportsOf.core].map((names) => {
    const value = checker.getTypeOfSymbol(names.get("Diagram"));
    const calls = value.getProperties().filter(({ name }) => name !== "prototype");
    const written = (signatures) => signatures.map((one) => checker.signatureToString(one));
    return Object.fromEntries([
      ["new", written(value.getConstructSignatures())],
      ...calls.map((call) => [
        call.name,
        written(checker.getTypeOfSymbol(call).getCallSignatures()),
      ]),
    ]);
  });
  expect(whole).toEqual(core);
  expect(whole.from).toHaveLength(4);
});
