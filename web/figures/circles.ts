// Circles that several figures share.

/** A bubble chart in which the nearest centre is often the wrong answer: x, y, r of each. */
export const kBubbles = [
  [104, 128, 82],
  [216, 60, 24],
  [232, 150, 15],
  [196, 214, 12],
  [290, 96, 20],
  [56, 250, 26],
  [136, 290, 48],
  [262, 262, 62],
  [318, 172, 13],
  [28, 36, 14],
  [330, 330, 17],
  [44, 330, 12],
  [204, 336, 11],
  [160, 28, 9],
  [326, 32, 22],
  [72, 196, 8],
  [222, 184, 7],
  [340, 224, 9],
] as const;

/** One after the other, as the package takes them. */
export const flat = (circles: readonly (readonly number[])[]) => Float64Array.from(circles.flat());
