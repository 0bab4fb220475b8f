/// <reference lib="esnext.disposable" preserve="true" />
import { checkedIds, checkWholeNumber, isSiteId } from "./arguments.js";
import { type Inner, innerOf, provideInner } from "./inner.js";
import { kInspect, showContent, summary } from "./inspection.js";
import { Ballast, destroy, keep } from "./native/lifetime.js";
import type { AnyNative } from "./native/module.js";
import { ofOne, type Space } from "./space.js";
import type { Edges } from "./types.js";

/** The calls without places that the diagrams of the plane and of the sphere have in common. */
export abstract class DynamicDiagram<Listed> implements Disposable {
  #inner: Inner | null;

  static {
    provideInner((diagram) =>
      typeof diagram === "object" && diagram !== null && #inner in diagram
        ? diagram.#inner
        : undefined,
    );
  }

  /** @internal */
  protected constructor(native: AnyNative, space: Space) {
    this.#inner = { native, space, filters: { running: 0 }, ballast: new Ballast() };
    keep(this, native);
    showContent(this);
  }

  /** All sites as typed arrays. */
  abstract sites(): object;

  /** All sites, ascending by id. */
  abstract [Symbol.iterator](): Generator<Listed, void>;

  /** The name of the class. O(1). */
  abstract get [Symbol.toStringTag](): string;

  // --- Sites -------------------------------------------------------------------------------------

  /**
   * Removes a site (paper, section 5); false if there is no such site. Sites that only it covered
   * become visible. Cost: O(log n) amortised for a hidden site and for the visible one of nested or
   * identical circles, else expected O(k log k) with k = d + the hidden sites directly below it. On
   * the sphere, removing one of the n sites, the pole, costs as much as building. Throws
   * "unknown-site" for what is no whole number.
   */
  remove(id: number): boolean {
    const { native } = innerOf(this, true);
    checkWholeNumber(id);
    return isSiteId(id) && native.remove(id);
  }

  /**
   * Removes several sites; returns how many there were. Unknown and repeated ids are skipped. Cost:
   * as `remove` for each. Throws as `remove`, and "bad-length" if `ids` is no array.
   */
  removeMany(ids: ArrayLike<number>): number {
    return innerOf(this, true).native.removeMany(checkedIds("ids", ids));
  }

  /** Removes all sites; ids start from 0 again. Cost: O(n). */
  clear(): this {
    innerOf(this, true).native.clear();
    return this;
  }

  /** Number of sites, hidden ones too. O(1). */
  get size(): number {
    return innerOf(this).native.size();
  }

  /** Number of sites that have a cell. O(1). */
  get visibleSize(): number {
    return innerOf(this).native.visibleSize();
  }

  /** Number of sites that have none: another covers them (the paper's trivial sites). O(1). */
  get hiddenSize(): number {
    return this.size - this.visibleSize;
  }

  /** Whether a site has this id. O(1). Throws "unknown-site" for what is no whole number. */
  has(id: number): boolean {
    const { native } = innerOf(this);
    checkWholeNumber(id);
    return isSiteId(id) && native.has(id);
  }

  /** All ids, ascending. O(n). */
  ids(): Uint32Array {
    return innerOf(this).native.ids();
  }

  /**
   * Whether the site's cell is empty, because some site covers it. Of identical circles, the one
   * with the least id is visible, whatever was inserted first. O(1). Throws "unknown-site".
   */
  isHidden(id: number): boolean {
    return ofOne(innerOf(this).native, id, (native) => native.isHidden(id));
  }

  /**
   * A visible site that covers this one; -1 for a visible site. Cost: one location. Throws
   * "unknown-site".
   */
  coverOf(id: number): number {
    return ofOne(innerOf(this).native, id, (native) => native.coverOf(id));
  }

  // --- The graph ---------------------------------------------------------------------------------

  /**
   * The neighbours in the Delaunay graph: the distinct sites whose cells share an edge with this
   * site's, counter-clockwise (on the sphere, as seen from outside), each where it occurs first;
   * empty for a hidden site. Edges of length zero count (degenerate position; the plane's graph is
   * triangulated canonically, the sphere's as rounding decides); to a view's `neighbors` they do
   * not. O(d). Throws "unknown-site".
   */
  neighbors(id: number): Uint32Array {
    return ofOne(innerOf(this).native, id, (native) => native.neighbors(id));
  }

  /** All Voronoi edges. O(n). */
  edges(): Edges {
    return innerOf(this).native.edges();
  }

  // --- Saving ------------------------------------------------------------------------------------

  /**
   * The diagram as bytes (a Uint8Array), about 56 a site, on the sphere 28: for files, and for
   * other threads (`postMessage(bytes, [bytes.buffer])` moves them; the diagram itself cannot be
   * posted). One history gives the same bytes on every platform; docs/SNAPSHOTS.md has the format.
   * Cost: O(n), a fraction of building.
   */
  toBytes(): ReturnType<Uint8Array["slice"]> {
    return innerOf(this).native.toBytes();
  }

  /** The sites, for JSON; `from` reads them, with new ids. O(n). */
  toJSON(): Listed[] {
    return [...this];
  }

  /**
   * The name of the class and two sizes, "Diagram { size: 3, hidden: 1 }", as consoles of Node,
   * Deno and Bun show it. O(1).
   */
  toString(): string {
    return summary(this, this[Symbol.toStringTag]);
  }

  /** @internal */
  [kInspect](): string {
    return this.toString();
  }

  // --- Lifetime ----------------------------------------------------------------------------------

  /**
   * Frees the diagram's memory now; later calls throw "disposed", a second `dispose` does nothing.
   * A forgotten diagram is freed some time after it has been collected, in a turn of the event
   * loop; a loop that makes many and never waits needs `dispose` or `using`. Cost: O(1).
   */
  dispose(): void {
    if (this.#inner === null) return;
    const { native, ballast } = innerOf(this, true);
    destroy(native);
    this.#inner = null;
    ballast.drop();
  }

  /** `dispose`, for `using diagram = …`. Cost: O(1). */
  [Symbol.dispose](): void {
    this.dispose();
  }
}
