// What TypeScript makes of the packed package's types.
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { capture } from "../../../tools/toolchain/process.mjs";
import { packed } from "./install_packed.mjs";

const consumer = `
import {
  ApolloniusError, Diagram, Voronoi, load, type ErrorCode, type Site,
} from "apollonius-diagram";
await0(load());
declare function await0(promise: Promise<void>): void;
interface City { lon: number; lat: number; people: number }
const cities: City[] = [];
const diagram: Diagram = Diagram.from(
  cities, (d) => d.lon, (d, i, all) => d.lat + i, (d) => Math.sqrt(d.people));
const site: Site = diagram.site(0);
const nearest: { id: number; distance: number } | null = diagram.nearest(site.x, site.y);
const ids: Int32Array = diagram.findMany(new Float64Array(4), new Float64Array(2));
const code: ErrorCode | undefined = new ApolloniusError("not-finite", "x").code;
// @ts-expect-error: no such code
const wrong: ErrorCode = "wrong";
// @ts-expect-error: numbers only
diagram.insert("1", 2);
// @ts-expect-error: cities have no x and y
Diagram.from(cities);
// @ts-expect-error: nor is one accessor enough
Diagram.from(cities, (d) => d.lon);
// @ts-expect-error: coordinates are numbers
Diagram.from([{ x: "1", y: "2" }]);
// @ts-expect-error: in arrays, too
Diagram.from([["1", "2"]]);
// @ts-expect-error: what an accessor gives is a number
Diagram.from(cities, (d) => String(d.lon), (d) => d.lat);
// @ts-expect-error: diagram.voronoi() makes it
new Voronoi(diagram, [0, 0, 1, 1]);
Diagram.from([{ x: 1, y: 2 }, { x: 1, y: 2, r: 3 }]);
Diagram.from([[1, 2], [1, 2, 3]], undefined, undefined, (d, i) => i);
Diagram.from(new Set([new Float32Array(2)]));
Diagram.from(diagram);
for (const { id, x, y, r, hidden } of diagram) diagram.update(id, x, y, hidden ? r : 2 * r);
const { ids: all, xyr } = diagram.sites();
diagram.updateMany(all, xyr);
export { nearest, ids, code, wrong };
`;
// needs TypeScript 5.2 and its library
const using = "{ using scoped = new Diagram([0, 0, 1]); scoped.size; }\n";
const separate =
  'import { Diagram, load } from "apollonius-diagram/wasm";\n' +
  'export const loading: Promise<void> = load(new URL("x:y"));\n' +
  "export const diagram = new Diagram();\n";

const strict = {
  strict: true,
  exactOptionalPropertyTypes: true,
  noEmit: true,
  types: [],
  skipLibCheck: false,
};
const newest = { target: "ES2022", lib: ["ES2023", "ESNext.Disposable", "DOM"] };
const oldest = { target: "ES2020", lib: ["ES2020", "DOM"] };

/**
 * Compiles users of the package, as ES modules and CommonJS, with both ways of resolution, and with
 * the newest library and ES2020's. Throws, with what the compiler says, if it finds an error.
 * @param {string} tsc the program
 */
export function compileUsers(tsc) {
  for (const [age, options] of Object.entries({ newest, oldest })) {
    const folder = path.join(packed, `types-${age}`);
    mkdirSync(folder, { recursive: true });
    const write = (name, text) => writeFileSync(path.join(folder, name), text);
    const text = age === "newest" ? consumer + using : consumer;
    write("esm.mts", text);
    write("cjs.cts", text);
    write("separate.mts", separate);
    for (const [name, compilerOptions, files] of [
      ["NodeNext", { module: "NodeNext" }, ["esm.mts", "cjs.cts", "separate.mts"]],
      ["Bundler", { module: "ESNext", moduleResolution: "Bundler" }, ["esm.mts", "separate.mts"]],
    ]) {
      const config = { compilerOptions: { ...strict, ...options, ...compilerOptions }, files };
      write(`${name}.json`, JSON.stringify(config));
      capture(process.execPath, [tsc, "-p", path.join(folder, `${name}.json`)]);
    }
  }
}
