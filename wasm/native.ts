// One diagram inside the wasm module, with typed arrays instead of heap addresses: no other file
// knows an address, and no view of the heap leaves this one (a view dies when the memory grows).
// Layout of the shared blocks: wasm/bindings.cpp.
import { ApolloniusError } from "./errors.js";
import { type Heap, type NativeExports, runningModule, type Status } from "./module.js";

export type { Status };
const kOutOfMemory: Status = 5;

/** "No site": not a valid id, and what the library answers when there is none. */
export const kNoSite = 0xffffffff;

// Blocks in the heap of up to this size stay allocated for the next call: giving one back costs a
// call.
const kKeptBytes = 1 << 18;

// More than this many bytes a 32-bit heap never has; beyond 2^32 the address arithmetic would wrap.
const kMostBytes = 0xffff_0000;

// Byte offsets in `Results` of wasm/bindings.cpp.
const kX = 0;
const kY = 8;
const kR = 16;
const kDistance = 24;
const kId = 32;
const kFlag = 36;
const kAddresses = 40;
const kLengths = 52;

/** A window: xmin, ymin, xmax, ymax. */
export type NativeBounds = readonly [xmin: number, ymin: number, xmax: number, ymax: number];

/** What `draw` can draw: the order of `Drawing` in wasm/bindings.cpp. */
export const Drawing = { edges: 0, sites: 1, dual: 2, dualWithRays: 3, hull: 4 } as const;
export type Drawing = (typeof Drawing)[keyof typeof Drawing];

// Commands in one portion of a drawing: few enough to stay in the processor's cache.
const kPortion = 4096;

interface Place {
  call: NativeExports;
  address: number;
}
let collector: FinalizationRegistry<Place> | undefined;
let results = 0; // the same in every instance of the module

/**
 * The net under diagrams that nobody disposes of. It holds addresses only, so that owners can be
 * collected.
 */
function addressCollector(): FinalizationRegistry<Place> {
  collector ??= new FinalizationRegistry(({ call, address }) => call.diagramDestroy(address));
  return collector;
}

type Play = (commands: Uint8Array, count: number, xy: Float64Array) => void;
interface Portion {
  xy?: Float64Array;
  commands?: Uint8Array;
}

export class NativeDiagram {
  readonly #call: NativeExports;
  readonly #heap: Heap;
  readonly #address: number;
  #isDestroyed = false;

  private constructor(call: NativeExports, heap: Heap, address: number) {
    this.#call = call;
    this.#heap = heap;
    this.#address = address;
  }

  /**
   * An empty diagram that lives until `destroy`, or until `owner` is collected; null if memory ran
   * out.
   */
  static create(owner: object, hierarchy: boolean): NativeDiagram | null {
    const { call, heap } = runningModule();
    results = call.resultsAddress() >>> 0;
    const address = call.diagramCreate(hierarchy) >>> 0;
    if (address === 0) return null;
    const native = new NativeDiagram(call, heap, address);
    addressCollector().register(owner, { call, address }, native);
    return native;
  }

  destroy(): void {
    addressCollector().unregister(this);
    this.#call.diagramDestroy(this.#address);
    this.#isDestroyed = true;
  }

  // --- Calls about one site or point. Their results are read below, before the next call. --------

  insert(x: number, y: number, r: number): Status {
    return this.#call.diagramInsert(this.#address, x, y, r);
  }
  remove(id: number): Status {
    return this.#call.diagramRemove(this.#address, id);
  }
  update(id: number, x: number, y: number, r: number): Status {
    return this.#call.diagramUpdate(this.#address, id, x, y, r);
  }
  find(x: number, y: number): Status {
    return this.#call.diagramFind(this.#address, x, y);
  }
  has(id: number): boolean {
    return this.#call.diagramHas(this.#address, id) !== 0;
  }
  site(id: number): Status {
    return this.#call.diagramSite(this.#address, id);
  }
  isHidden(id: number): Status {
    return this.#call.diagramIsHidden(this.#address, id);
  }
  neighbors(id: number): Status {
    return this.#call.diagramNeighbors(this.#address, id);
  }
  kNearest(x: number, y: number, k: number): Status {
    return this.#call.diagramKNearest(this.#address, x, y, k);
  }
  within(x: number, y: number, distance: number): Status {
    return this.#call.diagramWithin(this.#address, x, y, distance);
  }
  coverOf(id: number): Status {
    return this.#call.diagramCoverOf(this.#address, id);
  }
  get size(): number {
    return this.#call.diagramSize(this.#address);
  }
  get visibleSize(): number {
    return this.#call.diagramVisibleSize(this.#address);
  }
  clear(): void {
    this.#call.diagramClear(this.#address);
  }

  // --- Scalar results of the last call -----------------------------------------------------------

  /** The site that the last call answered; -1 for none. */
  get id(): number {
    return this.#heap.integers[(results + kId) >>> 2] as number;
  }
  /** How many, or whether (1 or 0). */
  get count(): number {
    return this.#heap.words[(results + kFlag) >>> 2] as number;
  }
  get x(): number {
    return this.#number(kX);
  }
  get y(): number {
    return this.#number(kY);
  }
  get r(): number {
    return this.#number(kR);
  }
  get distance(): number {
    return this.#number(kDistance);
  }

  // --- Arrays in ---------------------------------------------------------------------------------

  /** Inserts triples; the new ids go to `ids`. */
  insertMany(xyr: ArrayLike<number>, ids: Uint32Array): Status {
    return this.#withScratch(ids.length * 24, (at) => {
      this.#writeDoubles(at, xyr, 3 * ids.length);
      const status = this.#call.diagramInsertMany(this.#address, ids.length);
      if (status === 0) ids.set(this.#words(this.#slot(kAddresses, 0), ids.length));
      return status;
    });
  }

  removeMany(ids: Uint32Array): Status {
    return this.#withScratch(ids.length * 4, (at) => {
      this.#words(at, ids.length).set(ids);
      return this.#call.diagramRemoveMany(this.#address, at, ids.length);
    });
  }

  updateMany(ids: Uint32Array, xyr: ArrayLike<number>): Status {
    return this.#withScratch(ids.length * 28, (at) => {
      const idsAt = this.#writeDoubles(at, xyr, 3 * ids.length);
      this.#words(idsAt, ids.length).set(ids);
      return this.#call.diagramUpdateMany(this.#address, idsAt, at, ids.length);
    });
  }

  /**
   * Nearest sites of x, y pairs into `ids` (-1 for none), and their distances into `distances` if
   * given.
   */
  findMany(xy: ArrayLike<number>, ids: Int32Array, distances: Float64Array | undefined): Status {
    const count = ids.length;
    return this.#withScratch(count * (distances ? 28 : 20), (at) => {
      const distancesAt = this.#writeDoubles(at, xy, 2 * count);
      const idsAt = distances ? distancesAt + count * 8 : distancesAt;
      const status = this.#call.diagramFindMany(
        this.#address,
        at,
        idsAt,
        distances ? distancesAt : 0,
        count,
      );
      if (status === 0) {
        ids.set(this.#words(idsAt, count));
        distances?.set(this.#doubles(distancesAt, count));
      }
      return status;
    });
  }

  /** Becomes what `toBytes` saved; proved unless the bytes are trusted. */
  fromBytes(bytes: Uint8Array, isTrusted: boolean): Status {
    return this.#withScratch(bytes.length, (at) => {
      const heap: Uint8Array = this.#heap.bytes;
      heap.subarray(at, at + bytes.length).set(bytes);
      return this.#call.diagramFromBytes(this.#address, at, bytes.length, isTrusted ? 1 : 0);
    });
  }

  // --- Arrays out: each call fills slots, from which `take...` copies and `finish` gives back what
  // was large ---------------

  ids(): Status {
    return this.#call.diagramIds(this.#address);
  }
  vertices(): Status {
    return this.#call.diagramVertices(this.#address);
  }
  edges(): Status {
    return this.#call.diagramEdges(this.#address);
  }
  toBytes(): Status {
    return this.#call.diagramToBytes(this.#address);
  }
  validate(): Status {
    return this.#call.diagramValidate(this.#address);
  }

  // --- Geometry ----------------------------------------------------------------------------------

  toleranceFor(bounds: NativeBounds): number {
    return this.#call.toleranceFor(...bounds);
  }
  /** The box of all circles. */
  extent(): NativeBounds {
    this.#call.diagramExtent(this.#address);
    return [this.x, this.y, this.r, this.distance];
  }
  hull(): Status {
    return this.#call.diagramHull(this.#address);
  }
  polygon(bounds: NativeBounds, id: number, tolerance: number): Status {
    this.#expectLiving();
    return this.#call.voronoiPolygon(this.#address, ...bounds, id, tolerance);
  }
  cell(bounds: NativeBounds, id: number): Status {
    return this.#call.voronoiCell(this.#address, ...bounds, id);
  }
  edgeCurves(bounds: NativeBounds): Status {
    return this.#call.voronoiEdges(this.#address, ...bounds);
  }
  areas(bounds: NativeBounds): Status {
    return this.#call.voronoiAreas(this.#address, ...bounds);
  }
  /**
   * Leaves x and y of the centroid, the perimeter in r, the area in distance, and in count whether
   * there is any.
   */
  measures(bounds: NativeBounds, id: number): Status {
    return this.#call.voronoiMeasures(this.#address, ...bounds, id);
  }
  measuresWithin(id: number, radius: number): Status {
    return this.#call.voronoiMeasuresWithin(this.#address, id, radius);
  }

  /**
   * Hands a drawing to `play` in portions, which may do anything but keep the arrays: even change
   * the diagram.
   */
  draw(what: Drawing, bounds: NativeBounds, tolerance: number, play: Play): Status {
    const portion: Portion = {};
    for (let cursor = 0; ; ) {
      this.#expectLiving();
      const status = this.#call.diagramDraw(
        this.#address,
        what,
        ...bounds,
        tolerance,
        cursor,
        kPortion,
      );
      if (status !== 0) return status;
      cursor = this.id >>> 0;
      const isDone = this.count !== 0;
      this.#playPortion(portion, play);
      if (isDone) break;
    }
    this.finish();
    return 0;
  }
  drawCell(bounds: NativeBounds, id: number, tolerance: number, play: Play): Status {
    this.#expectLiving();
    const status = this.#call.voronoiDrawCell(this.#address, ...bounds, id, tolerance);
    if (status !== 0) return status;
    this.#playPortion({}, play);
    this.finish();
    return 0;
  }

  /** Copies the path in slots 0 and 1 into the portion's own arrays, which grow as needed. */
  #playPortion(portion: Portion, play: Play): void {
    const coordinates = this.#doubles(this.#slot(kAddresses, 0), this.#slot(kLengths, 0));
    const count = this.#slot(kLengths, 1);
    const heap: Uint8Array = this.#heap.bytes;
    const commands = heap.subarray(this.#slot(kAddresses, 1), this.#slot(kAddresses, 1) + count);
    if (!portion.xy || portion.xy.length < coordinates.length)
      portion.xy = new Float64Array(coordinates.length);
    if (!portion.commands || portion.commands.length < count)
      portion.commands = new Uint8Array(count);
    portion.xy.set(coordinates);
    portion.commands.set(commands);
    play(portion.commands, count, portion.xy);
  }

  takeDoubles(slot: number): Float64Array {
    const start = this.#slot(kAddresses, slot) / 8;
    const heap: Float64Array = this.#heap.doubles;
    return heap.slice(start, start + this.#slot(kLengths, slot));
  }
  takeWords(slot: number): Uint32Array {
    const start = this.#slot(kAddresses, slot) / 4;
    const heap: Uint32Array = this.#heap.words;
    return heap.slice(start, start + this.#slot(kLengths, slot));
  }
  takeBytes(slot: number): Uint8Array<ArrayBuffer> {
    const start = this.#slot(kAddresses, slot);
    const heap: Uint8Array<ArrayBuffer> = this.#heap.bytes;
    return heap.slice(start, start + this.#slot(kLengths, slot));
  }
  /** ASCII in slot 0. */
  text(): string {
    return String.fromCharCode(...this.takeBytes(0));
  }
  finish(): void {
    const bytes = 8 * (this.#slot(kLengths, 0) + this.#slot(kLengths, 1) + this.#slot(kLengths, 2));
    if (bytes > kKeptBytes) this.#call.release();
  }

  /**
   * The caller's code runs while arguments and options are read and while contexts draw; it may do
   * anything.
   */
  #expectLiving(): void {
    if (this.#isDestroyed)
      throw new ApolloniusError("disposed", "the diagram was disposed of during the call");
  }

  // --- Addresses ---------------------------------------------------------------------------------

  #number(offset: number): number {
    return this.#heap.doubles[(results + offset) >>> 3] as number;
  }

  #slot(offset: number, slot: number): number {
    return this.#heap.words[((results + offset) >>> 2) + slot] as number;
  }

  #words(address: number, count: number): Uint32Array {
    const heap: Uint32Array = this.#heap.words;
    return heap.subarray(address / 4, address / 4 + count);
  }

  #doubles(address: number, count: number): Float64Array {
    const heap: Float64Array = this.#heap.doubles;
    return heap.subarray(address / 8, address / 8 + count);
  }

  /** Copies values in and returns the address behind them. */
  #writeDoubles(address: number, values: ArrayLike<number>, count: number): number {
    this.#doubles(address, count).set(values);
    return address + count * 8;
  }

  #withScratch(bytes: number, call: (address: number) => Status): Status {
    this.#expectLiving();
    if (bytes > kMostBytes) return kOutOfMemory;
    const address = this.#call.reserve(Math.max(bytes, 8)) >>> 0;
    if (address === 0) return kOutOfMemory;
    try {
      return call(address);
    } finally {
      if (bytes > kKeptBytes) this.#call.release();
    }
  }
}
