// Argument checks, and messages that say what is wrong with an argument. The library itself checks
// numbers (once, in src/api). This file checks what only JavaScript can get wrong, and finds the
// bad number after the library has refused one.
import { ApolloniusError } from "../errors.js";

// The documented range of magnitudes and the most sites: as in src/apollonius/types.h.
const kSmallestMagnitude = 1e-100;
const kLargestMagnitude = 1e100;
const kMostSites = 2 ** 29;
const kNoSite = 0xffffffff; // not a valid id

export function described(value: unknown): string {
  if (typeof value === "string") return `the string ${JSON.stringify(value)}`;
  if (typeof value === "bigint") return `the bigint ${value}n`;
  if (Array.isArray(value)) return `an array of ${value.length}`;
  if (typedArrayKind(value)?.endsWith("Array"))
    return `${typedArrayKind(value)}(${(value as ArrayLike<unknown>).length})`;
  if (typeof value === "object" && value !== null)
    return "then" in value ? "a promise, not awaited" : "an object";
  if (typeof value === "function") return "a function";
  return String(value);
}

/** Returns the error of a value as a coordinate or weight, or null if it is accepted. */
export function numberError(name: string, value: unknown): ApolloniusError | null {
  if (typeof value !== "number" || !Number.isFinite(value)) {
    return new ApolloniusError(
      "not-finite",
      `${name} is ${described(value)}, expected a finite number`,
    );
  }
  if (Math.abs(value) > kLargestMagnitude) {
    return new ApolloniusError(
      "out-of-range",
      `${name} is ${value}, expected a magnitude of at most 1e100, where answers are exact`,
    );
  }
  return null;
}

/** Returns 0 for -0 and magnitudes below 1e-100, as the library does (src/apollonius/types.h). */
export function taken(value: number): number {
  return Math.abs(value) < kSmallestMagnitude ? 0 : value;
}

/** Throws unless the value can be a coordinate or weight. */
export function checkNumber(name: string, value: unknown): void {
  const error = numberError(name, value);
  if (error) throw error;
}

/** Checks a count: any whole number from 0 on, or Infinity. Returns at most 2^32 - 1. */
export function checkedCount(name: string, value: unknown): number {
  if (typeof value !== "number" || Number.isNaN(value)) {
    throw new ApolloniusError(
      "not-finite",
      `${name} is ${described(value)}, expected a whole number`,
    );
  }
  if (!(value >= 0 && (Number.isInteger(value) || value === Infinity))) {
    throw new ApolloniusError(
      "out-of-range",
      `${name} is ${value}, expected a whole number from 0 on`,
    );
  }
  return Math.min(value, 2 ** 32 - 1);
}

/** Returns the value if it is one of several words; the first word if it is undefined. */
export function checkedChoice<Word extends string | boolean>(
  name: string,
  value: unknown,
  words: readonly [Word, ...Word[]],
): Word {
  if (value === undefined) return words[0];
  if (words.includes(value as Word)) return value as Word;
  const expected = words.map((word) => JSON.stringify(word)).join(" or ");
  throw new ApolloniusError("bad-option", `${name} is ${described(value)}, expected ${expected}`);
}

/** Throws the first error of an array's elements, if there is one. */
export function throwFirst(
  values: ArrayLike<number>,
  errorOf: (value: number, k: number) => ApolloniusError | null,
): void {
  for (let k = 0; k < values.length; ++k) {
    const error = errorOf(values[k] as number, k);
    if (error) throw error;
  }
}

export function isSiteId(id: unknown): id is number {
  return typeof id === "number" && id >>> 0 === id && id !== kNoSite;
}

/** Throws "unknown-site" for a value that cannot be an id. */
export function checkSiteId(id: unknown): void {
  if (!isSiteId(id)) throw unknownSite(id);
}

/** Throws "unknown-site" for a value that is no whole number. (-1 is an id that no site has.) */
export function checkWholeNumber(id: unknown): void {
  if (!Number.isInteger(id)) throw unknownSite(id);
}

export function unknownSite(id: unknown): ApolloniusError {
  return new ApolloniusError(
    "unknown-site",
    Number.isInteger(id)
      ? `site ${id} does not exist`
      : `site ${described(id)} does not exist: ids are whole numbers, not strings or objects`,
  );
}

// Getters of the properties of typed arrays. Properties of an object can be overwritten; these
// getters read the true values, for typed arrays of any realm.
const ofTypedArray = (property: string | symbol) =>
  Object.getOwnPropertyDescriptor(Object.getPrototypeOf(Uint8Array.prototype), property)
    ?.get as () => unknown;
const kindOf = ofTypedArray(Symbol.toStringTag);
const views = ["buffer", "byteOffset", "length"].map(ofTypedArray);

export function isArrayLike(values: unknown): values is ArrayLike<unknown> {
  return (
    typeof values === "object" &&
    values !== null &&
    Number.isSafeInteger((values as ArrayLike<unknown>).length) &&
    (values as ArrayLike<unknown>).length >= 0
  );
}

/** Returns "Float64Array" and so on for typed arrays of any realm; undefined for anything else. */
export function typedArrayKind(values: unknown): string | undefined {
  return kindOf.call(values) as string | undefined;
}

/**
 * Returns a new view of a typed array's memory, so that `length` cannot be faked. Returns other
 * values unchanged, and arrays that have lost their memory.
 */
export function plainView(values: unknown): unknown {
  const kind = typedArrayKind(values);
  if (kind === undefined || isDetached(values)) return values;
  type Kind = new (...view: unknown[]) => unknown;
  return new (globalThis as unknown as Record<string, Kind>)[kind]!(
    ...views.map((view) => view.call(values)),
  );
}

/**
 * Has a typed array lost its elements, because its buffer went to another thread or shrank? It then
 * looks empty, which the caller hardly means.
 */
export function isDetached(values: unknown): boolean {
  if (typedArrayKind(values) === undefined || views[2]!.call(values) !== 0) return false;
  try {
    // of any kind and realm; throws if there is no memory behind it
    Float64Array.prototype.at.call(values, 0);
    return false;
  } catch {
    return true;
  }
}

export function detachedArray(name: string, of: string): ApolloniusError {
  return new ApolloniusError(
    "bad-length",
    `${name} is a typed array whose buffer is detached or shrunk, expected an array of ${of}`,
  );
}

function checkedArray(name: string, given: unknown, of: string): ArrayLike<unknown> {
  const values = plainView(given);
  if (!isArrayLike(values))
    throw new ApolloniusError(
      "bad-length",
      `${name} is ${described(values)}, expected an array of ${of}`,
    );
  if (isDetached(values)) throw detachedArray(name, of);
  return values;
}

/** Throws if there are more sites than one diagram can hold. To call before any of them is read. */
export function checkSiteCount(name: string, count: number): void {
  if (count > kMostSites)
    throw new ApolloniusError("too-large", `${name} holds ${count} sites, expected at most 2^29`);
}

/**
 * Returns the bytes of an ArrayBuffer or of a Uint8Array of any realm, which may be a part of its
 * buffer. Throws "bad-length".
 */
export function checkedBytes(name: string, given: unknown): Uint8Array {
  const bytes = isArrayBuffer(given) ? new Uint8Array(given) : given;
  if (typedArrayKind(bytes) !== "Uint8Array") {
    throw new ApolloniusError(
      "bad-length",
      `${name} is ${described(given)}, expected a Uint8Array or an ArrayBuffer`,
    );
  }
  return checkedArray(name, bytes, "bytes") as Uint8Array;
}

/** Is it an ArrayBuffer of any realm that still has its memory? */
function isArrayBuffer(given: unknown): given is ArrayBuffer {
  try {
    ArrayBuffer.prototype.slice.call(given as ArrayBuffer, 0, 0);
    return true;
  } catch {
    return false;
  }
}

export function outOfMemory(): ApolloniusError {
  return new ApolloniusError(
    "out-of-memory",
    "not enough memory; dispose() or `using` frees a diagram at once, while a forgotten one " +
      "waits for a turn of the event loop",
  );
}

/** Returns a new typed array. Throws "out-of-memory" if there can be none of that length. */
export function allocated<Values>(make: () => Values): Values {
  try {
    return make();
  } catch {
    throw outOfMemory();
  }
}

/**
 * Returns numbers that can be copied to the heap in one go. Typed arrays are returned as they are.
 * Anything else is copied element by element, so that strings and nulls are refused and not turned
 * into numbers.
 */
export function checkedNumbers(
  name: string,
  values: unknown,
  multipleOf: number,
): ArrayLike<number> {
  return copied(name, counted(name, values, multipleOf));
}

/** The names of arrays of sites, and of points, in messages. */
interface ArrayNames {
  readonly sites: string;
  readonly points: string;
}

/** Does `checkedNumbers` for triples of new sites, or for pairs where `r` is given. */
export function checkedNewSites(
  { sites, points }: ArrayNames,
  values: unknown,
  r: unknown,
): ArrayLike<number> {
  const [name, each] = r === undefined ? [sites, 3] : [points, 2];
  const array = counted(name, values, each);
  checkSiteCount(name, array.length / each);
  return copied(name, array);
}

/** Returns the radius that an option gives to all sites, or undefined. Throws "not-finite". */
export function checkedR(r: unknown): number | undefined {
  if (r === undefined || (typeof r === "number" && Number.isFinite(r))) return r;
  throw numberError("options.r", r) as ApolloniusError;
}

/** Returns triples of pairs with one radius for all, or one for each; without `r`, `numbers`. */
export function triplesOf(
  numbers: ArrayLike<number>,
  r: number | ArrayLike<number> | undefined,
): ArrayLike<number> {
  if (r === undefined) return numbers;
  const triples = allocated(() => new Float64Array((numbers.length / 2) * 3));
  for (let k = 0; 2 * k < numbers.length; ++k) {
    triples[3 * k] = numbers[2 * k] as number;
    triples[3 * k + 1] = numbers[2 * k + 1] as number;
    triples[3 * k + 2] = typeof r === "number" ? r : (r[k] as number);
  }
  return triples;
}

function counted(name: string, values: unknown, multipleOf: number): ArrayLike<unknown> {
  const array = checkedArray(name, values, "numbers");
  if (array.length % multipleOf !== 0) {
    if (typeof array[0] === "object") throw elementError(name, 0, array[0]);
    throw new ApolloniusError(
      "bad-length",
      `expected a multiple of ${multipleOf} values in ${name}, got ${array.length}`,
    );
  }
  return array;
}

/** Returns the error of an element that is no number, with a hint at `from` for rows of numbers. */
function elementError(name: string, k: number, value: unknown): ApolloniusError {
  const error = numberError(`${name}[${k}]`, value) as ApolloniusError;
  if (typeof value !== "object" || value === null) return error;
  const hint =
    name === "xyr" || name === "lonLatR"
      ? "[x, y, r, x, y, r]; Diagram.from(rows) reads rows"
      : name === "xy" || name === "lonLat"
        ? "[x, y, x, y]; points.flat() makes it of rows"
        : "[1, 2, 3]";
  return new ApolloniusError(error.code, `${error.message}: ${name} is flat, as in ${hint}`);
}

function copied(name: string, array: ArrayLike<unknown>): ArrayLike<number> {
  const kind = typedArrayKind(array);
  if (kind !== undefined && !kind.startsWith("Big")) return array as ArrayLike<number>;
  const numbers = allocated(() => new Float64Array(array.length));
  for (let k = 0; k < numbers.length; ++k) {
    const value = array[k];
    if (typeof value !== "number") throw elementError(name, k, value);
    numbers[k] = value;
  }
  return numbers;
}

/**
 * Returns site ids for the heap, with kNoSite for numbers that no site can have as id. Throws
 * "unknown-site" for a value that is no whole number.
 */
export function checkedIds(name: string, ids: unknown): Uint32Array {
  const array = checkedArray(name, ids, "site ids");
  if (typedArrayKind(array) === "Uint32Array") return array as Uint32Array;
  const checked = allocated(() => new Uint32Array(array.length));
  for (let k = 0; k < checked.length; ++k) {
    const id = array[k];
    if (!Number.isInteger(id))
      throw new ApolloniusError("unknown-site", `${name}[${k}]: ${unknownSite(id).message}`);
    checked[k] = isSiteId(id) ? id : kNoSite;
  }
  return checked;
}

type Bounds = [number, number, number, number];

/** Returns four numbers xmin, ymin, xmax, ymax; throws "bad-bounds". */
export function checkedNumbersOfBounds(bounds: ArrayLike<unknown>): Bounds {
  return ["xmin", "ymin", "xmax", "ymax"].map((name, k) => {
    const value = bounds[k]; // read once: a getter may say something else the next time
    const error = numberError(`${name} of bounds`, value);
    if (error) throw new ApolloniusError("bad-bounds", error.message);
    return taken(value as number);
  }) as unknown as Bounds;
}

/** Checks a window [xmin, ymin, xmax, ymax]: xmin < xmax, ymin < ymax; throws "bad-bounds". */
export function checkedBounds(bounds: unknown): Bounds {
  if (!isArrayLike(bounds) || bounds.length !== 4) {
    throw new ApolloniusError(
      "bad-bounds",
      `bounds is ${described(bounds)}, expected [xmin, ymin, xmax, ymax]`,
    );
  }
  const checked = checkedNumbersOfBounds(bounds);
  if (!(checked[0] < checked[2] && checked[1] < checked[3])) throw disorderedBounds(checked, "<");
  return checked;
}

export function disorderedBounds(bounds: Bounds, order: "<" | "<="): ApolloniusError {
  return new ApolloniusError(
    "bad-bounds",
    `bounds are [${bounds.join(", ")}], expected xmin ${order} xmax and ymin ${order} ymax`,
  );
}

/** Returns a positive number, by default `usual()`; throws "not-finite" or "out-of-range". */
export function checkedTolerance(tolerance: unknown, usual: () => number): number {
  if (tolerance === undefined) return usual();
  if (typeof tolerance !== "number" || !Number.isFinite(tolerance))
    throw numberError("tolerance", tolerance) as ApolloniusError;
  if (!(tolerance > 0))
    throw new ApolloniusError(
      "out-of-range",
      `tolerance is ${tolerance}, expected a number above 0`,
    );
  return tolerance;
}

// --- Options as callers give them: an unknown name is probably misspelt --------------------------

/** Throws "bad-option" unless `options` is undefined, null or an object with these names only. */
export function checkOptions(options: unknown, ...names: string[]): void {
  if (options === undefined || options === null) return;
  if (isIndex(options) && !names.includes("maxDistance") && !names.includes("r")) return;
  if (typeof options !== "object" || Array.isArray(options) || ArrayBuffer.isView(options))
    throw badOptions(`options is ${described(options)}`, names, typeof options === "number");
  for (const name in options)
    if (!names.includes(name)) throw badOptions(`options.${name} is unknown`, names);
}

/** Is it an index, which `map` passes in place of options: `ids.map(view.cellPolygon, view)`? */
const isIndex = (options: unknown): boolean => Number.isInteger(options) && Number(options) >= 0;

/** Returns the error; a number may be meant as d3-quadtree's radius or d3-delaunay's start. */
function badOptions(what: string, names: string[], isNumber = false): ApolloniusError {
  const hint =
    isNumber && names.includes("maxDistance")
      ? ": { maxDistance: 20 } is a limit, as d3-quadtree's radius; a start, as d3-delaunay's, " +
        "is not needed"
      : "";
  return new ApolloniusError("bad-option", `${what}, expected { ${names.join(", ")} }${hint}`);
}
