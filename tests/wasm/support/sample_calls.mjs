// Calls of the package as its declarations have them, with arguments that they accept.
import * as plane from "../../../build/packed/consumer.mjs";
import * as sphere from "../../../build/packed/sphere.mjs";
import { treemap } from "../../../build/packed/treemap.mjs";
import { declared, keysOf, nameOf, parametersOf } from "./declared.mjs";

const { checker, exportsOf } = declared();

const triples = [10, 20, 0.3, 40, 25, 0.2, 30, 60, 0.1];
const numbers = [10, 20, 0.3, 40, 0.2, 0.1]; // two triples, or three pairs

/** The value of a parameter of that name. */
const values = {
  x: 10,
  y: 20,
  r: 0.1,
  lon: 10,
  lat: 20,
  id: 0,
  k: 2,
  xmin: 0,
  ymin: 0,
  xmax: 100,
  ymax: 100,
  count: 2,
  maxDistance: 0.5,
  ids: [0],
  xy: numbers,
  lonLat: numbers,
  xyr: triples,
  lonLatR: triples,
  items: [[10, 20, 0.3]],
  window: [0, 0, 100, 100],
  context: { moveTo() {}, lineTo() {}, bezierCurveTo() {}, closePath() {} },
  each() {},
};

/** The value where it depends on the call, and on what that is a call of. */
function argumentOf(name, call, { object, bytes, parameters }) {
  if (name === "root") return tree();
  if (name === "context" && !parameters.includes("each")) return null;
  if (name === "bytes") return bytes();
  if (name === "values" || name === "targets") return [1, 1, 1];
  if (call === "updateMany" && /^(xy|lonLat)/.test(name)) return triples.slice(0, 3);
  // An accessor of `from`
  if (call.startsWith("from") && name in values && name !== "items" && !Array.isArray(values[name]))
    return (item) => item[name === "r" ? 2 : 0];
  if (name === "diagram") return object;
  return values[name];
}

const diagram = () => new plane.Diagram(triples);
const globe = () => new sphere.SphericalDiagram(triples);
const tree = () => ({
  data: {},
  value: 3,
  children: [1, 2].map((value) => ({ data: { name: value }, value })),
});
const { index, sphere: ofSphere, treemap: ofTreemap } = exportsOf;
const instance = (names, name) => checker.getDeclaredTypeOfSymbol(names.get(name));
const statics = (names, name) => checker.getTypeOfSymbol(names.get(name));

/** The objects that have calls: name, type, and a function that makes one. */
const subjects = [
  ["Diagram", statics(index, "Diagram"), () => plane.Diagram, () => diagram().toBytes()],
  ["diagram", instance(index, "Diagram"), diagram],
  ["diagram.voronoi()", instance(index, "Voronoi"), () => diagram().voronoi([0, 0, 100, 100])],
  [
    "SphericalDiagram",
    statics(ofSphere, "SphericalDiagram"),
    () => sphere.SphericalDiagram,
    () => globe().toBytes(),
  ],
  ["globe", instance(ofSphere, "SphericalDiagram"), globe],
  ["globe.voronoi()", instance(ofSphere, "SphericalVoronoi"), () => globe().voronoi()],
  ["treemap()", instance(ofTreemap, "Treemap"), () => treemap()],
  ["leaf", instance(ofTreemap, "TreemapCell"), () => treemap()(tree()).children[0]],
];

/**
 * All calls, one for each overload: { of, name, parameters, keys of its options or null, run }.
 * `run(changed, options)` calls it with sample arguments, some of them changed, by name.
 */
export const sampleCalls = subjects.flatMap(([of, type, make, bytes]) =>
  type.getProperties().flatMap((property) => {
    const name = nameOf(property);
    if (name === null || name === "prototype") return [];
    const signatures = checker.getTypeOfSymbol(property).getCallSignatures();
    return signatures.map((signature) => {
      const list = parametersOf(checker, signature);
      const options = list.at(-1)?.name === "options" ? list.at(-1) : null;
      const parameters = (options ? list.slice(0, -1) : list).map((one) => one.name);
      const run = (changed = {}, ...rest) => {
        const object = make();
        const given = parameters.map((parameter) =>
          parameter in changed
            ? changed[parameter]
            : argumentOf(parameter, name, { object, bytes, parameters }),
        );
        const answer = object[name](...given, ...rest);
        // A generator runs when it is asked.
        return typeof answer?.next === "function" ? [...answer] : answer;
      };
      const keys = options && keysOf(checker, checker.getNonNullableType(options.type));
      return { of, name, parameters, keys, run };
    });
  }),
);
