// Changes of a diagram, of the plane or of the sphere.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedIds,
  checkedNewSites,
  checkedNumbers,
  checkedR,
  checkOptions,
  checkSiteId,
  triplesOf,
  unknownSite,
} from "./arguments.js";
import type { Inner } from "./inner.js";
import { ofSite, refusesNumbers } from "./native/native_errors.js";
import { atSite, checkTypes, ofItems, ofNumbers } from "./space.js";
import type { RadiusOption, UpdateOptions } from "./types.js";

export function insert(inner: Inner, x: number, y: number, r: number): number {
  const id = atSite(inner, x, y, r, (native) => native.insert(x, y, r));
  inner.ballast.carry(id + 1);
  return id;
}

/** The error of a call with triples, or with pairs if `r` is given; it names the first bad one. */
function ofSites(
  error: unknown,
  inner: Inner,
  numbers: ArrayLike<number>,
  r: number | string | undefined,
): unknown {
  const named = ofItems(error, inner, numbers, r === undefined ? 3 : 2);
  const isOfR = typeof r === "number" && refusesNumbers(error);
  return (isOfR && inner.space.error("options.r", 2, r, inner.native)) || named;
}

export function insertMany(
  inner: Inner,
  sites: ArrayLike<number>,
  options: RadiusOption | undefined,
): Uint32Array {
  const { native, space, ballast } = inner;
  checkOptions(options, "r");
  const r = checkedR(options?.r);
  const numbers = checkedNewSites(space, sites, r);
  const triples = triplesOf(numbers, r);
  const ids = allocated(() => new Uint32Array(triples.length / 3));
  try {
    native.insertMany(triples, ids);
  } catch (error) {
    throw ofSites(error, inner, numbers, r);
  }
  ballast.carry(native.size());
  return ids;
}

export function update(
  inner: Inner,
  id: number,
  x: number,
  y: number,
  r: number | undefined,
): void {
  const { native } = inner;
  checkSiteId(id);
  try {
    const weight = r === undefined ? native.site(id).r : r;
    checkTypes(inner, x, y, weight);
    native.update(id, x, y, weight);
  } catch (error) {
    throw ofNumbers(ofSite(error, id), inner, x, y, r);
  }
}

export function updateMany(
  inner: Inner,
  ids: ArrayLike<number>,
  sites: ArrayLike<number>,
  options: UpdateOptions | undefined,
): void {
  const { native, space } = inner;
  const checked = checkedIds("ids", ids);
  checkOptions(options, "r");
  const r = options?.r === "keep" ? "keep" : checkedR(options?.r);
  const [name, each] = r === undefined ? [space.sites, 3] : [space.points, 2];
  const numbers = checkedNumbers(name, sites, each);
  const expected = each * checked.length;
  if (numbers.length !== expected)
    throw new ApolloniusError(
      "bad-length",
      `expected ${expected} values in ${name} for ${checked.length} ids, got ${numbers.length}`,
    );
  try {
    const radii = r === "keep" ? Array.from(checked, (id) => native.site(id).r) : r;
    native.updateMany(checked, triplesOf(numbers, radii));
  } catch (error) {
    if (error instanceof ApolloniusError && error.code === "unknown-site") {
      const k = checked.findIndex((id) => !native.has(id));
      throw new ApolloniusError("unknown-site", `ids[${k}]: ${unknownSite(checked[k]).message}`);
    }
    throw ofSites(error, inner, numbers, r);
  }
}
