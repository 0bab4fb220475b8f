// `from` and `fromAsync` of both kinds of diagrams: from any items to flat triples.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkOptions,
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

/** The accessors of `Diagram.from`; `that` is their `this`. */
export type Accessors<T> = [
  x: Accessor<T>,
  y: Accessor<T>,
  r?: Accessor<T> | undefined,
  that?: unknown,
];

/** `Accessors` that may be left out: what is missing is read as from a `Circular`. */
export type SomeAccessors<T> = [
  x?: Accessor<T> | undefined,
  y?: Accessor<T> | undefined,
  r?: Accessor<T> | undefined,
  that?: unknown,
];

/** The accessors of `Diagram.fromAsync`, and its options, which come last. */
export type AsyncAccessors<T> = [
  x: Accessor<T>,
  y: Accessor<T>,
  r?: Accessor<T> | BuildOptions | undefined,
  options?: BuildOptions | undefined,
];

/** `AsyncAccessors` that may be left out: what is missing is read as from a `Circular`. */
export type SomeAsync<T> = [
  x?: Accessor<T> | undefined,
  y?: Accessor<T> | undefined,
  r?: Accessor<T> | BuildOptions | undefined,
  options?: BuildOptions | undefined,
];

/**
 * Accessors, and the options behind them, which have these names: all that comes after the items.
 * Throws "bad-option".
 */
export function accessorsAndOptions<T, Options extends object>(
  rest: unknown[],
  ...names: string[]
): [accessors: SomeAccessors<T>, options: Options | undefined] {
  const at = [0, 1, 2].find((k) => typeof rest[k] === "object" && rest[k] !== null) ?? 3;
  const accessors = rest.slice(0, at) as SomeAccessors<T>;
  const [options, ...after] = rest.slice(at);
  checkOptions(options as object | undefined, ...names);
  if (after.some((given) => given !== undefined))
    throw new ApolloniusError("bad-option", "options are not last, but expected last");
  return [accessors, options as Options | undefined];
}

/** What `Diagram.from` reads without accessors. */
export type Circular =
  | { readonly x: number; readonly y: number; readonly r?: number | undefined }
  | ArrayLike<number>;

/** The items of one kind of diagram. */
export interface ItemKind {
  /** What messages call the numbers of a site. */
  readonly names: readonly [x: string, y: string, r: string];
  /** What an item without accessors can be. */
  readonly expected: string;
  /** The numbers of an item without accessors, of which r may be missing; undefined for no item. */
  fields(item: unknown): readonly [x: unknown, y: unknown, r: unknown] | undefined;
  /** The error of the number at place `axis` of a site; null if it is accepted. */
  error(name: string, axis: number, value: unknown): ApolloniusError | null;
}

type Fields = { readonly [name: string]: unknown } & ArrayLike<unknown>;

/** Objects {x, y, r} and arrays [x, y, r]. */
const circles: ItemKind = {
  names: ["x", "y", "r"],
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

/** Names of what may be meant for the radius of an item that has no r. */
const kOtherNames = ["radius", "size", "weight"];

/** The radius of an item that has no r; one with a radius is refused, as nobody would read it. */
function radiusWithoutR(item: unknown, index: number): 0 {
  if (typeof item !== "object" || item === null) return 0;
  const name = kOtherNames.find((other) => other in item);
  if (name === undefined) return 0;
  throw new ApolloniusError(
    "bad-option",
    `item ${index} has a ${name} and no r: give (d) => d.${name} as third accessor, or two ` +
      "accessors for points",
  );
}

/** Of items that accessors make points. */
const kPoint = [undefined, undefined, 0] as const;

/** Items that are read in portions, whatever the accessors do to them. */
export class ItemReader<T> {
  readonly count: number;
  readonly #kind: ItemKind;
  readonly #items: Items<T>;
  readonly #list: ArrayLike<T>;
  readonly #accessors: SomeAccessors<T>;

  /** Throws "bad-length", "bad-option" or "too-large". */
  constructor(kind: ItemKind, items: Items<T>, ...accessors: SomeAccessors<T>) {
    for (const [axis, name] of kind.names.entries()) {
      const accessor = accessors[axis];
      if (accessor === undefined || accessor === null || typeof accessor === "function") continue;
      throw new ApolloniusError(
        "bad-option",
        `${name} is ${described(accessor)}, expected a function of an item`,
      );
    }
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
  }

  /**
   * The triples of the items from one to before another. Throws "not-finite" or "out-of-range",
   * naming the item, for values that cannot be a site's.
   */
  triples(from: number, to: number): Float64Array {
    const kind = this.#kind;
    const items = this.#items;
    const [x, y, r, that] = this.#accessors;
    const triples = allocated(() => new Float64Array(3 * (to - from)));
    for (let index = from; index < to; ++index) {
      const item = this.#list[index] as T;
      const usual = x && y ? kPoint : kind.fields(item);
      if (usual === undefined)
        throw new ApolloniusError(
          "not-finite",
          `item ${index} is ${described(item)}, expected ${kind.expected}`,
        );
      const usualR = usual[2] === undefined && !r ? radiusWithoutR(item, index) : usual[2];
      const values = [
        x ? x.call(that, item, index, items) : usual[0],
        y ? y.call(that, item, index, items) : usual[1],
        r ? r.call(that, item, index, items) : usualR,
      ];
      values.forEach((value, axis) => {
        // Names are made for errors only, as they cost more than the check.
        if (kind.error("", axis, value))
          throw kind.error(`${kind.names[axis]} of item ${index}`, axis, value);
        triples[3 * (index - from) + axis] = value as number;
      });
    }
    return triples;
  }
}

/** Reads the items of `Diagram.from`. */
export const circleReader = <T>(items: Items<T>, ...accessors: SomeAccessors<T>): ItemReader<T> =>
  new ItemReader(circles, items, ...accessors);
