// The instance of the wasm module that diagrams share: made at the first use, never at import.
// After a call that ended in its middle, what is made later gets a new one.
import { ApolloniusError } from "./errors.js";

/**
 * Numbers that are addresses in the module's memory. Above 2^31 they come out negative: `>>> 0`
 * where one is used.
 */
type Address = number;
/** Error codes as integers, 0 for success: the order of `Error` in src/apollonius/diagram.h. */
export type Status = number;
type Flag = number | boolean;

/** The whole memory; other arrays whenever it has grown. */
export interface Heap {
  bytes: Uint8Array<ArrayBuffer>;
  integers: Int32Array<ArrayBuffer>;
  words: Uint32Array<ArrayBuffer>;
  doubles: Float64Array<ArrayBuffer>;
}

/** What wasm/bindings.cpp exports. */
export interface NativeExports {
  readonly memory: { readonly buffer: ArrayBuffer; grow(pages: number): number };
  readonly __stack_pointer: { value: Address };
  _initialize(): void;

  resultsAddress(): Address;
  reserve(bytes: number): Address;
  release(): void;
  abandon(): void;

  diagramCreate(hierarchy: Flag): Address;
  diagramDestroy(diagram: Address): void;
  diagramClear(diagram: Address): void;
  diagramInsertMany(diagram: Address, count: number): Status;
  diagramRemoveMany(diagram: Address, ids: Address, count: number): Status;
  diagramUpdateMany(diagram: Address, ids: Address, xyr: Address, count: number): Status;
  diagramFindMany(
    diagram: Address,
    xy: Address,
    ids: Address,
    distances: Address,
    count: number,
  ): Status;
  diagramIds(diagram: Address): Status;
  diagramVertices(diagram: Address): Status;
  diagramEdges(diagram: Address): Status;
  diagramValidate(diagram: Address): Status;
  diagramToBytes(diagram: Address): Status;
  diagramFromBytes(diagram: Address, content: Address, length: number, isTrusted: Flag): Status;

  diagramInsert(diagram: Address, x: number, y: number, r: number): Status;
  diagramRemove(diagram: Address, id: number): Status;
  diagramUpdate(diagram: Address, id: number, x: number, y: number, r: number): Status;
  diagramFind(diagram: Address, x: number, y: number): Status;
  diagramKNearest(diagram: Address, x: number, y: number, k: number): Status;
  diagramWithin(diagram: Address, x: number, y: number, distance: number): Status;
  diagramHas(diagram: Address, id: number): Flag;
  diagramSite(diagram: Address, id: number): Status;
  diagramIsHidden(diagram: Address, id: number): Status;
  diagramCoverOf(diagram: Address, id: number): Status;
  diagramNeighbors(diagram: Address, id: number): Status;
  diagramSize(diagram: Address): number;
  diagramVisibleSize(diagram: Address): number;

  toleranceFor(xmin: number, ymin: number, xmax: number, ymax: number): number;
  diagramExtent(diagram: Address): void;
  diagramHull(diagram: Address): Status;
  diagramDraw(
    diagram: Address,
    what: number,
    xmin: number,
    ymin: number,
    xmax: number,
    ymax: number,
    tolerance: number,
    cursor: number,
    commands: number,
  ): Status;
  voronoiDrawCell(
    diagram: Address,
    xmin: number,
    ymin: number,
    xmax: number,
    ymax: number,
    id: number,
    tolerance: number,
  ): Status;
  voronoiPolygon(
    diagram: Address,
    xmin: number,
    ymin: number,
    xmax: number,
    ymax: number,
    id: number,
    tolerance: number,
  ): Status;
  voronoiCell(
    diagram: Address,
    xmin: number,
    ymin: number,
    xmax: number,
    ymax: number,
    id: number,
  ): Status;
  voronoiEdges(diagram: Address, xmin: number, ymin: number, xmax: number, ymax: number): Status;
  voronoiMeasures(
    diagram: Address,
    xmin: number,
    ymin: number,
    xmax: number,
    ymax: number,
    id: number,
  ): Status;
  voronoiMeasuresWithin(diagram: Address, id: number, radius: number): Status;
  voronoiAreas(diagram: Address, xmin: number, ymin: number, xmax: number, ymax: number): Status;
}

export interface NativeModule {
  readonly call: NativeExports;
  readonly heap: Heap;
}

/** Gives the compiled module synchronously, or throws if that entry of the package cannot. */
type ModuleSource = () => WebAssembly.Module;

let source: ModuleSource | undefined;
let instance: NativeModule | undefined;

/**
 * Tells where the first use gets the compiled module from. Each entry of the package calls this
 * once.
 */
export function setModuleSource(moduleSource: ModuleSource): void {
  source = moduleSource;
}

/** The running module; compiled and started now if this is the first use. */
export function runningModule(): NativeModule {
  return instance ?? start((source as ModuleSource)());
}

export function isRunning(): boolean {
  return instance !== undefined;
}

/** Starts a compiled module unless one runs already. */
export function start(compiled: WebAssembly.Module): NativeModule {
  return (instance ??= started(compiled));
}

function started(compiled: WebAssembly.Module): NativeModule {
  const heap = {} as Heap;
  const view = () => {
    const { buffer } = raw.memory;
    heap.bytes = new Uint8Array(buffer);
    heap.integers = new Int32Array(buffer);
    heap.words = new Uint32Array(buffer);
    heap.doubles = new Float64Array(buffer);
  };
  const env = {
    /**
     * Lets the memory have so many bytes and, where there are some, a few more: growing it costs
     * some microseconds.
     */
    grow(wanted: number): Flag {
      const bytes = wanted >>> 0,
        { memory } = raw;
      for (const more of [Math.min(bytes / 5, 1 << 22), 0]) {
        try {
          memory.grow(Math.ceil((bytes + more - heap.bytes.length) / 65536));
          view();
          return 1;
        } catch {} // not even what was asked for: malloc fails
      }
      return 0;
    },
    report(name: Address): void {
      const text = heap.bytes.subarray(name, heap.bytes.indexOf(0, name));
      try {
        console.error("apollonius: broken invariant:", String.fromCharCode(...text));
      } catch {} // into C++ it would look like a lack of memory
    },
  };
  const raw = new WebAssembly.Instance(compiled, { env }).exports as unknown as NativeExports;
  view();
  raw._initialize();
  const module = {
    heap,
    call: guarded(raw, () => {
      view();
      try {
        if (instance === module) instance = started(compiled);
      } catch {} // no memory for another: this one goes on
    }),
  };
  return module;
}

type Call = (diagram: number, ...rest: number[]) => number;

/**
 * The exports, each guarded against what ends a call in its middle: a trap, which is a defect of
 * the library, or an exhausted stack, which nothing foresees. The diagram of that call may be half
 * changed: from then on it is broken, every call of it throws, and its memory is never given back,
 * as its destructor might follow a wrong address. All others find the stack and the shared blocks
 * as they have to be.
 */
function guarded(raw: NativeExports, retire: () => void): NativeExports {
  const stack = raw.__stack_pointer,
    top = stack.value;
  const broken = new Set<Address>();
  // the diagram of the call that is under way; 0 if that is about none
  let running: Address | undefined;

  /**
   * Sets things right after a call that ended in its middle. At the end of the stack this may fail
   * itself: then the next call does it.
   */
  const settle = (diagram: Address) => {
    broken.add((running = diagram));
    stack.value = top;
    raw.abandon();
    retire();
    running = undefined;
  };
  const failure = (cause?: unknown) =>
    new ApolloniusError(
      "broken",
      "a call of this diagram ended in its middle: please report it, unless no stack was left",
      { cause },
    );

  const call: Record<string, unknown> = { ...raw };
  for (const [name, plain] of Object.entries(raw)) {
    if (typeof plain !== "function") continue;
    const isOfDiagram = /^(diagram(?!Create)|voronoi)/.test(name);
    // As many parameters as any has: a list of the rest would be made anew for each call.
    call[name] = (
      a: number,
      b: number,
      c: number,
      d: number,
      e: number,
      f: number,
      g: number,
      h: number,
      i: number,
    ) => {
      const diagram = isOfDiagram ? a : 0;
      if (running !== undefined) settle(running);
      if (diagram !== 0 && broken.size !== 0 && broken.has(diagram)) {
        if (name === "diagramDestroy") return;
        throw failure();
      }
      running = diagram;
      try {
        const result = (plain as Call)(a, b, c, d, e, f, g, h, i);
        running = undefined;
        return result;
      } catch (error) {
        settle(diagram);
        throw failure(error);
      }
    };
  }
  return call as unknown as NativeExports;
}
