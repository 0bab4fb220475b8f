// Changes of a diagram, of the plane or of the sphere.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedIds,
  checkedNewSites,
  checkedNumbers,
  checkSiteId,
  unknownSite,
} from "./arguments.js";
import type { Inner } from "./inner.js";
import { ofSite } from "./native/native_errors.js";
import { atSite, checkTypes, ofItems, ofNumbers } from "./space.js";

export function insert(inner: Inner, x: number, y: number, r: number): number {
  const id = atSite(inner, x, y, r, (native) => native.insert(x, y, r));
  inner.ballast.carry(id + 1);
  return id;
}

export function insertMany(inner: Inner, sites: ArrayLike<number>): Uint32Array {
  const { native, space, ballast } = inner;
  const numbers = checkedNewSites(space.sites, sites);
  const ids = allocated(() => new Uint32Array(numbers.length / 3));
  try {
    native.insertMany(numbers, ids);
  } catch (error) {
    throw ofItems(error, inner, numbers, 3);
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

export function updateMany(inner: Inner, ids: ArrayLike<number>, sites: ArrayLike<number>): void {
  const { native, space } = inner;
  const checked = checkedIds("ids", ids);
  const numbers = checkedNumbers(space.sites, sites, 3);
  const expected = 3 * checked.length;
  if (numbers.length !== expected)
    throw new ApolloniusError(
      "bad-length",
      `expected ${expected} values in ${space.sites} for ${checked.length} ids, got ` +
        numbers.length,
    );
  try {
    native.updateMany(checked, numbers);
  } catch (error) {
    if (error instanceof ApolloniusError && error.code === "unknown-site") {
      const k = checked.findIndex((id) => !native.has(id));
      throw new ApolloniusError("unknown-site", `ids[${k}]: ${unknownSite(checked[k]).message}`);
    }
    throw ofItems(error, inner, numbers, 3);
  }
}
