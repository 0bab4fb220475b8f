// Drawing contexts for tests, and plain geometry of rings.

/** Writes down every call as [name, ...numbers]. */
export class Recorder {
  calls = [];
  moveTo(...xy) {
    this.calls.push(["moveTo", ...xy]);
  }
  lineTo(...xy) {
    this.calls.push(["lineTo", ...xy]);
  }
  bezierCurveTo(...xy) {
    this.calls.push(["bezierCurveTo", ...xy]);
  }
  closePath() {
    this.calls.push(["closePath"]);
  }
  count(name) {
    return this.calls.filter(([called]) => called === name).length;
  }
}

/** Signed area of a closed ring x, y, …: positive if it is counter-clockwise. */
export function ringArea(ring) {
  let sum = 0;
  for (let k = 0; k + 3 < ring.length; k += 2) {
    sum +=
      (ring[k] - ring[0]) * (ring[k + 3] - ring[1]) -
      (ring[k + 2] - ring[0]) * (ring[k + 1] - ring[1]);
  }
  return sum / 2;
}

/** Is the point inside the ring (even-odd)? */
export function isInside(ring, x, y) {
  let inside = false;
  for (let k = 0; k + 3 < ring.length; k += 2) {
    const [ax, ay, bx, by] = [ring[k], ring[k + 1], ring[k + 2], ring[k + 3]];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  }
  return inside;
}
