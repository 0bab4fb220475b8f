// `treemap()`: its methods, and the layout made at once or in slices.
import {
  checkedChoice,
  checkedCount,
  checkNumber,
  checkOptions,
  described,
} from "../core/arguments.js";
import { Slices } from "../core/building.js";
import type { DrawOptions, PathContext } from "../core/path.js";
import { ApolloniusError } from "../errors.js";
import { innerCircle } from "../shapes/inner_circle.js";
import type { CellCircle, FittedAreas } from "../shapes/types.js";
import type { Cell } from "./cells.js";
import { drawOutline } from "./drawing.js";
import type { Request } from "./fit.js";
import { layOut } from "./groups.js";
import { joined } from "./rings.js";
import { type Input, nodesOf, type Settings, valuesOf } from "./settings.js";
import type { Treemap, TreemapCell, TreemapOptions } from "./types.js";

/** What is begun: nodes, values, and the work on their cells. */
function begin(root: Input, settings: Settings) {
  const nodes = nodesOf(root);
  const values = valuesOf(nodes, settings);
  return { nodes, values, work: layOut(root, values, settings) };
}

/** One step of the work: answers a request, with what came of it or with the error. */
function answered<Result>(
  work: Generator<Request, Result, FittedAreas>,
  answer: { found: FittedAreas } | { failure: unknown },
): IteratorResult<Request, Result> {
  return "found" in answer ? work.next(answer.found) : work.throw(answer.failure);
}

function layOutAtOnce(root: Input, settings: Settings): void {
  const { nodes, values, work } = begin(root, settings);
  let step = work.next();
  while (!step.done) {
    const { view, targets, options } = step.value;
    let answer: Parameters<typeof answered>[1];
    try {
      answer = { found: view.fitAreas(targets, options) };
    } catch (failure) {
      answer = { failure };
    }
    step = answered(work, answer);
  }
  finish(nodes, values, step.value, settings);
}

async function layOutInSlices(
  root: Input,
  settings: Settings,
  options: TreemapOptions | undefined,
): Promise<void> {
  checkOptions(options, "signal", "onProgress");
  const slices = new Slices(options ?? {});
  const { signal } = options ?? {};
  const { nodes, values, work } = begin(root, settings);
  try {
    let step = work.next();
    while (!step.done) {
      const { view, targets, options, done } = step.value;
      if (slices.isOver) await slices.next(done);
      let answer: Parameters<typeof answered>[1];
      try {
        answer = { found: await view.fitAreasAsync(targets, { ...options, signal }) };
      } catch (failure) {
        slices.expectNoAbort();
        answer = { failure };
      }
      step = answered(work, answer);
    }
    await slices.next(1);
    finish(nodes, values, step.value, settings);
  } finally {
    work.return(new Map()); // frees its diagrams
  }
}

/** Gives the nodes what was found. */
function finish(
  nodes: readonly Input[],
  values: ReadonlyMap<Input, number>,
  cells: ReadonlyMap<Input, Cell>,
  { value }: Settings,
): void {
  for (const node of nodes) {
    if (value !== null) Object.assign(node, { value: values.get(node) });
    Object.assign(node, resultOf(cells.get(node)));
    defineLabel(node, cells.get(node));
  }
}

/** The node's label, which is looked for when it is asked for. */
function defineLabel(node: Input, cell: Cell | undefined): void {
  let label: CellCircle | null | undefined;
  const get = () => (label ??= labelOf(cell));
  Object.defineProperty(node, "label", { get, enumerable: true, configurable: true });
}

function labelOf(cell: Cell | undefined): CellCircle | null {
  if (cell === undefined) return null;
  const { frame, outline } = cell;
  const { x, y, r } = innerCircle(outline.curves, 1);
  return { x: frame.x + frame.scale * x, y: frame.y + frame.scale * y, r: frame.scale * r };
}

function resultOf(cell: Cell | undefined): Omit<TreemapCell, "label"> {
  const frame = cell?.frame ?? { x: 0, y: 0, scale: 1 };
  const outline = cell?.outline ?? null;
  const render = (context?: PathContext | null, options?: Pick<DrawOptions, "digits">) => {
    checkOptions(options, "digits");
    return drawOutline(outline, frame, context, options) as string;
  };
  if (cell === undefined)
    return { area: 0, centroid: null, polygon: null, site: null, fit: null, render };
  const { area, x, y, rings, site, fit } = cell;
  return {
    area: area * frame.scale * frame.scale,
    centroid: [frame.x + frame.scale * x, frame.y + frame.scale * y],
    polygon: joined(rings, frame),
    site,
    fit,
    render,
  };
}

function checkFunction(name: string, value: unknown, other?: null): void {
  if (typeof value === "function" || value === other) return;
  throw new ApolloniusError("bad-option", `${name} is ${described(value)}, expected a function`);
}

const kMostRounds = 1000;

/** Throws unless the setting can be that; what concerns single nodes is found when they are. */
function checkSetting(name: keyof Settings, value: unknown): void {
  if (name === "seed") checkNumber(name, value);
  else if (name === "rounds") {
    if (checkedCount(name, value) > kMostRounds)
      throw new ApolloniusError(
        "out-of-range",
        `rounds is ${value}, expected at most ${kMostRounds}`,
      );
  } else if (name === "sites") checkedChoice(name, value, ["move", "stay"]);
  else if (name === "padding" && typeof value !== "function") checkNumber(name, value);
  else if (name === "value" || name === "position" || name === "key")
    checkFunction(name, value, null);
  else if ((name === "previous" && value !== null) || name === "shape") {
    if (typeof value !== "object" || value === null)
      throw new ApolloniusError("bad-option", `${name} is ${described(value)}, expected an object`);
  }
}

/**
 * A new layout of cells within cells, with curved borders and exact areas: see `Treemap`. O(1).
 *
 *     const root = hierarchy(data).sum((d) => d.size);
 *     treemap().shape([0, 0, 800, 600])(root);
 *     for (const leaf of root.leaves()) leaf.render(context);
 */
// biome-ignore lint/suspicious/noExplicitAny: JavaScript has no words for the type of data
export function treemap<Datum = any>(): Treemap<Datum> {
  const settings: Settings = {
    shape: [0, 0, 1, 1],
    value: null,
    padding: 0,
    sites: "move",
    rounds: 8,
    position: null,
    seed: 0,
    previous: null,
    key: null,
  };
  const layout = (root: Input) => {
    layOutAtOnce(root, { ...settings });
    return root;
  };
  const methods = Object.fromEntries(
    (Object.keys(settings) as (keyof Settings)[]).map((name) => [
      name,
      (...given: unknown[]) => {
        if (given.length === 0) return settings[name];
        checkSetting(name, given[0]);
        Object.assign(settings, { [name]: given[0] });
        return layout;
      },
    ]),
  );
  const inSlices = async (root: Input, options?: TreemapOptions) => {
    await layOutInSlices(root, { ...settings }, options);
    return root;
  };
  return Object.assign(layout, methods, { async: inSlices }) as unknown as Treemap<Datum>;
}
