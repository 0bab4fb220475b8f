// Small circles as they look on the screen, kept to be used again for all of about the same radius
// and place in a pixel.

const kPlaces = 4; // in each direction of a pixel
const kRadii = 8; // a pixel

/** Alphas of disc and rim, up to 255, and the width of the rim. */
export type Ink = { fill: number; stroke: number; line: number };

/** How far a circle with its rim reaches. */
export const outerOf = (r: number, { line }: Ink) => r + line / 2 + 0.5;

/** The alpha of a pixel whose middle is at (dx, dy) from a circle's centre. */
export function alphaAt(dx: number, dy: number, r: number, { fill, stroke, line }: Ink) {
  const inside = r - Math.sqrt(dx * dx + dy * dy);
  const rim = line / 2 + 0.5 - Math.abs(inside);
  const alpha = fill * Math.max(0, Math.min(1, inside + 0.5));
  if (rim <= 0) return alpha;
  const onRim = Math.min(rim, line, 1) * stroke;
  return alpha + onRim - (alpha * onRim) / 255;
}

export class Stamps {
  #known: ({ reach: number; alphas: Uint8Array } | undefined)[] = [];

  constructor(readonly ink: Ink) {}

  /** Alphas of 2 reach + 1 rows and columns around the pixel that the centre is in. */
  of(x: number, y: number, r: number) {
    const column = Math.floor((x - Math.floor(x)) * kPlaces);
    const row = Math.floor((y - Math.floor(y)) * kPlaces);
    const radius = Math.round(r * kRadii);
    const key = (radius * kPlaces + row) * kPlaces + column;
    this.#known[key] ??= this.#made(
      (column + 0.5) / kPlaces,
      (row + 0.5) / kPlaces,
      radius / kRadii,
    );
    return this.#known[key];
  }

  #made(x: number, y: number, r: number) {
    const reach = Math.ceil(outerOf(r, this.ink));
    const size = 2 * reach + 1;
    const alphas = new Uint8Array(size * size);
    for (let row = 0; row < size; row++)
      for (let column = 0; column < size; column++)
        alphas[row * size + column] = alphaAt(
          column - reach + 0.5 - x,
          row - reach + 0.5 - y,
          r,
          this.ink,
        );
    return { reach, alphas };
  }
}
