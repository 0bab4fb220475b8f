// Small circles as they look on the screen, kept to be used again for all of about the same radius
// and place in a pixel.

const kPlaces = 4; // in each direction of a pixel
const kRadii = 8; // a pixel

/**
 * @typedef {{ fill: number, stroke: number, line: number }} Ink alphas up to 255, the rim's width
 */

/** How far a circle with its rim reaches. */
export const outerOf = (r, /** @type {Ink} */ { line }) => r + line / 2 + 0.5;

/** The alpha of a pixel whose middle is at (dx, dy) from a circle's centre. */
export function alphaAt(dx, dy, r, /** @type {Ink} */ { fill, stroke, line }) {
  const inside = r - Math.sqrt(dx * dx + dy * dy);
  const rim = line / 2 + 0.5 - Math.abs(inside);
  const alpha = fill * Math.max(0, Math.min(1, inside + 0.5));
  if (rim <= 0) return alpha;
  const onRim = Math.min(rim, line, 1) * stroke;
  return alpha + onRim - (alpha * onRim) / 255;
}

export class Stamps {
  /** @type {({ reach: number, alphas: Uint8Array } | undefined)[]} */ #known = [];

  /** @param {Ink} ink */
  constructor(ink) {
    this.ink = ink;
  }

  /** Alphas of 2 reach + 1 rows and columns around the pixel that the centre is in. */
  of(x, y, r) {
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

  #made(x, y, r) {
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
