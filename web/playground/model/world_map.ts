// The land and the outline of a map of the world: rings that cells can end at, and the shapes of
// them.

/** With rings x, y, … */
export type Part = { shape: Path2D; rings: number[][] };
/** The content of data/land.json. */
export type MapData = { outline: number[]; land: number[][] };
export type WorldMap = { land: Part; outline: Part };

/** The file has whole numbers: x, y, then differences from point to point. */
function ringOf(steps: number[]) {
  const ring: number[] = [];
  for (let k = 0; k < steps.length; k++) ring[k] = steps[k] + (k < 2 ? 0 : ring[k - 2]);
  return ring;
}

function makePart(steps: number[][]): Part {
  const rings = steps.map(ringOf);
  const shape = new Path2D();
  for (const ring of rings) {
    shape.moveTo(ring[0], ring[1]);
    for (let k = 2; k < ring.length; k += 2) shape.lineTo(ring[k], ring[k + 1]);
    shape.closePath();
  }
  return { shape, rings };
}

export const makeMap = ({ outline, land }: MapData): WorldMap => ({
  land: makePart(land),
  outline: makePart([outline]),
});
