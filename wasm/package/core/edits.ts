// The calls of Diagram that change it: what they are given is checked, and an error names the
// culprit.
import { ApolloniusError } from "../errors.js";
import {
  allocated,
  checkedIds,
  checkedNumbers,
  checkSiteId,
  checkWholeNumber,
  isSiteId,
  unknownSite,
} from "./arguments.js";
import type { NativeDiagram } from "./native/module.js";
import { checkTypes, ofElements, ofNumbers, ofSite } from "./native/native_errors.js";

export function insert(native: NativeDiagram, x: number, y: number, r: number): number {
  checkTypes(x, y, r);
  try {
    return native.insert(x, y, r);
  } catch (error) {
    throw ofNumbers(error, x, y, r);
  }
}

/** Of triples that have been checked. */
export function insertMany(native: NativeDiagram, xyr: ArrayLike<number>): Uint32Array {
  const ids = allocated(() => new Uint32Array(xyr.length / 3));
  try {
    native.insertMany(xyr, ids);
  } catch (error) {
    throw ofElements(error, "xyr", xyr);
  }
  return ids;
}

export function remove(native: NativeDiagram, id: number): boolean {
  checkWholeNumber(id);
  return isSiteId(id) && native.remove(id);
}

export function removeMany(native: NativeDiagram, ids: ArrayLike<number>): number {
  return native.removeMany(checkedIds("ids", ids));
}

export function update(native: NativeDiagram, id: number, x: number, y: number, r?: number): void {
  checkSiteId(id);
  try {
    const weight = r === undefined ? native.site(id).r : r;
    checkTypes(x, y, weight);
    native.update(id, x, y, weight);
  } catch (error) {
    throw ofNumbers(ofSite(error, id), x, y, r);
  }
}

export function updateMany(
  native: NativeDiagram,
  ids: ArrayLike<number>,
  xyr: ArrayLike<number>,
): void {
  const sites = checkedIds("ids", ids);
  const numbers = checkedNumbers("xyr", xyr, 3);
  if (numbers.length !== 3 * sites.length) {
    throw new ApolloniusError(
      "bad-length",
      `expected ${3 * sites.length} values in xyr for ${sites.length} ids, got ${numbers.length}`,
    );
  }
  try {
    native.updateMany(sites, numbers);
  } catch (error) {
    if (error instanceof ApolloniusError && error.code === "unknown-site") {
      const k = sites.findIndex((id) => !native.has(id));
      throw new ApolloniusError("unknown-site", `ids[${k}]: ${unknownSite(ids[k]).message}`);
    }
    throw ofElements(error, "xyr", numbers);
  }
}
