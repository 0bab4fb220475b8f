// Diagram.from and fromAsync: from any items to flat x, y, r triples.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkSiteCount,
  described,
  detachedArray,
  isArrayLike,
  isDetached,
  numberError,
} from "./arguments.js";
import type { BuildOptions } from "./types.js";

/**
 * Reads one number from an item; called with the item, its index and all items, as d3's accessors
 * are.
 */
export type Accessor<T> = (item: T, index: number, items: Items<T>) => number;

/** What `Diagram.from` takes. */
export type Items<T> = Iterable<T> | ArrayLike<T>;

/** Those of a diagram's items; `that` is their `this`. */
export type Accessors<T> = [
  x: Accessor<T>,
  y: Accessor<T>,
  r?: Accessor<T> | undefined,
  that?: unknown,
];

/** The same; what is missing is read as from a `Circular`. */
export type SomeAccessors<T> = [
  x?: Accessor<T> | undefined,
  y?: Accessor<T> | undefined,
  r?: Accessor<T> | undefined,
  that?: unknown,
];

/** Those of `Diagram.fromAsync`, and its options. */
export type AsyncAccessors<T> = [
  x: Accessor<T>,
  y: Accessor<T>,
  r?: Accessor<T> | undefined,
  options?: BuildOptions | undefined,
];

/** The same; what is missing is read as from a `Circular`. */
export type SomeAsync<T> = [
  x?: Accessor<T> | undefined,
  y?: Accessor<T> | undefined,
  r?: Accessor<T> | undefined,
  options?: BuildOptions | undefined,
];

/** Accessors and options, of which the latter may come alone. */
export function asyncAccessors<T>(rest: SomeAsync<T> | [options: BuildOptions]): SomeAsync<T> {
  const [first] = rest;
  const isAlone = rest.length === 1 && typeof first === "object" && first !== null;
  return isAlone ? [undefined, undefined, undefined, first] : (rest as SomeAsync<T>);
}

/** What `Diagram.from` reads without accessors. */
export type Circular =
  | { readonly x: number; readonly y: number; readonly r?: number | undefined }
  | ArrayLike<number>;

type Fields = { readonly [name: string]: unknown } & ArrayLike<unknown>;

// By default an item is an object {x, y, r} or an array [x, y, r].
function field<T>(name: "x" | "y" | "r", position: number): (item: T) => unknown {
  return (item) => {
    const fields = item as Fields | null | undefined;
    return Array.isArray(item) || ArrayBuffer.isView(item) ? fields?.[position] : fields?.[name];
  };
}

function notIterable(items: unknown): ApolloniusError {
  return new ApolloniusError(
    "bad-length",
    `items is ${described(items)}, expected an iterable or an array`,
  );
}

function missing(item: unknown, index: number): ApolloniusError {
  return new ApolloniusError(
    "not-finite",
    `item ${index} is ${described(item)}, expected {x, y, r} or [x, y, r]`,
  );
}

/** Names of what may be meant for the radius of an item that has no r. */
const kOtherNames = ["radius", "size", "weight"];

/** The radius of an item that has no r; one with a radius is refused, as nobody would read it. */
function radiusWithoutR(item: unknown, index: number): 0 {
  if (typeof item !== "object" || item === null) return 0;
  const name = kOtherNames.find((other) => other in item);
  if (name === undefined) return 0;
  throw new ApolloniusError(
    "bad-option",
    `item ${index} has a ${name} and no r: Diagram.from(items, x, y, (d) => d.${name}) reads it, ` +
      "Diagram.from(items, x, y) takes points",
  );
}

/** Items that are read in portions, whatever the accessors do to them. */
export class ItemReader<T> {
  readonly count: number;
  readonly #list: ArrayLike<T>;
  readonly #read: (item: T, index: number) => unknown[];

  /** Throws "bad-length", "bad-option" or "too-large". */
  constructor(items: Items<T>, ...[x, y, r, that]: SomeAccessors<T>) {
    if (
      typeof items !== "object" ||
      items === null ||
      !("length" in items || Symbol.iterator in items)
    ) {
      throw notIterable(items);
    }
    for (const [name, accessor] of Object.entries({ x, y, r })) {
      if (accessor === undefined || accessor === null || typeof accessor === "function") continue;
      throw new ApolloniusError(
        "bad-option",
        `${name} is ${described(accessor)}, expected a function of an item`,
      );
    }
    const readX = x ?? field<T>("x", 0);
    const readY = y ?? field<T>("y", 1);
    const defaultR = field<T>("r", 2);
    // With two accessors, as d3-delaunay has them, items are points.
    const arePoints = typeof x === "function" && typeof y === "function";
    const usualR = (item: T, k: number) => {
      const given = defaultR(item);
      return given === undefined ? radiusWithoutR(item, k) : given;
    };
    const readR = r ?? (arePoints ? () => 0 : usualR);
    if (isDetached(items)) throw detachedArray("items", "items");
    const list: ArrayLike<T> = "length" in items ? items : Array.from(items);
    if (!isArrayLike(list)) throw notIterable(items);
    this.count = list.length; // accessors may change the list
    checkSiteCount("items", this.count);
    this.#list = list;
    this.#read = (item, index) => [
      readX.call(that, item, index, items),
      readY.call(that, item, index, items),
      readR.call(that, item, index, items),
    ];
  }

  /**
   * The triples of the items from one to before another. Throws "not-finite" or "out-of-range",
   * naming the item, for values that cannot be a site's.
   */
  triples(from: number, to: number): Float64Array {
    const xyr = allocated(() => new Float64Array(3 * (to - from)));
    for (let index = from; index < to; ++index) {
      const item = this.#list[index] as T;
      this.#read(item, index).forEach((value, k) => {
        const error = numberError(`${"xyr"[k]} of item ${index}`, value);
        if (error) throw item === null || item === undefined ? missing(item, index) : error;
        xyr[3 * (index - from) + k] = value as number;
      });
    }
    return xyr;
  }
}

export function triples<T>(items: Items<T>, ...accessors: SomeAccessors<T>): Float64Array {
  const reader = new ItemReader(items, ...accessors);
  return reader.triples(0, reader.count);
}
