// A window of 100 by 60, and the same with a triangular hole.
export const box = [0, 0, 100, 60];
const hole = [
  [40, 20],
  [60, 25],
  [50, 45],
];
export const withHole = [
  [
    [0, 0],
    [100, 0],
    [100, 60],
    [0, 60],
  ],
  hole,
];

/** [name, window, does it hold a point that is in the box?]. */
export const windows = [
  ["bounds", box, () => true],
  ["a region with a hole", withHole, (x, y) => !isInHole(x, y)],
];

function isInHole(x, y) {
  return hole.every(([ax, ay], k) => {
    const [bx, by] = hole[(k + 1) % 3];
    return (bx - ax) * (y - ay) - (x - ax) * (by - ay) > 0;
  });
}
