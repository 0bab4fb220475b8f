// A set of circles that gives the answers which a diagram of them must give, by trying all circles.
// It is right for small integers: there two distances are equal or clearly apart.
const EQUAL = 1e-9;

/** Does the first circle hold the second one? */
export function covers([bx, by, br], [ax, ay, ar]) {
  return br >= ar && (ax - bx) ** 2 + (ay - by) ** 2 <= (br - ar) ** 2;
}

export const distanceTo = ([x, y, r], px, py) => Math.hypot(px - x, py - y) - r;
/** Distance to the far side of a circle. */
export const farSide = ([x, y, r], px, py) => Math.hypot(px - x, py - y) + r;
const areIdentical = (a, b) => a[0] === b[0] && a[1] === b[1] && a[2] === b[2];

/** Negative if circle a comes before b in a list of the nearest; 0 for identical ones. */
function compareAt(a, b, px, py) {
  const difference = distanceTo(a, px, py) - distanceTo(b, px, py);
  if (Math.abs(difference) > EQUAL) return difference;
  return b[2] - a[2] || b[0] - a[0] || b[1] - a[1];
}

export class BruteForce {
  constructor(circles = new Map()) {
    this.circles = circles; // by id
  }

  get size() {
    return this.circles.size;
  }
  get ids() {
    return [...this.circles.keys()].sort((a, b) => a - b);
  }
  copy() {
    return new BruteForce(new Map(this.circles));
  }

  /** The circles that have a cell; identical ones occur once. */
  get visibleCircles() {
    const different = [
      ...new Map([...this.circles.values()].map((circle) => [String(circle), circle])).values(),
    ];
    return different.filter(
      (circle) => !different.some((other) => other !== circle && covers(other, circle)),
    );
  }

  /** Can the site be visible? Then no circle covers it, except identical ones. */
  isCandidate(id) {
    const circle = this.circles.get(id);
    return ![...this.circles.values()].some(
      (other) => !areIdentical(other, circle) && covers(other, circle),
    );
  }

  identicalTo(id) {
    return this.ids.filter((other) => areIdentical(this.circles.get(other), this.circles.get(id)));
  }

  /** The circle whose far side is the farthest from a point; of several the last in the order. */
  farthestFrom(x, y) {
    const most = Math.max(...[...this.circles.values()].map((circle) => farSide(circle, x, y)));
    return [...this.circles.values()]
      .filter((circle) => most - farSide(circle, x, y) <= EQUAL)
      .sort((a, b) => b[2] - a[2] || b[0] - a[0] || b[1] - a[1])[0];
  }

  /** All circles in the order in which they are near to a point. */
  sortedAt(x, y) {
    return [...this.circles.values()].sort((a, b) => compareAt(a, b, x, y));
  }

  /** The circles up to this distance, nearest first. */
  within(x, y, distance) {
    return this.sortedAt(x, y).filter((circle) => distanceTo(circle, x, y) <= distance + EQUAL);
  }

  /** The circle on top of those that contain a point; else the nearest, if it is near; else -1. */
  pick(x, y, farthest, top) {
    const under = this.search(x, y, x, y);
    if (top === "smallest") {
      under.sort((one, other) => {
        const [c, d] = [this.circles.get(one), this.circles.get(other)];
        return d[2] - c[2] || compareAt(d, c, x, y) || other - one;
      });
    }
    const [nearest] = under.length > 0 ? [] : this.within(x, y, farthest);
    return under.at(-1) ?? this.ids.find((id) => this.circles.get(id) === nearest) ?? -1;
  }

  /** Ids of the circles that meet a rectangle, ascending. */
  search(xmin, ymin, xmax, ymax) {
    const clamped = (v, low, high) => Math.min(Math.max(v, low), high);
    return this.ids
      .filter((id) => {
        const circle = this.circles.get(id);
        const [x, y] = circle;
        return distanceTo(circle, clamped(x, xmin, xmax), clamped(y, ymin, ymax)) <= EQUAL;
      })
      .sort((a, b) => a - b);
  }

  /** The support function: the largest coordinate of the circles in a direction. */
  reach(ux, uy) {
    return Math.max(...[...this.circles.values()].map(([x, y, r]) => x * ux + y * uy + r));
  }
}
