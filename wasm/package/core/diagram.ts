import {
  type Accessor,
  accessorsAndOptions,
  type Circular,
  circles,
  type Items,
  readerOf,
} from "./accessors.js";
import {
  checkedChoice,
  checkedNumbersOfBounds,
  checkOptions,
  disorderedBounds,
} from "./arguments.js";
import { buildOrDispose, restore, restoreOrDispose } from "./building.js";
import { filtering } from "./filters.js";
import { nativeOf, planarOf } from "./inner.js";
import { listed } from "./inspection.js";
import { fillOrDispose } from "./native/lifetime.js";
import { notLoaded, runningModule } from "./native/module.js";
import { checkedFilterOptions } from "./queries.js";
import { plane } from "./space.js";
import { SurfaceDiagram } from "./surface_diagram.js";
import { type Triangulation, triangulationOf } from "./triangulation.js";
import type {
  AsyncSnapshotOptions,
  BuildOptions,
  Edges,
  FilterOptions,
  ListedSite,
  RadiusOption,
  Site,
  Sites,
  SnapshotOptions,
  Vertices,
} from "./types.js";

/** The error of a call that diagrams have once the default entry is imported. */
const notImported = (call: string) =>
  notLoaded(
    `diagram.${call} comes with "apollonius-diagram", ${call}(diagram) with ` +
      '"apollonius-diagram/shapes": import one',
  );

/** The names of the plane. */
interface Plane {
  place: [x: number, y: number];
  places: [xy: ArrayLike<number>];
  sites: [xyr: ArrayLike<number>];
  site: Site;
  listed: ListedSite;
}

/**
 * The additively weighted Voronoi diagram of circles: exact and fully dynamic.
 *
 * The distance of a point p to a site is |p - c| - r, negative inside the circle. Every decision is
 * exact for the numbers given; nothing depends on rounding, on the order of operations or on the
 * platform. Numbers in: magnitudes up to 1e100, negative weights included; those below 1e-100 are
 * taken as 0, and 0 comes back. y points upwards. n is the number of sites, d the number of a
 * site's neighbours.
 *
 * Every call that fails throws an ApolloniusError and leaves the diagram as it was; after `dispose`
 * every call throws "disposed". Every call that needs memory can throw "out-of-memory". A call that
 * is cut off in the middle, by a defect of the library or by a stack overflow, throws "broken", and
 * so does every later call of that diagram. Its memory is freed only when all diagrams that were
 * alive then are gone. Arrays that are returned belong to the caller.
 *
 * Diagrams are equal, to test frameworks and Node's `assert`, if the same ids have the same circles
 * and the same ones are hidden. (They read `content`, a property meant for them alone.)
 *
 * Algorithm: Karavelas and Yvinec, "Dynamic Additively Weighted Voronoi Diagrams in 2D" (the
 * paper).
 */
export class Diagram extends SurfaceDiagram<Plane> {
  /**
   * A diagram of flat x, y, r triples, or with the option `r` of x, y pairs; their ids are 0, 1, 2,
   * … in input order. Cost: expected O(n log n). Throws "not-finite", "out-of-range", "bad-length"
   * (no multiple of 3, or of 2), "too-large" (more than 2^29 sites), "bad-option".
   */
  constructor(xyr?: ArrayLike<number>, options?: RadiusOption) {
    checkOptions(options, "r");
    super(runningModule().create(), plane);
    if (xyr !== undefined)
      fillOrDispose(this, () => this.insertMany(xyr, options as { r: number }));
  }

  /**
   * A diagram of any items, read by accessors as in d3-delaunay (item, index, items); with two
   * accessors, for x and y, items are points. Without accessors an item is an object {x, y, r} or
   * an array [x, y, r], of which a missing r is 0, or `items` are flat numbers as the constructor
   * takes them. Options come last. Ids are 0, 1, 2, … in input order. Throws as the constructor,
   * naming the item; "bad-option" if an accessor is no function, or an item without r has a
   * `radius`, `size` or `weight`, which nothing would read. Cost: expected O(n log n).
   */
  static from<T extends Circular>(items: Items<T>, options?: RadiusOption): Diagram;
  static from<T>(items: Items<T>, x: Accessor<T>, y: Accessor<T>, options?: RadiusOption): Diagram;
  static from<T>(
    items: Items<T>,
    x: Accessor<T>,
    y: Accessor<T>,
    r: Accessor<T> | undefined,
    options?: RadiusOption,
  ): Diagram;
  static from(xyr: ArrayLike<number>, options?: RadiusOption): Diagram;
  static from(items: Items<unknown>, ...rest: unknown[]): Diagram {
    const [accessors, options] = accessorsAndOptions<unknown, RadiusOption>(rest, "r");
    const reader = readerOf(circles, items, accessors, options);
    return new Diagram(reader.triples(0, reader.count));
  }

  /**
   * Builds the diagram of `from` in slices of some 8 ms on this thread, between which pages answer
   * and timers run. Not cut are a few steps that make room for all sites, and take some 30 ms for a
   * million of them, and the reading of an iterable that is no array. Rejects as `from`
   * throws; with the reason of `options.signal` once that aborts; with what accessors or
   * `onProgress` throw; then there is no diagram. Cost: about that of `from`.
   */
  static fromAsync<T extends Circular>(items: Items<T>, options?: BuildOptions): Promise<Diagram>;
  static fromAsync<T>(
    items: Items<T>,
    x: Accessor<T>,
    y: Accessor<T>,
    options?: BuildOptions,
  ): Promise<Diagram>;
  static fromAsync<T>(
    items: Items<T>,
    x: Accessor<T>,
    y: Accessor<T>,
    r: Accessor<T> | undefined,
    options?: BuildOptions,
  ): Promise<Diagram>;
  static fromAsync(xyr: ArrayLike<number>, options?: BuildOptions): Promise<Diagram>;
  static async fromAsync(items: Items<unknown>, ...rest: unknown[]): Promise<Diagram> {
    const names = ["r", "signal", "onProgress"];
    const [accessors, options] = accessorsAndOptions<unknown, BuildOptions>(rest, ...names);
    const reader = readerOf(circles, items, accessors, options);
    const diagram = new Diagram();
    await buildOrDispose(diagram, reader, options ?? {});
    return diagram;
  }

  /**
   * The diagram that `toBytes` saved, with its ids (the free ones are used again in the same
   * order). The bytes are verified: whoever made them, the result is the
   * exact diagram of their sites. Throws "corrupt-snapshot" (bytes that are no snapshot, are
   * damaged, are not the diagram of their sites, or come from another version), "bad-length" (no
   * bytes), "bad-option". Cost: O(n); for degenerate input (grids) about that of building.
   * `trusted` skips the verification, for bytes of your own, and is several times as fast. With
   * other bytes, answers may be wrong and calls may throw "corrupt-snapshot" (docs/SNAPSHOTS.md).
   */
  static fromBytes(bytes: Uint8Array | ArrayBuffer, options?: SnapshotOptions): Diagram {
    checkOptions(options, "trusted");
    const trusted = checkedChoice("options.trusted", options?.trusted, [false, true]);
    const diagram = new Diagram();
    fillOrDispose(diagram, () => restore(diagram, bytes, trusted));
    return diagram;
  }

  /**
   * `fromBytes` in slices of some 8 ms on this thread, between which pages answer and timers run.
   * Not cut are the copy of the bytes and three steps that read them, which take up to 150 ms for a
   * million sites; the verification, most of the work, is. Rejects as `fromBytes` throws; with the
   * reason of `options.signal` once that aborts; with what `onProgress` throws. Cost: that of
   * `fromBytes`.
   */
  static async fromBytesAsync(
    bytes: Uint8Array | ArrayBuffer,
    options?: AsyncSnapshotOptions,
  ): Promise<Diagram> {
    checkOptions(options, "trusted", "signal", "onProgress");
    const trusted = checkedChoice("options.trusted", options?.trusted, [false, true]);
    const diagram = new Diagram();
    await restoreOrDispose(diagram, bytes, trusted, options ?? {});
    return diagram;
  }

  // --- Sites -------------------------------------------------------------------------------------

  /** All sites, hidden ones too, as typed arrays: `updateMany(ids, xyr)` moves them all. O(n). */
  sites(): Sites {
    return nativeOf(this).sites();
  }

  /**
   * All sites, { id, x, y, r, hidden }, ascending by id, as they are when the loop begins. O(n).
   */
  [Symbol.iterator](): Generator<ListedSite, void> {
    return listed(() => this.sites());
  }

  // --- Cells and drawings: errors, until the default entry has put its calls here (methods.ts) ---

  /** @internal */
  voronoi(): unknown {
    throw notImported("voronoi");
  }

  /** @internal */
  override edges(options?: object): Edges {
    if (options !== undefined) throw notImported("edges");
    return super.edges();
  }

  /** @internal */
  render(): unknown {
    throw notImported("render");
  }

  /** @internal */
  renderSites(): unknown {
    throw notImported("renderSites");
  }

  /** @internal */
  renderHull(): unknown {
    throw notImported("renderHull");
  }

  /** @internal */
  smallestEnclosingCircle(): unknown {
    throw notImported("smallestEnclosingCircle");
  }

  // --- The nearest sites -------------------------------------------------------------------------

  /**
   * All sites whose circles meet a rectangle, a segment or a point, hidden ones too, ascending;
   * rims and the border count, circles of negative r meet none. Exact. Throws "bad-bounds",
   * "bad-option". Cost: for sites spread evenly O(m log m), m the number of sites found and of
   * those around the border.
   */
  search(
    xmin: number,
    ymin: number,
    xmax: number,
    ymax: number,
    options?: FilterOptions,
  ): Uint32Array {
    const { native, filters } = planarOf(this);
    const filter = checkedFilterOptions(options);
    // Infinity means no limit on that side: no centre is farther than 1e100.
    const limits = [-Infinity, -Infinity, Infinity, Infinity];
    const finite = [xmin, ymin, xmax, ymax].map((value: unknown, k) =>
      value === limits[k] ? Math.sign(Number(value)) * 1e100 : value,
    );
    const bounds = checkedNumbersOfBounds(finite);
    const [left, bottom, right, top] = bounds;
    if (left > right || bottom > top) throw disorderedBounds(bounds, "<=");
    const found = native.search(left, bottom, right, top);
    return filter === undefined ? found : filtering(filters, () => found.filter(filter));
  }

  // --- The graph ---------------------------------------------------------------------------------

  /**
   * All Voronoi vertices. They are correctly rounded where sites have small whole numbers as
   * coordinates. O(n).
   */
  vertices(): Vertices {
    return nativeOf(this).vertices();
  }

  /** The Delaunay graph as it is now, in d3-delaunay's arrays: a copy, to be asked once. O(n). */
  triangulation(): Triangulation {
    return triangulationOf(nativeOf(this));
  }

  /**
   * Ids of the sites that touch the convex hull of the circles, counter-clockwise, those in line
   * with their neighbours included. Some occur twice: a large circle with small ones sticking out,
   * or points in line. O(length).
   */
  hull(): Uint32Array {
    return nativeOf(this).hull();
  }

  // --- Saving ------------------------------------------------------------------------------------

  /** "Diagram". O(1). */
  get [Symbol.toStringTag](): string {
    return "Diagram";
  }
}
