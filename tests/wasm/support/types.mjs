// The packed package's types, as TypeScript reads them.
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { capture } from "../../../tools/toolchain/process.mjs";
import { packed } from "./install_packed.mjs";

const consumer = `
import {
  ApolloniusError, Diagram, curvePoint, load,
  type AreaTargets, type CellGeometry, type CellMesh, type CellPolygon, type CellRing,
  type Disc, type ErrorCode, type Voronoi, type WindowShape,
  type FittedAreas, type PolygonOptions, type Region, type Site,
} from "apollonius-diagram";
import {
  levels, predicateCounts, validate, type PredicateCounts, type StageCounts,
} from "apollonius-diagram/diagnostics";
import { SphericalDiagram } from "apollonius-diagram/sphere";
await0(load());
declare function await0(promise: Promise<void>): void;
interface City { lon: number; lat: number; people: number }
const cities: City[] = [];
const diagram: Diagram = Diagram.from(
  cities, (d) => d.lon, (d, i, all) => d.lat + i, (d) => Math.sqrt(d.people));
const site: Site = diagram.site(0);
const nearest: { id: number; distance: number } | null = diagram.nearest(site.x, site.y);
const ids: Int32Array = diagram.findMany(new Float64Array(4), { maxDistance: 2 });
const far: Float64Array = diagram.nearestMany([0, 0], { filter: () => 1 }).distances;
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
Diagram.from([[1, 2], [1, 2, 3]], { r: 1 });
Diagram.from(new Float64Array(6));
new Diagram(new Float32Array(4), { r: 0 });
diagram.insertMany([0, 0], { r: 1 });
diagram.updateMany([0], [0, 0], { r: "keep" });
// @ts-expect-error: nothing else is kept
diagram.updateMany([0], [0, 0], { r: "own" });
Diagram.from(new Set([new Float32Array(2)]));
Diagram.from(diagram);
for (const { id, x, y, r, hidden } of diagram) diagram.update(id, x, y, hidden ? r : 2 * r);
const { ids: all, xyr } = diagram.sites();
diagram.updateMany(all, xyr);
// @ts-expect-error: ids are numbers
diagram.remove("0");
diagram.within(0, 0, Infinity);
const filter = (id: number) => id > 3;
diagram.find(0, 0, { filter });
diagram.nearest(0, 0, { filter })?.distance.toFixed();
diagram.findMany([0, 0], { filter });
diagram.pick(0, 0, { filter, top: "last" });
diagram.pick(0, 0, { maxDistance: 7, filter });
const picked: Int32Array = diagram.pickMany([0, 0], { top: "smallest" });
// @ts-expect-error: only one of them
diagram.findMany([0, 0], { filter }, { filter });
// @ts-expect-error: no such option
diagram.find(0, 0, { fitler: filter });
// @ts-expect-error: a limit is an option
diagram.pick(0, 0, 20);

const { signal } = new AbortController();
const early: Promise<Diagram> = Diagram.fromAsync([[1, 2]], { signal });
Diagram.fromAsync(cities, (d) => d.lon, (d) => d.lat, undefined, { signal });
Diagram.fromAsync(new Float64Array(6), { signal });
Diagram.fromAsync(cities, (d) => d.lon, (d) => d.lat, { signal });
Diagram.from(cities, (d) => d.lon, (d) => d.lat);
// @ts-expect-error: cities have no x and y
Diagram.fromAsync(cities, { signal });
// @ts-expect-error: no such option
Diagram.fromAsync([[1, 2]], { sinal: signal });

const polygon = { type: "Polygon" as const, coordinates: [[[0, 0], [1, 0], [1, 1]]] };
const feature = { type: "Feature" as const, properties: null, geometry: polygon };
const collection = { type: "FeatureCollection" as const, features: [feature] };
const view = diagram.voronoi(collection);
diagram.voronoi({ type: "Feature", geometry: { type: "Polygon", coordinates: [[[0, 0]]] } });
const ring: [number, number][] | null = view.cellPolygon(0);
const flat: Float64Array | null = view.cellPolygon(0, { tolerance: 1, flat: true });
// @ts-expect-error: not without flat
const notFlat: Float64Array | null = view.cellPolygon(0, { tolerance: 1 });
// @ts-expect-error: rings are nested by default
view.cellPolygon(0, { nested: true });
const options: PolygonOptions = {};
const either: CellRing | null = view.cellPolygon(0, options);
for (const cell of view.cellPolygons()) cell.map(([x, y]) => x + y + cell.index);
for (const cell of view.cellPolygons({ flat: true })) cell.subarray(cell.index);
const firstCell: CellPolygon | undefined = [...view.cellPolygons({ flat: false })][0];
const regions: [number, number][][][] = view.cellParts(0) ?? [];
const holes: Float64Array[] = (view.cellParts(0, { flat: true }) ?? []).flatMap(
  ([, ...rings]) => rings);
const disc: Disc = { x: 0, y: 0, r: 5 };
const shapes: WindowShape[] = [[0, 0, 1, 1], disc, polygon];
// @ts-expect-error: a disc has an r
diagram.voronoi({ x: 0, y: 0, radius: 5 });
const geometry: CellGeometry | null = view.cellGeometry(0, { winding: "clockwise" });
const mesh: CellMesh = view.cellMesh({ tolerance: 1 });
const area: number = view.cellArea(0) + view.cellMeasures(0).area;
const limited: Voronoi[] = [5, [5], new Map([[0, 5]]), { 0: 5 }, (id: number) => id].map(
  (maxDistance) => diagram.voronoi(shapes[0], { maxDistance }));
// @ts-expect-error: a type, no constructor
new Voronoi(diagram);
// @ts-expect-error: r is an option
view.naturalWeights(0, 0, 1);
view.naturalWeights(0, 0, { r: 1 });
const windows: Region[] = [
  polygon, feature, regions, regions[0]!, holes, view.toGeoJSON(), ring ?? [],
];
for (const window of windows) diagram.voronoi(window);

const targets: AreaTargets[] = [[1], new Float64Array(1), new Map([[0, 1]]), { 0: 1 }];
const fitted: FittedAreas = view.fitAreas(targets[0]!, { strict: true });
const outcome: [boolean, string | undefined] = [fitted.converged, fitted.reason];
const later: Promise<FittedAreas> = view.fitAreasAsync(new Map([[0, 1]]), {
  signal,
  onProgress: (done: number) => done,
});
// @ts-expect-error: that one cannot be aborted
view.fitAreas([1], { signal });
// @ts-expect-error: targets are numbers
view.fitAreas({ 0: "1" });
const point: [number, number] = curvePoint(view.edgeCurves().curves, 0, 0.5);
const gaps: [Float64Array, Float64Array] = [
  view.edges({ clearance: true }).clearance, diagram.edges({ clearance: true }).xy,
];
// @ts-expect-error: nobody has asked for it
diagram.edges().clearance;
// @ts-expect-error: no such option
view.edges({ clearances: true });
const broken: (string | null)[] = [validate(diagram), validate(new SphericalDiagram())];
const depths: Uint8Array = levels(diagram);
// @ts-expect-error: of the plane only
levels(new SphericalDiagram());
// @ts-expect-error: a function, no method
diagram.validate();
const counts: PredicateCounts = predicateCounts();
const stages: StageCounts = counts.covers;
const ends: [Int32Array, Float64Array] = [view.vertices().sites, diagram.vertices().xy];
declare const context: CanvasRenderingContext2D | null | undefined;
const path: string | void = view.render(context);
const sides: string = view.renderBounds(null, { digits: 2 });
export { nearest, ids, code, wrong, early, flat, notFlat, either, firstCell, outcome, later };
export { path, point, sides, geometry, mesh, area, limited, broken, depths, stages };
`;
// The entries among each other: their types are equal, or name the calls that are missing.
const together = `
import { Diagram, type DiagramClass, type Voronoi } from "apollonius-diagram";
import { Diagram as Core } from "apollonius-diagram/core";
import { edges, renderSites, voronoi, type Voronoi as View } from "apollonius-diagram/shapes";
import { SphericalDiagram } from "apollonius-diagram/sphere";
import { treemap } from "apollonius-diagram/treemap";
import {
  Diagram as Separate, SphericalDiagram as SeparateGlobe, treemap as separateTreemap,
  type Voronoi as SeparateVoronoi,
} from "apollonius-diagram/wasm";

const whole = new Diagram([0, 0, 1]);
const bare: Core = whole;
const same: Separate = whole;
const back: Diagram = same;
const globe: SeparateGlobe = new SphericalDiagram();
const layouts: typeof separateTreemap = treemap;
const view: Voronoi = whole.voronoi([0, 0, 1, 1]);
const separate: SeparateVoronoi = view;
const ofShapes: View[] = [view, voronoi(whole), voronoi(bare)];
const again: Voronoi = view.diagram.voronoi();
const drawn: string[] = [renderSites(bare), whole.renderSites()];
const gaps: Float64Array = edges(bare, { clearance: true }).clearance;
const made: DiagramClass = Diagram;
const paths: string[] = [
  Diagram.from([[0, 0]]).render(), Diagram.from([1], (x) => x, (x) => x).render(),
  Diagram.fromBytes(whole.toBytes()).render(), made.from(whole, { r: 1 }).renderHull(),
  whole.update(0, 1, 1).render(),
];
Diagram.fromAsync([[0, 0]]).then((diagram) => diagram.smallestEnclosingCircle()?.sites);
// @ts-expect-error: shapes has it
bare.voronoi();
// @ts-expect-error: so has it this one
bare.edges({ clearance: true });
// @ts-expect-error: a part of the other
const missing: Diagram = bare;
// @ts-expect-error: whose diagram may have no methods of shapes
const wrongView: Voronoi = ofShapes[0]!;
// @ts-expect-error: another surface
const flat: Core = globe;

class Mine extends Diagram {
  readonly label = "mine";
  override insert(x: number, y: number, r: number = 1): number {
    return super.insert(x, y, r);
  }
  area(): number {
    return this.voronoi().cellAreas().length + this.size;
  }
}
const mine = new Mine([0, 0], { r: 1 });
const asWhole: Diagram = mine;
export function cells(one: unknown): Voronoi | string | null {
  if (one instanceof Mine) return one.label;
  if (one instanceof Core) one.find(0, 0);
  return one instanceof Diagram ? one.voronoi() : null;
}
export { again, asWhole, back, drawn, flat, gaps, layouts, missing, paths, separate, wrongView };
`;
// needs TypeScript 5.2 and its library
const using = "{ using scoped = new Diagram([0, 0, 1]); scoped.size; }\n";
const separate =
  'import { Diagram, load } from "apollonius-diagram/wasm";\n' +
  'export const loading: Promise<void> = load({ core: new URL("x:y") });\n' +
  "export const diagram = new Diagram();\n";

const strict = {
  strict: true,
  exactOptionalPropertyTypes: true,
  noEmit: true,
  types: [],
  skipLibCheck: false,
  skipDefaultLibCheck: true, // TypeScript's own types
};
const newest = { target: "ES2022", lib: ["ES2023", "ESNext.Disposable", "DOM"] };
const oldest = { target: "ES2020", lib: ["ES2020", "DOM"] };

/** For each way of resolution: the options that choose it, and the ending of its files. */
const resolutions = {
  node10: [{ module: "CommonJS", moduleResolution: "Node10" }, ["cts"]],
  node16: [{ module: "Node16" }, ["mts", "cts"]],
  nodenext: [{ module: "NodeNext" }, ["mts", "cts"]],
  bundler: [{ module: "ESNext", moduleResolution: "Bundler" }, ["mts"]],
};

/**
 * Compiles users of the package, as ES modules and CommonJS: with the newest library and all ways
 * of resolution, and with ES2020's library. Throws the compiler's output if it finds an error.
 * @param {string} tsc the program
 * @param {string[]} without ways of resolution that it does not know
 */
export function compileUsers(tsc, without = []) {
  for (const [age, options] of Object.entries({ newest, oldest })) {
    const folder = path.join(packed, `types-${age}`);
    mkdirSync(folder, { recursive: true });
    const programs = {
      user: age === "newest" ? consumer + using : consumer,
      separate,
      together,
    };
    const ways = age === "newest" ? Object.keys(resolutions) : ["nodenext"];
    for (const way of ways.filter((one) => !without.includes(one))) {
      const [resolution, endings] = resolutions[way];
      const files = [];
      for (const [name, text] of Object.entries(programs)) {
        for (const ending of endings) {
          files.push(`${name}.${ending}`);
          writeFileSync(path.join(folder, files.at(-1)), text);
        }
      }
      const config = { compilerOptions: { ...strict, ...options, ...resolution }, files };
      writeFileSync(path.join(folder, `${way}.json`), JSON.stringify(config));
      capture(process.execPath, [tsc, "-p", path.join(folder, `${way}.json`)]);
    }
  }
}
