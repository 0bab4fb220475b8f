// What the queries of Diagram have in common: they ask the module, and an error names the culprit.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedChoice,
  checkNumber,
  checkOptions,
  checkSiteId,
  optionsLast,
} from "./arguments.js";
import { checkedFilter, filterOf, type Filters, type Found, passing } from "./filters.js";
import { type NativeDiagram, type NearestFirst, runningModule } from "./native/module.js";
import { checkTypes, ofElements, ofNumbers, ofSite } from "./native/native_errors.js";
import type { FilterOptions, NearbyFilter, PickArguments, PickOptions } from "./types.js";

/** What `ask` says of a site; errors name it. */
export function ofOne<Answer>(
  native: NativeDiagram,
  id: number,
  ask: (native: NativeDiagram) => Answer,
): Answer {
  checkSiteId(id);
  try {
    return ask(native);
  } catch (error) {
    throw ofSite(error, id);
  }
}

/** What `ask` says of a point; errors name the coordinate. */
export function atPoint<Answer>(
  native: NativeDiagram,
  x: number,
  y: number,
  ask: (native: NativeDiagram) => Answer,
): Answer {
  checkTypes(x, y);
  try {
    return ask(native);
  } catch (error) {
    throw ofNumbers(error, x, y);
  }
}

/** `nearest`, and `find` where there are options. */
export function nearestOf(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  options?: FilterOptions,
): Found | null {
  checkTypes(x, y);
  const filter = filterOf(options);
  if (filter !== undefined) return passing(walkFrom(native, x, y, Infinity), filter, filters);
  const found = atPoint(native, x, y, () => native.nearest(x, y));
  return found.id === -1 ? null : found;
}

/** So few points are asked one by one sooner than their arrays are copied to the heap and back. */
const kFew = 16;

/** The nearest site of each point; fills in the distances, if there is an array. */
export function findAll(
  native: NativeDiagram,
  numbers: ArrayLike<number>,
  distances?: Float64Array,
): Int32Array {
  const ids = allocated(() => new Int32Array(numbers.length / 2));
  try {
    if (distances === undefined && ids.length <= kFew)
      for (let k = 0; k < ids.length; ++k)
        ids[k] = native.find(numbers[2 * k] as number, numbers[2 * k + 1] as number);
    else native.findMany(numbers, ids, distances ?? null);
  } catch (error) {
    throw ofElements(error, "xy", numbers);
  }
  return ids;
}

/** For the sites that a filter lets through. */
export const emptyDiagram = () => runningModule().create("hierarchy");

export function walkFrom(
  native: NativeDiagram,
  x: number,
  y: number,
  farthest: number,
): NearestFirst {
  return atPoint(native, x, y, () => native.nearestFirst(x, y, farthest)) as NearestFirst;
}

export const orInfinity = (given: unknown): unknown => (given === undefined ? Infinity : given);

export function checkedMaxDistance(name: string, maxDistance: unknown): number {
  if (maxDistance !== Infinity) checkNumber(name, maxDistance);
  return maxDistance as number;
}

/** The largest distance, which circle is on top, and the filter. */
export type Picking = [number, "smallest" | "last", NearbyFilter | undefined];

export function checkedPicking(how: PickArguments): Picking {
  const [maxDistance, options] = optionsLast(how) as [number?, PickOptions?];
  const farthest = checkedMaxDistance("maxDistance", orInfinity(maxDistance));
  if (farthest < 0)
    throw new ApolloniusError(
      "out-of-range",
      `maxDistance is ${farthest}, expected a distance from 0 on`,
    );
  checkOptions(options, "top", "filter");
  const top = checkedChoice("options.top", options?.top, ["smallest", "last"]);
  return [farthest, top, checkedFilter(options?.filter)];
}

export function pickThrough(
  native: NativeDiagram,
  filters: Filters,
  x: number,
  y: number,
  [farthest, top]: Picking,
  filter: NearbyFilter,
): Found | null {
  return passing(walkFrom(native, x, y, farthest), filter, filters, (id, other) => {
    const less = top === "last" ? 0 : native.site(id).r - native.site(other).r;
    return less === 0 ? id > other : less < 0;
  });
}

/** What `pick` says of each point; most are in no circle, and the nearest site is the answer. */
export function pickAll(
  native: NativeDiagram,
  numbers: ArrayLike<number>,
  [farthest, top]: Picking,
): Int32Array {
  const distances = allocated(() => new Float64Array(numbers.length / 2));
  const ids = findAll(native, numbers, distances);
  distances.forEach((distance, k) => {
    // Distances are rounded: where they are next to the limit, the exact search decides.
    if (!(distance > 0 && distance < farthest * 0.999))
      ids[k] = native.pick(
        numbers[2 * k]!,
        numbers[2 * k + 1]!,
        farthest,
        runningModule().Top[top],
      );
  });
  return ids;
}

/** null, or the first broken invariant in words. */
export function validate(native: Pick<NativeDiagram, "validate">): string | null {
  const { what, where, level } = native.validate();
  if (what === "") return null;
  return `${level === 0 ? "" : `level ${level}: `}${what} ${where}`;
}
