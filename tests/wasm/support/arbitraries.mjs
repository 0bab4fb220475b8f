// Arbitraries of fast-check for calls of a diagram: small integers, of which many coincide.
import fc from "fast-check";

const coordinate = fc.integer({ min: -6, max: 6 });
export const circle = fc.tuple(coordinate, coordinate, fc.integer({ min: 0, max: 4 }));
export const circles = (minLength, maxLength) => fc.array(circle, { minLength, maxLength });
export const point = fc.tuple(coordinate, coordinate);
/** A diagram or a site, as a fraction of those there are: shrinking keeps it meaningful. */
export const fraction = fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true });
export const fractions = (maxLength) => fc.array(fraction, { maxLength });
/** The item at a fraction of the list. */
export const pick = (items, at) => items[Math.floor(at * items.length)];
