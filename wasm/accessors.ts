// Diagram.from and fromAsync: from any items to flat x, y, r triples.
import {
  allocated,
  checkSiteCount,
  described,
  detachedArray,
  isArrayLike,
  isDetached,
  numberError,
} from "./arguments.js";
import { ApolloniusError } from "./errors.js";

/**
 * Reads one number from an item; called with the item, its index and all items, as d3's accessors
 * are.
 */
export type Accessor<T> = (item: T, index: number, items: Iterable<T> | ArrayLike<T>) => number;

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

/** Items that can be read one by one, whatever the accessors do to them. */
export class ItemReader<T> {
  readonly count: number;
  readonly #list: ArrayLike<T>;
  readonly #read: (item: T, index: number) => [unknown, unknown, unknown];

  /** Throws "bad-length", "bad-option" or "too-large". */
  constructor(
    items: Iterable<T> | ArrayLike<T>,
    x?: Accessor<T>,
    y?: Accessor<T>,
    r?: Accessor<T>,
    that?: unknown,
  ) {
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
    const readR = r ?? ((item: T) => defaultR(item) ?? 0);
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
      this.#read(this.#list[index] as T, index).forEach((value, k) => {
        const error = numberError(`${"xyr"[k]} of item ${index}`, value);
        if (error) throw error;
        xyr[3 * (index - from) + k] = value as number;
      });
    }
    return xyr;
  }
}

export function triples<T>(...items: ConstructorParameters<typeof ItemReader<T>>): Float64Array {
  const reader = new ItemReader<T>(...items);
  return reader.triples(0, reader.count);
}
