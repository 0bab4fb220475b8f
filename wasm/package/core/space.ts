// The difference between plane and sphere, for the calls that both kinds of diagrams have: the
// names of numbers in messages, and which numbers are accepted. The library itself checks the
// numbers of a call. Only if it refuses one, this file looks for that number, to name it in the
// message.
import type { ApolloniusError } from "../errors.js";
import { checkSiteId, isSiteId, numberError, throwFirst, unknownSite } from "./arguments.js";
import { type AnyNative, runningModule } from "./native/module.js";
import { ofSite, refusesNumbers } from "./native/native_errors.js";

export interface Space {
  /** The names of a site's numbers in messages. */
  readonly names: readonly [x: string, y: string, r: string];
  /** The name of an array of sites in messages. */
  readonly sites: string;
  /** The name of an array of points in messages. */
  readonly points: string;
  /** Returns the error of the number with index `axis` of a site, or null if it is accepted. */
  error(name: string, axis: number, value: unknown, native: AnyNative): ApolloniusError | null;
  /** Returns an empty diagram of the same kind. */
  empty(like: AnyNative): AnyNative;
}

export const plane: Space = {
  names: ["x", "y", "r"],
  sites: "xyr",
  points: "xy",
  error: (name, _, value) => numberError(name, value),
  empty: () => runningModule().create(),
};

type Numbers = readonly [x: unknown, y: unknown, r?: unknown];
/** The diagram of a call. */
interface Asked<Native extends AnyNative = AnyNative> {
  readonly native: Native;
  readonly space: Space;
}

/** Returns the first error of a site's numbers, or null. */
function errorOf({ native, space }: Asked, numbers: Numbers): ApolloniusError | null {
  for (const [axis, value] of numbers.entries()) {
    const error = space.error(space.names[axis] as string, axis, value, native);
    if (error) return error;
  }
  return null;
}

/** Throws unless x, y and r are of type number. The library itself checks their values. */
export function checkTypes(asked: Asked, x: unknown, y: unknown, r: unknown = 0): void {
  if (typeof x !== "number" || typeof y !== "number" || typeof r !== "number")
    throw errorOf(asked, [x, y, r]);
}

/** Returns the error of a call with scalars; its message names the first bad one. */
export function ofNumbers(
  error: unknown,
  asked: Asked,
  x: unknown,
  y: unknown,
  r: unknown = 0,
): unknown {
  return refusesNumbers(error) ? (errorOf(asked, [x, y, r]) ?? error) : error;
}

/**
 * Returns the error of a call with sites or points of `perItem` numbers each, or throws one that
 * names the first bad number.
 */
export function ofItems(
  error: unknown,
  { native, space }: Asked,
  numbers: ArrayLike<number>,
  perItem: 2 | 3,
): unknown {
  if (!refusesNumbers(error)) return error;
  const name = perItem === 3 ? space.sites : space.points;
  throwFirst(numbers, (value, k) => space.error(`${name}[${k}]`, k % perItem, value, native));
  return error;
}

/**
 * Returns the diagram if it has the site `id`, for calls that do not check ids themselves. Throws
 * "unknown-site".
 */
export function withSite<Native extends AnyNative>(native: Native, id: number): Native {
  if (!isSiteId(id) || !native.has(id)) throw unknownSite(id);
  return native;
}

/** Returns the answer of `ask` about a site; errors name its id. */
export function ofOne<Native extends AnyNative, Answer>(
  native: Native,
  id: number,
  ask: (native: Native) => Answer,
): Answer {
  checkSiteId(id);
  try {
    return ask(native);
  } catch (error) {
    throw ofSite(error, id);
  }
}

/** Returns the answer of `ask` about a site's numbers; errors name the first bad one. */
export function atSite<Native extends AnyNative, Answer>(
  asked: Asked<Native>,
  x: number,
  y: number,
  r: number,
  ask: (native: Native) => Answer,
): Answer {
  checkTypes(asked, x, y, r);
  try {
    return ask(asked.native);
  } catch (error) {
    throw ofNumbers(error, asked, x, y, r);
  }
}

/** Returns the answer of `ask` about a point; errors name the coordinate. */
export function atPoint<Native extends AnyNative, Answer>(
  asked: Asked<Native>,
  x: number,
  y: number,
  ask: (native: Native) => Answer,
): Answer {
  return atSite(asked, x, y, 0, ask);
}
