// A circle, and what encloses some.

export type Circle = { x: number; y: number; r: number };
/** A circle as the numbers x, y, r. */
export type Triple = [number, number, number];
/** The numbers xmin, ymin, xmax, ymax. */
export type Bounds = [number, number, number, number];
