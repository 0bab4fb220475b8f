// `treemap()`: its methods, and the layout made at once or in slices.
import {
  checkedChoice,
  checkedCount,
  checkNumber,
  checkOptions,
  described,
  isArrayLike,
} from "../core/arguments.js";
import { Slices } from "../core/building.js";
import type { DrawOptions, PathContext } from "../core/path.js";
import { ApolloniusError } from "../errors.js";
import { checkedAspect } from "../shapes/circles.js";
import { innerCircle } from "../shapes/functions.js";
import type { CellCircle, CellCircleOptions, FittedAreas } from "../shapes/types.js";
import { type Cell, shapeOf } from "./cells.js";
import { drawOutline } from "./drawing.js";
import type { Request } from "./fit.js";
import { layOut } from "./groups.js";
import { joined } from "./rings.js";
import { checkedPadding, type Input, nodesOf, type Settings, valuesOf } from "./settings.js";
import type {
  Treemap,
  AsyncTreemapOptions,
  TreemapCell,
  TreemapNode,
  TreemapOptions,
  TreemapShape,
} from "./types.js";

/** Begins a layout: nodes, values, and the work on their cells. */
function begin(root: Input, settings: Settings, options: TreemapOptions | undefined) {
  const previous = options?.previous ?? null;
  if (previous !== null && (typeof previous !== "object" || !("centroid" in previous)))
    throw new ApolloniusError(
      "bad-option",
      `options.previous is ${described(previous)}, expected a root with cells`,
    );
  const nodes = nodesOf(root);
  const values = valuesOf(nodes, settings);
  return { nodes, values, work: layOut(root, values, settings, previous) };
}

/** One step of the work: answers a request, with what came of it or with the error. */
function answered<Result>(
  work: Generator<Request, Result, FittedAreas>,
  answer: { found: FittedAreas } | { failure: unknown },
): IteratorResult<Request, Result> {
  return "found" in answer ? work.next(answer.found) : work.throw(answer.failure);
}

function layOutAtOnce(root: Input, settings: Settings, options: TreemapOptions | undefined): void {
  checkOptions(options, "previous");
  const { nodes, values, work } = begin(root, settings, options);
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
  options: AsyncTreemapOptions | undefined,
): Promise<void> {
  checkOptions(options, "previous", "signal", "onProgress");
  const slices = new Slices(options ?? {});
  const { signal } = options ?? {};
  const { nodes, values, work } = begin(root, settings, options);
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
  { value, shape }: Settings,
): void {
  for (const node of nodes) {
    if (value !== null) Object.assign(node, { value: values.get(node) });
    Object.assign(node, resultOf(cells.get(node), shape.tolerance));
  }
}

function resultOf(cell: Cell | undefined, tolerance: number): TreemapCell {
  const frame = cell?.frame ?? { x: 0, y: 0, scale: 1 };
  const outline = cell?.outline ?? null;
  let last: (CellCircle & { readonly of: number }) | undefined;
  const label = (options?: CellCircleOptions) => {
    const aspect = checkedAspect(options);
    if (outline === null) return null;
    if (last?.of !== aspect) last = { ...innerCircle(outline, aspect), of: aspect };
    const { x, y, r } = last;
    return { x: frame.x + frame.scale * x, y: frame.y + frame.scale * y, r: frame.scale * r };
  };
  const render = (context?: PathContext | null, options?: DrawOptions) =>
    drawOutline(outline, frame, tolerance, context, options) as string;
  if (cell === undefined)
    return { area: 0, centroid: null, polygon: null, circle: null, fit: null, label, render };
  const { area, x, y, rings, circle, fit } = cell;
  return {
    area: area * frame.scale * frame.scale,
    centroid: [frame.x + frame.scale * x, frame.y + frame.scale * y],
    polygon: joined(rings, frame),
    circle,
    fit,
    label,
    render,
  };
}

const kMostRounds = 1000;

/** Gives a setting as it is kept, or throws. What functions return is checked by the layout. */
function checkedSetting(name: keyof Settings, value: unknown): unknown {
  if (name === "shape") return shapeOf(value as TreemapShape);
  if (name === "seed") checkNumber(name, value);
  else if (name === "rounds") {
    if (checkedCount(name, value) > kMostRounds)
      throw new ApolloniusError(
        "out-of-range",
        `rounds is ${value}, expected at most ${kMostRounds}`,
      );
  } else if (name === "sites") return checkedChoice(name, value, ["move", "stay"]);
  else if (typeof value === "function") return value;
  else if (name === "padding") checkedPadding(name, value);
  else if (value !== null)
    throw new ApolloniusError("bad-option", `${name} is ${described(value)}, expected a function`);
  return value;
}

/** Bounds from the origin on; throws "bad-bounds". */
function boundsOfSize(size: unknown): TreemapShape {
  if (!isArrayLike(size) || size.length !== 2)
    throw new ApolloniusError("bad-bounds", `size is ${described(size)}, expected [width, height]`);
  return [0, 0, size[0] as number, size[1] as number];
}

/**
 * A new layout of cells within cells, with curved borders and exact areas: see `Treemap`. O(1).
 *
 *     const root = hierarchy(data).sum((d) => d.size);
 *     for (const leaf of treemap().size([800, 600])(root).leaves()) leaf.render(context);
 */
export function treemap<
  // biome-ignore lint/suspicious/noExplicitAny: JavaScript has no words for the type of data
  Datum = any,
  Node extends TreemapNode<Datum> = TreemapNode<Datum>,
>(): Treemap<Datum, Node> {
  const given: { [Name in keyof Settings]: unknown } = {
    shape: [0, 0, 1, 1],
    value: null,
    padding: 0,
    sites: "move",
    rounds: 8,
    position: null,
    seed: 0,
    key: null,
  };
  const settings = { ...given, shape: shapeOf(given.shape as TreemapShape) } as Settings;
  const layout = (root: Input, options?: TreemapOptions) => {
    layOutAtOnce(root, { ...settings }, options);
    return root;
  };
  const set = (name: keyof Settings, value: unknown) => {
    const checked = checkedSetting(name, value);
    Object.assign(settings, { [name]: checked });
    given[name] = name === "shape" ? value : checked;
    return layout;
  };
  const methods = Object.fromEntries(
    (Object.keys(given) as (keyof Settings)[]).map((name) => [
      name,
      (...values: unknown[]) => (values.length === 0 ? given[name] : set(name, values[0])),
    ]),
  );
  const size = (...values: unknown[]) => {
    if (values.length > 0) return set("shape", boundsOfSize(values[0]));
    const { bounds } = settings.shape;
    return bounds && bounds[0] === 0 && bounds[1] === 0 ? bounds.slice(2) : null;
  };
  const inSlices = async (root: Input, options?: AsyncTreemapOptions) => {
    await layOutInSlices(root, { ...settings }, options);
    return root;
  };
  return Object.assign(layout, methods, { size, async: inSlices }) as unknown as Treemap<
    Datum,
    Node
  >;
}
