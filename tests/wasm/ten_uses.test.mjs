// The ten uses that the interface was made for: one strict program, compiled against the packed
// package and run. Objects that only pages have (a context, a worker's other side) are stand-ins.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import ts from "typescript";
import { packed } from "./support/install_packed.mjs";
import { runInNode } from "./support/node.mjs";

const folder = path.join(packed, "ten_uses");

const kProgram = `
import { Diagram, type PathContext, type Region, type Voronoi } from "apollonius-diagram";
import { SphericalDiagram } from "apollonius-diagram/sphere";
import { treemap } from "apollonius-diagram/treemap";

interface Context extends PathContext {
  beginPath(): void;
  fill(): void;
  fillText(text: string, x: number, y: number): void;
}
/** As d3-hierarchy's nodes are declared. */
interface Tree<Datum> {
  readonly data: Datum;
  readonly depth: number;
  readonly height: number;
  readonly parent: this | null;
  readonly value?: number | undefined;
  readonly id?: string | undefined;
  children?: this[] | undefined;
  leaves(): this[];
}

export function hover(diagram: Diagram, x: number, y: number) {
  return diagram.pick(x, y, { maxDistance: 20 });
}

export function fillCells(diagram: Diagram, c: Context, w: number, h: number) {
  const view = diagram.voronoi([0, 0, w, h]);
  view.renderCells(c, () => c.fill());
}

export function move(diagram: Diagram, ids: Uint32Array, xy: Float64Array) {
  diagram.updateMany(ids, xy, { r: "keep" });
}

export function catchments(cities: { lon: number; lat: number; people: number }[]) {
  const globe = SphericalDiagram.from(cities, { radius: 6371 });
  return globe.voronoi({ maxDistance: 300 }).toGeoJSON({ tolerance: 1 });
}

export function label(root: Tree<{ name: string }>, c: Context, w: number, h: number) {
  for (const leaf of treemap().size([w, h])(root).leaves()) {
    const p = leaf.label({ aspect: 4 });
    if (p) c.fillText(leaf.data.name, p.x, p.y);
  }
}

export function nearestOpen(diagram: Diagram, x: number, y: number, isOpen: boolean[]) {
  return diagram.kNearest(x, y, 8, { filter: (id) => isOpen[id] });
}

export function reached(diagram: Diagram, district: Region, reach: number[]) {
  return diagram.voronoi(district, { maxDistance: (id) => reach[id]! }).cellAreas();
}

export function widest(diagram: Diagram, land: Region) {
  return diagram.voronoi(land).largestEmptyCircle({ inside: true });
}

export async function raster(
  view: Voronoi,
  values: number[],
  xy: Float64Array,
  signal: AbortSignal,
  onProgress: (share: number) => void,
) {
  return await view.interpolateAsync(values, xy, { signal, onProgress });
}

export async function inWorker(
  xyr: Float64Array,
  onProgress: (share: number) => void,
  postMessage: (message: Uint8Array, transfer: Transferable[]) => void,
) {
  const bytes = (await Diagram.fromAsync(xyr, { onProgress })).toBytes();
  postMessage(bytes, [bytes.buffer]);
}

export async function received(bytes: Uint8Array | ArrayBuffer) {
  return await Diagram.fromBytesAsync(bytes, { trusted: true });
}
`;

/** The compiler's messages; writes the program as JavaScript into `folder`. */
function compile() {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const file = path.join(folder, "uses.mts");
  writeFileSync(file, kProgram);
  const program = ts.createProgram([file], {
    strict: true,
    exactOptionalPropertyTypes: true,
    noUncheckedIndexedAccess: true,
    noUnusedLocals: true,
    declaration: true,
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.NodeNext,
    lib: ["lib.es2023.d.ts", "lib.esnext.disposable.d.ts", "lib.dom.d.ts"],
    types: [],
  });
  const said = [
    ...ts.getPreEmitDiagnostics(program),
    ...program.getDeclarationDiagnostics(),
    ...program.emit().diagnostics,
  ];
  return said.map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, " "));
}

test("the ten uses compile in strict TypeScript, with declarations that say what they give", () => {
  expect(compile()).toEqual([]);
  const declarations = readFileSync(path.join(folder, "uses.d.mts"), "utf8");
  expect(declarations).toMatch(/received\(bytes: Uint8Array \| ArrayBuffer\): Promise<Diagram>;/);
  expect(declarations).toMatch(
    /widest\(.*\): import\("apollonius-diagram"\)\.EmptyCircle \| null;/,
  );
});

test("the ten uses run", () => {
  expect(compile()).toEqual([]);
  const output = runInNode(`
    import * as uses from "./ten_uses/uses.mjs";
    import { Diagram } from "apollonius-diagram";
    const drawn = [];
    const context = new Proxy({}, {
      get: (_, call) => (...given) => void drawn.push([call, ...given]),
    });
    const count = (name) => drawn.filter(([call]) => call === name).length;
    const diagram = () => new Diagram([20, 20, 5, 80, 20, 10, 50, 80, 0, 21, 20, 1]);
    const square = [[0, 0], [100, 0], [100, 100], [0, 100]];
    const found = {};

    found.hover = [[20, 20], [45, 20], [50, 45]].map(([x, y]) => uses.hover(diagram(), x, y));

    uses.fillCells(diagram(), context, 100, 100);
    found.fillCells = [count("beginPath"), count("moveTo"), count("closePath"), count("fill")];

    const moved = diagram();
    uses.move(moved, Uint32Array.of(0, 1), Float64Array.of(1, 2, 3, 4));
    found.move = [moved.site(0), moved.site(1)];

    const { features } = uses.catchments([
      { lon: 2.35, lat: 48.86, people: 2e6 },
      { lon: 13.4, lat: 52.52, people: 4e6 },
      { lon: 179.9, lat: -17, people: 1e5 },
    ]);
    found.catchments = features.map(({ id, geometry }) => [id, geometry.type]);

    const leaves = ["a", "b", "c"].map((name, k) => ({ data: { name }, value: k + 1 }));
    const root = { data: { name: "all" }, value: 6, children: leaves, leaves: () => leaves };
    uses.label(root, context, 100, 50);
    found.label = drawn
      .filter(([call]) => call === "fillText")
      .map(([, text, x, y]) => [text, x > 0 && x < 100 && y > 0 && y < 50]);

    found.nearestOpen = [...uses.nearestOpen(diagram(), 0, 0, [true, false, true, true])];

    const areas = uses.reached(diagram(), [square], [1, 5, 2, 0]);
    found.reached = [36 * Math.PI, 225 * Math.PI, 4 * Math.PI, 0].map(
      (area, id) => Math.abs(areas[id] - area) < 1e-9,
    );

    const { x, y, r } = uses.widest(diagram(), [square]);
    found.widest = [x - r > -1e-9, x + r < 100 + 1e-9, y - r > -1e-9, y + r < 100 + 1e-9, r > 20];

    const shares = [];
    const push = (share) => shares.push(share);
    const { signal } = new AbortController();
    const view = diagram().voronoi([0, 0, 100, 100]);
    const at = Float64Array.of(20, 20, 50, 40);
    const values = await uses.raster(view, [1, 2, 3, 0], at, signal, push);
    found.raster = [values[0], values[1] > 1 && values[1] < 3, shares.at(-1)];
    const stopped = await uses
      .raster(view, [1, 2, 3, 0], at, AbortSignal.abort("enough"), push)
      .catch((reason) => reason);
    found.stopped = stopped;

    shares.length = 0;
    let arrived;
    await uses.inWorker(Float64Array.of(0, 0, 1, 9, 0, 2), push, (bytes, transfer) => {
      arrived = structuredClone(bytes, { transfer });
      found.left = bytes.length;
    });
    found.received = [];
    for (const bytes of [arrived, arrived.buffer])
      found.received.push((await uses.received(bytes)).find(8, 0));
    found.built = shares.at(-1);
    console.log(JSON.stringify(found));`);
  expect(JSON.parse(output)).toEqual({
    hover: [3, 0, -1],
    fillCells: [3, 3, 3, 3],
    move: [
      { x: 1, y: 2, r: 5 },
      { x: 3, y: 4, r: 10 },
    ],
    catchments: [
      [0, "Polygon"],
      [1, "Polygon"],
      [2, "MultiPolygon"],
    ],
    label: [
      ["a", true],
      ["b", true],
      ["c", true],
    ],
    nearestOpen: [0, 3, 2],
    reached: [true, true, true, true],
    widest: [true, true, true, true, true],
    raster: [1, true, 1],
    stopped: "enough",
    left: 0,
    received: [1, 1],
    built: 1,
  });
});
