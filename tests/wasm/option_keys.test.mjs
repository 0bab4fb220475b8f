// The keys of options: each one that the packed declarations name is accepted by the call, and any
// other one is refused. An overload may name fewer keys than the call has.
import { sampleCalls } from "./support/sample_calls.mjs";

const keysByCall = new Map();
for (const { of, name, keys } of sampleCalls) {
  if (keys === null) continue;
  const call = `${of}.${name}`;
  keysByCall.set(call, new Set([...(keysByCall.get(call) ?? []), ...keys]));
}
const cases = sampleCalls.flatMap(({ of, name, parameters, keys, run }) =>
  keys === null
    ? []
    : [{ call: `${of}.${name}(${parameters})`, keys: [...keysByCall.get(`${of}.${name}`)], run }],
);

test("all calls with options are tried", () => {
  for (const call of ["Diagram.fromAsync", "diagram.pickMany", "diagram.voronoi().renderCells"])
    expect([...keysByCall.keys()]).toContain(call);
  expect(keysByCall.size).toBeGreaterThan(60);
});

test.each(cases)("$call accepts its options", async ({ keys, run }) => {
  expect(keys.length).toBeGreaterThan(0);
  for (const key of keys) await run({}, { [key]: undefined });
});

test.each(cases)("$call refuses another option, and names its own", async ({ keys, run }) => {
  const error = await (async () => run({}, { nonsense: undefined }))().catch((thrown) => thrown);
  expect(error).toMatchObject({ code: "bad-option" });
  expect(error.message).toContain("options.nonsense is unknown");
  const named = /expected \{ (.*?) \}/.exec(error.message)[1].split(", ");
  expect(named.sort()).toEqual(keys.sort());
});
