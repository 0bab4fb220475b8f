// Each code that the documentation of a call names is raised by it, with words that name argument
// and value, and the diagram is as it was. "out-of-memory" is in out_of_memory.test.mjs, "disposed"
// in lifetime.test.mjs. More kinds of bad values: errors.test.mjs, wrong_types.test.mjs.
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { describePackage } from "../../tools/api_reference.mjs";
import { calls } from "./support/calls.mjs";
import { snapshot } from "./support/graph.mjs";
import { methodsOf } from "./support/methods.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal, expectRejection } from "./support/refusal.mjs";

const entries = describePackage();
const { described } = entries[0];
const diagnostics = {
  name: "diagnostics",
  members: entries
    .find(({ entry }) => entry.endsWith("/diagnostics"))
    .described.filter(({ kind }) => kind === "function"),
};
const codesOf = (text) =>
  [...text.matchAll(/"([a-z-]+)"/g)].map((match) => match[1]).filter((code) => known.has(code));
const known = new Set(
  [...described.find(({ name }) => name === "ErrorCode").code.matchAll(/"([a-z-]+)"/g)].map(
    (match) => match[1],
  ),
);

/**
 * Returns what a member throws by its comment: codes, "throws as ...", "rejects as that throws" of
 * the call that it begins with, and what the comment of Voronoi says of all its calls.
 */
function documented(className, name) {
  const { members } = [...described, diagnostics].find((one) => one.name === className);
  const member = members.find((one) => one.name === name);
  const text = member.text.replace(/\s+/g, " ");
  const codes = new Set(codesOf(text));
  const other = /(?:[Tt]hrows|errors:) as (?:the )?`?(\w+)/.exec(text)?.[1];
  const that = /^`(\w+)`.*Rejects as that throws/s.exec(text)?.[1];
  for (const one of [other, that])
    if (one) documented(className, one).forEach((inherited) => codes.add(inherited));
  if (className === "Voronoi") {
    if (/\w\(id: number/.test(member.code)) codes.add("unknown-site");
    if (/\boptions\?/.test(member.code) && !text.includes("Throws"))
      codes.add("not-finite").add("out-of-range").add("bad-option");
  }
  return [...codes].sort();
}

test("the comment of Voronoi says what holds for all its calls", () => {
  const { text } = described.find(({ name }) => name === "Voronoi");
  expect(text.replace(/\s+/g, " ")).toMatch(
    /id without a site throws "unknown-site".*Options throw "not-finite".*unknown.* "bad-option"/,
  );
});

test.each([
  ["Diagram", Diagram, ["constructor", "from", "fromBytes"]],
  ["Voronoi", new Diagram().voronoi().constructor, []],
])("every call of %s is in the table", (name, type, more) => {
  const members = methodsOf(type).filter(
    (member) =>
      typeof member === "string" && !["constructor", "dispose", "toString"].includes(member),
  );
  expect(
    calls
      .map(([call]) => call)
      .filter((call) => call.startsWith(`${name}.`))
      .sort(),
  ).toEqual([...members, ...more].map((member) => `${name}.${member}`).sort());
});

test.each(calls)("%s is tried with each code that its documentation names, and no other", (name, {
  refuses,
}) => {
  expect([...new Set(refuses.map(([code]) => code))].sort()).toEqual(
    documented(...name.split(".")),
  );
});

const diagram = new Diagram(randomCircles(20, 23));
diagram.insert(0, 0, 300); // hides some
diagram.remove(7); // leaves a gap in the ids
const before = snapshot(diagram);

test.each(
  calls.flatMap(([name, { refuses, isAsync }]) =>
    refuses.map(([code, call, message]) => [name, code, message, call, isAsync]),
  ),
)("%s: %s, %s", async (_name, code, message, call, isAsync) => {
  await (isAsync ? expectRejection : expectRefusal)(() => call(diagram), code, message);
  expect(snapshot(diagram)).toBe(before);
});

test("after all that the diagram is sound, and the free id still free", () => {
  expect(validate(diagram)).toBeNull();
  expect(diagram.insert(0, 1, 2)).toBe(7);
});

test.each(calls)("%s works when it is given what it wants", async (_name, { use }) => {
  const copy = new Diagram(randomCircles(20, 23));
  await use(copy);
  expect(validate(copy)).toBeNull();
});
