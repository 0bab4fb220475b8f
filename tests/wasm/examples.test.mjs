// The examples of docs/API.md run as they stand and give what the comments beside them say; each
// call has one.
import { callsOf, describePackage } from "../../tools/api_reference.mjs";
import { readExamples } from "../../tools/examples.mjs";
import { runExamples, valueIn, writtenAs } from "./support/examples.mjs";

const files = readExamples();
const examples = files.flatMap(({ file, setUp, examples: own }) =>
  own.flatMap(({ calls, codes }) =>
    codes.map((code, k) => ({ name: `${file}, ${calls.join(", ")} (${k + 1})`, setUp, code })),
  ),
);
const outcomes = runExamples(examples);

test.each(examples.map(({ name }, k) => [name, outcomes[k]]))("%s", (_, { results, error }) => {
  expect(error).toBe(undefined);
  expect(results.length).toBeGreaterThan(0);
  for (const { said, text } of results) {
    const value = valueIn(said);
    expect(writtenAs(value, text)).toBe(value);
  }
});

test("examples are short, and the site shows all of a line, the first beside its button", () => {
  const isLong = ({ code }) => {
    const lines = code.trimEnd().split("\n");
    return lines.length > 8 || lines.some(({ length }, k) => length > (k === 0 ? 76 : 82));
  };
  expect(examples.filter(isLong).map(({ name }) => name)).toEqual([]);
});

// Nobody calls these.
const kWithout = /\[Symbol\.toStringTag\]$|^apolloniusError\.name$|^new (ApolloniusError|Voronoi)$/;

const described = describePackage();

test.each(
  described.map((one) => [one.entry, one]),
)("%s: each call has an example", (entry, one) => {
  const shown = files
    .filter((file) => file.entry === entry)
    .flatMap((file) => file.examples.flatMap(({ calls }) => calls));
  expect(callsOf(one).filter((call) => !kWithout.test(call) && !shown.includes(call))).toEqual([]);
});

test("options, and what can be asked of the objects that calls give, are in an example", () => {
  const types = /Options$|^(Treemap|TreemapCell|Triangulation|VoronoiWindow)$/;
  const words = new Set(examples.flatMap(({ code }) => code.match(/\w+/g)));
  const missing = described
    .flatMap((one) => one.described)
    .filter(({ name, kind }) => kind === "interface" && types.test(name))
    .flatMap(({ name, members }) => members.map((member) => [name, member.name]))
    .filter(([, member]) => member !== "()" && !words.has(member));
  expect(missing).toEqual([]);
});

test("what is compared: a value, in the digits in which it is written", () => {
  expect(valueIn('{ a: ["b: c"] }: why: so')).toBe('{ a: ["b: c"] }');
  expect(valueIn('throws "busy": it asks')).toBe('throws "busy"');
  expect(writtenAs("[1.50, 2]", "[1.4999, 2.1]")).toBe("[1.50, 2.1]");
  expect(writtenAs("Float64Array [1.0, …", "Float64Array [0.99, 5, 6]")).toBe(
    "Float64Array [1.0, …",
  );
});
