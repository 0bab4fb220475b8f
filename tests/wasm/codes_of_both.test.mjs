// The plane and the sphere refuse the same wrong arguments with the same codes.
import { sampleCalls } from "./support/sample_calls.mjs";

/** Latitudes and weights have a limit on the sphere. */
const isLimited = (parameter, value) => /^[yr]$/.test(parameter) && value > 90;

const translations = { lon: "x", lat: "y", lonLat: "xy", lonLatR: "xyr" };
const translated = (name) => translations[name] ?? name;
const counterparts = {
  Diagram: "SphericalDiagram",
  diagram: "globe",
  "diagram.voronoi()": "globe.voronoi()",
};
const pairs = sampleCalls.flatMap((plane) => {
  const sphere = sampleCalls.find(
    ({ of, name, parameters }) =>
      of === counterparts[plane.of] &&
      name === plane.name &&
      String(parameters.map(translated)) === String(plane.parameters),
  );
  return sphere && plane.parameters.length > 0 ? [{ plane, sphere }] : [];
});

const wrong = [
  undefined,
  null,
  NaN,
  Infinity,
  -1,
  1.5,
  99,
  2 ** 32,
  "1",
  1n,
  true,
  {},
  [],
  [1],
  [NaN, 0, 0],
  ["1", 0, 0],
  [0, 0, Infinity],
  new Float64Array(7),
  new DataView(new ArrayBuffer(8)),
  () => {},
  () => NaN,
  Promise.resolve(),
];

/** A code, "fine", or what else is thrown. */
const codeOf = async (call) => {
  try {
    await call();
    return "fine";
  } catch (error) {
    return error.code ?? String(error);
  }
};

test("what is compared: most calls with parameters", () => {
  const names = pairs.map(({ plane }) => `${plane.of}.${plane.name}`);
  expect(new Set(names).size).toBeGreaterThan(35);
  for (const name of ["Diagram.from", "diagram.insert", "diagram.kNearestMany", "diagram.pick"])
    expect(names).toContain(name);
});

test.each(
  pairs.map((pair) => [`${pair.plane.of}.${pair.plane.name}(${pair.plane.parameters})`, pair]),
)("%s", async (_, { plane, sphere }) => {
  const differences = [];
  for (const [k, parameter] of plane.parameters.entries())
    for (const value of wrong) {
      if (isLimited(parameter, value)) continue;
      const ours = await codeOf(() => plane.run({ [parameter]: value }));
      const theirs = await codeOf(() => sphere.run({ [sphere.parameters[k]]: value }));
      const shown = Array.isArray(value) ? `[${value}]` : String(value);
      if (ours !== theirs) differences.push(`${parameter} = ${shown}: ${ours} / ${theirs}`);
    }
  expect(differences).toEqual([]);
});
