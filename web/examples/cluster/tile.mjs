// A part of a diagram that is larger than memory: exactly the diagram of all circles in a window,
// from those near it and the largest of all. docs/SCALE.md has the proof.
import { Diagram } from "apollonius-diagram";

/** Places at which each side of the window is looked at; what is between them is allowed for. */
const kSteps = 1024;

/** Rounding of the sums below, against the numbers in them, with room to spare. */
const kRounding = 2 ** -40;

/**
 * The diagram of all circles in `window` ([xmin, ymin, xmax, ymax]): whatever is asked inside the
 * window has the answers that the diagram of all circles would give. `circles` is where they are:
 *
 *     within(bounds)   resolves to {xyr, ids, known}: all circles whose centres are in `known`,
 *                      which contains the bounds; ±Infinity on a side beyond which there are none.
 *                      The giants are left out
 *     giants           {xyr, ids}: circles that are always taken, wherever they are
 *     largest          no other circle has a larger radius than this
 *
 * `halo` is how far around the window is looked at first; it grows until the certificate holds.
 * Resolves to {diagram, ids, halo, rounds}: ids[k] is the id, in `circles`, of site k; the smallest
 * one if circles are identical, so that all tiles agree whose the cell is. Cost: that of building,
 * as often as the halo has to grow (rounds).
 */
export async function tile(circles, window, halo) {
  const [xmin, ymin, xmax, ymax] = window;
  for (let rounds = 1; ; ++rounds) {
    const around = [xmin - halo, ymin - halo, xmax + halo, ymax + halo];
    const { xyr, ids, known } = await circles.within(around);
    const diagram = new Diagram(joined(circles.giants.xyr, xyr));
    const lack = lackOf(diagram, window, known, circles.largest);
    if (lack < 0) {
      return { diagram, ids: named(diagram, joined(circles.giants.ids, ids)), halo, rounds };
    }
    diagram.dispose();
    // By what lacks it is enough for certain; but few circles make a large lack, and soon more are
    // known.
    halo += Math.min(lack + kRounding * sizeOf(known, halo), Math.max(halo, spanOf(window)));
  }
}

/**
 * By how much the circles in `known` fall short of settling the window; negative: whatever circles
 * there are outside of it, of radii up to `largest`, they have no part in the window, not even a
 * point as near. The maximum, over the points of the window, of
 *
 *     distance to the nearest known circle - (distance to the outside of `known` - largest)
 *
 * which is on the border: going from a point straight to the nearest side of `known`, the second
 * distance falls by as much as the way is long, and the first by no more.
 */
export function lackOf(diagram, window, known, largest) {
  const isAll = known.every((side) => !Number.isFinite(side));
  if (isAll || largest === -Infinity) return -Infinity; // there are no others
  if (diagram.size === 0) return Infinity;
  const xy = borderOf(window);
  const { ids, distances } = diagram.nearestMany(xy);
  const lack = distances.reduce(
    (most, distance, k) =>
      Math.max(most, distance + largest - inside(known, xy[2 * k], xy[2 * k + 1])),
    -Infinity,
  );
  let reach = 0;
  for (const id of new Set(ids)) {
    const { x, y, r } = diagram.site(id);
    reach = Math.max(reach, Math.abs(x) + Math.abs(y) + Math.abs(r));
  }
  // Neither distance changes by more than the way does, which is half a step at most.
  const between = spanOf(window) / kSteps;
  return lack + between + kRounding * (sizeOf(window, largest) + reach);
}

/** Points around a window, its corners among them. */
function borderOf([xmin, ymin, xmax, ymax]) {
  const xy = [];
  for (let k = 0; k <= kSteps; ++k) {
    const [x, y] = [xmin + (k / kSteps) * (xmax - xmin), ymin + (k / kSteps) * (ymax - ymin)];
    xy.push(x, ymin, x, ymax, xmin, y, xmax, y);
  }
  return Float64Array.from(xy);
}

/** Gives each visible site the smallest id of those that are the same circle. */
function named(diagram, ids) {
  for (let k = 0; k < ids.length; ++k) {
    if (!diagram.isHidden(k)) continue;
    const cover = diagram.coverOf(k); // no other one covers it, if there is a visible copy
    const [a, b] = [diagram.site(k), diagram.site(cover)];
    if (a.x === b.x && a.y === b.y && a.r === b.r) ids[cover] = Math.min(ids[cover], ids[k]);
  }
  return ids;
}

/** The distance of a point to the outside of a rectangle. */
function inside([xmin, ymin, xmax, ymax], x, y) {
  return Math.min(x - xmin, y - ymin, xmax - x, ymax - y);
}

/** An upper bound of the numbers that take part, for their rounding. */
function sizeOf(bounds, length) {
  return (
    bounds.reduce((sum, side) => sum + (Number.isFinite(side) ? Math.abs(side) : 0), 0) +
    Math.abs(length)
  );
}

function spanOf([xmin, ymin, xmax, ymax]) {
  return Math.max(xmax - xmin, ymax - ymin);
}

function joined(a, b) {
  const all = new a.constructor(a.length + b.length);
  all.set(a);
  all.set(b, a.length);
  return all;
}
