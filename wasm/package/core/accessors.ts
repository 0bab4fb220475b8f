// `from` and `fromAsync` of both kinds of diagrams: from any items to flat triples.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedNewSites,
  checkedR,
  checkOptions,
  checkSiteCount,
  described,
  detachedArray,
  isArrayLike,
  isDetached,
  numberError,
  throwFirst,
  triplesOf,
  typedArrayKind,
} from "./arguments.js";
import { plane } from "./space.js";
import type { RadiusOption } from "./types.js";

/**
 * Reads one number from an item; called with the item, its index and all items, as d3's accessors
 * are.
 */
export type Accessor<T> = (item: T, index: number, items: Items<T>) => number;

/** The items that `Diagram.from` takes. */
export type Items<T> = Iterable<T> | ArrayLike<T>;

type Accessors<T> = readonly (Accessor<T> | null | undefined)[];

/** Items that are read in portions. */
export interface Reader {
  readonly count: number;
  /** Returns the triples of the items with indices from `from` to before `to`. */
  triples(from: number, to: number): ArrayLike<number>;
}

/** An item that `Diagram.from` reads without accessors. */
export type Circular =
  | { readonly x: number; readonly y: number; readonly r?: number | undefined }
  | ArrayLike<number>;

/** The items of one kind of diagram. */
export interface ItemKind {
  /** The names of a site's numbers in messages. */
  readonly names: readonly [x: string, y: string, r: string];
  /** The name of an array of sites in messages. */
  readonly sites: string;
  /** The name of an array of points in messages. */
  readonly points: string;
  /** The forms of an item that needs no accessors, in messages. */
  readonly expected: string;
  /** Returns the numbers of an item without accessors; r may be missing. undefined: no item. */
  fields(item: unknown): readonly [x: unknown, y: unknown, r: unknown] | undefined;
  /** Returns the error of the number with index `axis` of a site, or null if it is accepted. */
  error(name: string, axis: number, value: unknown): ApolloniusError | null;
}

type Fields = { readonly [name: string]: unknown } & ArrayLike<unknown>;

/** Objects {x, y, r} and arrays [x, y, r]. */
export const circles: ItemKind = {
  names: plane.names,
  sites: plane.sites,
  points: plane.points,
  expected: "{x, y, r} or [x, y, r]",
  fields(item) {
    if (item === null || item === undefined) return undefined;
    const fields = item as Fields;
    return Array.isArray(item) || ArrayBuffer.isView(item)
      ? [fields[0], fields[1], fields[2]]
      : [fields.x, fields.y, fields.r];
  },
  error: (name, _, value) => numberError(name, value),
};

/** Names of properties that may be meant as the radius of an item that has no r. */
const kOtherNames = ["radius", "size", "weight"];

/**
 * Returns the radius of an item that has no r. Throws "bad-option" for an item with a `radius` or
 * the like, which would be ignored.
 */
function radiusWithoutR(item: unknown, index: number): 0 {
  if (typeof item !== "object" || item === null) return 0;
  const name = kOtherNames.find((other) => other in item);
  if (name === undefined) return 0;
  throw new ApolloniusError(
    "bad-option",
    `item ${index} has a ${name} and no r: give (d) => d.${name} as third accessor, or the ` +
      "option { r: 0 } for points",
  );
}

/** Returns a hint for messages about an item that has a longitude, under one of some names. */
function hintOfPlace(item: unknown): string {
  if (typeof item !== "object" || item === null) return "";
  const lon = ["lng", "lon", "longitude"].find((name) => name in item);
  const lat = lon === "longitude" ? "latitude" : "lat";
  return lon ? `: SphericalDiagram.from(items, (d) => d.${lon}, (d) => d.${lat}) reads places` : "";
}

/** Stands for an item whose coordinates are both read by accessors. */
const kNothing = [undefined, undefined, undefined] as const;

/** Items that are read in portions. Accessors may change the list of items meanwhile. */
class ItemReader<T> implements Reader {
  readonly count: number;
  readonly #kind: ItemKind;
  readonly #items: Items<T>;
  readonly #list: ArrayLike<T>;
  readonly #accessors: Accessors<T>;
  readonly #r: number | undefined;

  /** Throws "bad-length", "bad-option" or "too-large". */
  constructor(kind: ItemKind, items: Items<T>, accessors: Accessors<T>, r: number | undefined) {
    for (const [axis, name] of kind.names.entries()) {
      const accessor = accessors[axis];
      if (accessor === undefined || accessor === null || typeof accessor === "function") continue;
      throw new ApolloniusError(
        "bad-option",
        `${name} is ${described(accessor)}, expected a function of an item`,
      );
    }
    if (r !== undefined && accessors[2])
      throw new ApolloniusError("bad-option", `options.${kind.names[2]} and an accessor of it`);
    if (isDetached(items)) throw detachedArray("items", "items");
    const isIterable = typeof items === "object" && items !== null && Symbol.iterator in items;
    const list = isIterable && !("length" in items) ? Array.from(items) : (items as ArrayLike<T>);
    if (!isArrayLike(list))
      throw new ApolloniusError(
        "bad-length",
        `items is ${described(items)}, expected an iterable or an array`,
      );
    this.count = list.length; // accessors may change the list
    checkSiteCount("items", this.count);
    this.#kind = kind;
    this.#items = items;
    this.#list = list;
    this.#accessors = accessors;
    // With two accessors, items are points.
    this.#r = accessors[0] && accessors[1] && !accessors[2] ? (r ?? 0) : r;
  }

  /**
   * Returns the triples of the items with indices from `from` to before `to`. Throws "not-finite"
   * or "out-of-range", naming the item, for values that cannot be a site's.
   */
  triples(from: number, to: number): Float64Array {
    const kind = this.#kind;
    const items = this.#items;
    const [x, y, r] = this.#accessors;
    const isRead = x && y;
    const triples = allocated(() => new Float64Array(3 * (to - from)));
    for (let index = from; index < to; ++index) {
      const item = this.#list[index] as T;
      const usual = isRead ? kNothing : kind.fields(item);
      if (usual === undefined)
        throw new ApolloniusError(
          "not-finite",
          `item ${index} is ${described(item)}, expected ${kind.expected}${hintOfPlace(item)}`,
        );
      const isGiven = r || this.#r !== undefined || usual[2] !== undefined;
      const own = isGiven ? (this.#r ?? usual[2]) : radiusWithoutR(item, index);
      const values = [
        x ? x(item, index, items) : usual[0],
        y ? y(item, index, items) : usual[1],
        r ? r(item, index, items) : own,
      ];
      values.forEach((value, axis) => {
        // Names are made for errors only, as they cost more than the check.
        if (kind.error("", axis, value)) throw this.#errorOf(index, axis, value, usual);
        triples[3 * (index - from) + axis] = value as number;
      });
    }
    return triples;
  }

  /** The error of a number of an item. */
  #errorOf(index: number, axis: number, value: unknown, usual: readonly unknown[]) {
    const { names, error } = this.#kind;
    const found = error(`${names[axis]} of item ${index}`, axis, value) as ApolloniusError;
    const isMissing = axis === 0 && value === undefined && usual !== kNothing;
    const hint = isMissing ? hintOfPlace(this.#list[index]) : "";
    return hint === "" ? found : new ApolloniusError(found.code, found.message + hint);
  }
}

/** Flat numbers: triples, or pairs with one radius for all. */
class FlatReader implements Reader {
  readonly count: number;
  readonly #kind: ItemKind;
  readonly #numbers: ArrayLike<number>;
  readonly #r: number | undefined;
  readonly #each: 2 | 3;

  /** Throws "bad-length", "not-finite" or "too-large". */
  constructor(kind: ItemKind, numbers: ArrayLike<number>, r: number | undefined) {
    this.#kind = kind;
    this.#numbers = checkedNewSites(kind, numbers, r);
    this.#r = r;
    this.#each = r === undefined ? 3 : 2;
    this.count = this.#numbers.length / this.#each;
  }

  triples(from: number, to: number): ArrayLike<number> {
    const each = this.#each;
    const some = Array.prototype.slice.call(this.#numbers, each * from, each * to) as number[];
    const name = each === 3 ? this.#kind.sites : this.#kind.points;
    throwFirst(some, (value, k) =>
      this.#kind.error(`${name}[${each * from + k}]`, k % each, value),
    );
    return triplesOf(some, this.#r);
  }
}

const isFlat = (items: unknown): items is ArrayLike<number> =>
  typedArrayKind(items) !== undefined || (Array.isArray(items) && typeof items[0] === "number");

/** Splits the arguments after the items into accessors and options. Throws "bad-option". */
export function accessorsAndOptions<T, Options extends object>(
  rest: unknown[],
  ...names: string[]
): [accessors: Accessors<T>, options: Options | undefined] {
  const at = [0, 1, 2].find((k) => typeof rest[k] === "object" && rest[k] !== null) ?? 3;
  const [options, ...after] = rest.slice(at);
  checkOptions(options, ...names);
  if (after.some((given) => given !== undefined))
    throw new ApolloniusError("bad-option", "options are not last, but expected last");
  return [rest.slice(0, at) as Accessors<T>, options as Options | undefined];
}

/** Reads what `from` and `fromAsync` take. */
export function readerOf<T>(
  kind: ItemKind,
  items: Items<T>,
  accessors: Accessors<T>,
  options: RadiusOption | undefined,
): Reader {
  const r = checkedR(options?.r);
  return isFlat(items) && !accessors.some(Boolean)
    ? new FlatReader(kind, items, r)
    : new ItemReader(kind, items, accessors, r);
}
