// The difference between plane and sphere, for the calls that both kinds of diagrams have: what
// messages call a number, and which numbers are accepted. The library itself checks the numbers of
// a call. Only after it has refused one is that number looked for here, to be named in the message.
import type { ApolloniusError } from "../errors.js";
import { checkSiteId, isSiteId, numberError, throwFirst, unknownSite } from "./arguments.js";
import { type AnyNative, runningModule } from "./native/module.js";
import { ofSite, refusesNumbers } from "./native/native_errors.js";

export interface Space {
  /** What messages call the numbers of a site. */
  readonly names: readonly [x: string, y: string, r: string];
  /** What messages call an array of sites. */
  readonly sites: string;
  /** What messages call an array of points. */
  readonly points: string;
  /** The error of the number at place `axis` of a site; null if it is accepted. */
  error(name: string, axis: number, value: unknown, native: AnyNative): ApolloniusError | null;
  /** An empty diagram of the same kind. */
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

/** The first error of the numbers of a site. */
function errorOf({ native, space }: Asked, numbers: Numbers): ApolloniusError | null {
  for (const [axis, value] of numbers.entries()) {
    const error = space.error(space.names[axis] as string, axis, value, native);
    if (error) return error;
  }
  return null;
}

/**
 * Throws unless x, y and r are of type number; what number they may be is the library's to check.
 */
export function checkTypes(asked: Asked, x: unknown, y: unknown, r: unknown = 0): void {
  if (typeof x !== "number" || typeof y !== "number" || typeof r !== "number")
    throw errorOf(asked, [x, y, r]);
}

/** The error of a call with scalars, of which the message names the first bad one. */
export function ofNumbers(
  error: unknown,
  asked: Asked,
  x: unknown,
  y: unknown,
  r: unknown = 0,
): unknown {
  return refusesNumbers(error) ? (errorOf(asked, [x, y, r]) ?? error) : error;
}

/** The error of a call with sites or points, `perItem` numbers each; it names the first bad one. */
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
 * A diagram of which `id` is a site, for calls that say nothing of unknown ones. Throws
 * "unknown-site".
 */
export function withSite<Native extends AnyNative>(native: Native, id: number): Native {
  if (!isSiteId(id) || !native.has(id)) throw unknownSite(id);
  return native;
}

/** What `ask` says of a site; errors name it. */
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

/** What `ask` says of the numbers of a site; errors name the first bad one. */
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

/** What `ask` says of a point; errors name the coordinate. */
export function atPoint<Native extends AnyNative, Answer>(
  asked: Asked<Native>,
  x: number,
  y: number,
  ask: (native: Native) => Answer,
): Answer {
  return atSite(asked, x, y, 0, ask);
}
