// The keys of options: each one that the packed declarations name is accepted by the call, and any
// other one is refused.
import * as plane from "../../build/packed/consumer.mjs";
import * as sphere from "../../build/packed/sphere.mjs";
import { treemap } from "../../build/packed/treemap.mjs";
import { declared, keysOf, nameOf, parametersOf } from "./support/declared.mjs";

const { checker, exportsOf } = declared();

const triples = [10, 20, 0.3, 40, 25, 0.2, 30, 60, 0.1];
const numbers = [10, 20, 0.3, 40, 0.2, 0.1]; // two triples, or three pairs
const path = { moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} };
/** What a call gets for a parameter of that name. */
const values = {
  x: 10,
  y: 20,
  lon: 10,
  lat: 20,
  id: 0,
  k: 2,
  xmin: 0,
  ymin: 0,
  xmax: 100,
  ymax: 100,
  count: 2,
  maxDistance: 5,
  ids: [0],
  xy: numbers,
  lonLat: numbers,
  values: [1, 2, 3],
  targets: [1, 2, 3],
  items: [[10, 20, 0.3]],
  window: [0, 0, 100, 100],
  context: path,
  each() {},
};
/** Parameters whose values depend on the call. */
const valueOf = (name, call, object) => {
  if (name === "bytes") return object.toBytes();
  if (/^(x|lonLat)/i.test(name) && call === "updateMany") return triples.slice(0, 3);
  if (name === "xyr" || name === "lonLatR") return triples;
  if (name === "values" || name === "targets") return Array(object.diagram.size).fill(1);
  // An accessor of `from`
  if (call.startsWith("from") && name !== "items") return (item) => item[name === "r" ? 2 : 0];
  return values[name];
};

/** The calls of a class, or of an object, that take options: with their parameters and keys. */
function callsOf(type) {
  return type.getProperties().flatMap((property) => {
    const name = nameOf(property);
    const signatures = checker.getTypeOfSymbol(property).getCallSignatures();
    const lists = signatures.map((signature) => parametersOf(checker, signature));
    const taking = lists.filter((list) => list.at(-1)?.name === "options");
    if (name === null || taking.length === 0) return [];
    const keysIn = (list) => keysOf(checker, checker.getNonNullableType(list.at(-1).type));
    const parameters = taking.map((list) => list.slice(0, -1).map((one) => one.name));
    return [{ name, parameters, keys: [...new Set(taking.flatMap(keysIn))] }];
  });
}

const instanceOf = (symbol) => checker.getDeclaredTypeOfSymbol(symbol);
const classOf = (symbol) => checker.getTypeOfSymbol(symbol);
const { index, sphere: ofSphere, treemap: ofTreemap } = exportsOf;
const diagram = () => new plane.Diagram(triples);
const globe = () => new sphere.SphericalDiagram(triples);
const tree = () => ({
  data: {},
  value: 3,
  children: [1, 2].map((value) => ({ data: { name: value }, value })),
});
const subjects = [
  ["Diagram", classOf(index.get("Diagram")), () => plane.Diagram, diagram],
  ["diagram", instanceOf(index.get("Diagram")), diagram],
  ["voronoi", instanceOf(index.get("Voronoi")), () => diagram().voronoi([0, 0, 100, 100])],
  [
    "SphericalDiagram",
    classOf(ofSphere.get("SphericalDiagram")),
    () => sphere.SphericalDiagram,
    globe,
  ],
  ["globe", instanceOf(ofSphere.get("SphericalDiagram")), globe],
  ["globe.voronoi()", instanceOf(ofSphere.get("SphericalVoronoi")), () => globe().voronoi()],
  ["treemap()", instanceOf(ofTreemap.get("Treemap")), () => treemap()],
  ["leaf", instanceOf(ofTreemap.get("TreemapCell")), () => treemap()(tree()).children[0]],
];

const cases = subjects.flatMap(([subject, type, make, ofBytes]) =>
  callsOf(type).flatMap(({ name, parameters, keys }) =>
    parameters.map((list) => ({
      call: `${subject}.${name}(${list})`,
      keys,
      run(options) {
        const object = make();
        const given = list.map((parameter) =>
          parameter === "root" ? tree() : valueOf(parameter, name, ofBytes?.() ?? object),
        );
        const answer = object[name](...given, options);
        // A generator runs when it is asked.
        return typeof answer?.next === "function" ? [...answer] : answer;
      },
    })),
  ),
);

test("all calls with options are tried", () => {
  const tried = new Set(cases.map(({ call }) => call.replace(/\(.*/, "")));
  for (const call of ["Diagram.fromAsync", "diagram.pickMany", "voronoi.renderCells"])
    expect(tried).toContain(call);
  expect(tried.size).toBeGreaterThan(60);
});

test.each(cases)("$call accepts its options", async ({ keys, run }) => {
  expect(keys.length).toBeGreaterThan(0);
  for (const key of keys) await run({ [key]: undefined });
});

test.each(cases)("$call refuses another option, and names its own", async ({ keys, run }) => {
  const error = await (async () => run({ nonsense: undefined }))().catch((thrown) => thrown);
  expect(error).toMatchObject({ code: "bad-option" });
  expect(error.message).toContain("options.nonsense is unknown");
  const named = /expected \{ (.*?) \}/.exec(error.message)[1].split(", ");
  expect(named.sort()).toEqual([...keys].sort());
});
