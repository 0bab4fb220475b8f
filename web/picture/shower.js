// Very many circles, point by point into an image: a canvas takes too long for each path. Costs
// what the area of the circles is, a few nanoseconds a pixel.

/** @typedef {import("./view.js").Box} Box */

/** "rgb(31, 86, 115)" or "#1f5673", as bytes in the order of an image's words. */
function wordOf(color) {
  const context = new OffscreenCanvas(1, 1).getContext("2d");
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b, a] = context.getImageData(0, 0, 1, 1).data;
  return { word: (b << 16) | (g << 8) | r, alpha: a / 255 };
}

export class Shower {
  #width;
  #image;
  #words;
  #bytes;
  /** @type {Box} */ #box;

  /** @param {number} width @param {number} height in device pixels */
  constructor(width, height) {
    this.#width = width;
    this.#image = new ImageData(width, height);
    this.#words = new Uint32Array(this.#image.data.buffer);
    this.#bytes = this.#image.data;
    this.#box = { left: 0, top: 0, right: width, bottom: height };
  }

  /** Empties a box; what is added then is cut to it. @param {Box} box in whole device pixels */
  start(box) {
    this.#box = box;
    const { left, top, right, bottom } = box;
    for (let row = top; row < bottom; row++)
      this.#words.fill(0, row * this.#width + left, row * this.#width + right);
  }

  /** Puts the box onto a canvas. @param {CanvasRenderingContext2D} context */
  show(context) {
    const { left, top, right, bottom } = this.#box;
    context.putImageData(this.#image, 0, 0, left, top, right - left, bottom - top);
  }

  /**
   * Adds circles.
   * @param {Float32Array} xyr in device pixels @param {number} length of the part that counts
   * @param {{ fill: string, stroke: string }} style
   * @param {number} line width of the rim
   */
  add(xyr, length, style, line) {
    const stroke = wordOf(style.stroke);
    const fill = wordOf(style.fill).alpha * 255;
    for (let k = 0; k < length; k += 3) {
      const r = xyr[k + 2];
      if (r < 0.75 * line) this.#dot(xyr[k], xyr[k + 1], r, stroke, line);
      else this.#disc(xyr[k], xyr[k + 1], r, stroke, fill, line / 2);
    }
  }

  /** A circle of about a pixel or less: its weight on one pixel, at least visible. */
  #dot(x, y, r, stroke, line) {
    const column = Math.floor(x);
    const row = Math.floor(y);
    const { left, top, right, bottom } = this.#box;
    if (column < left || row < top || column >= right || row >= bottom) return;
    const alpha = stroke.alpha * Math.min(1, 0.3 + r / line) * 255;
    this.#blend(row * this.#width + column, stroke.word, alpha);
  }

  #disc(x, y, r, stroke, fill, half) {
    const outer = r + half + 0.5;
    const box = this.#box;
    const top = Math.max(box.top, Math.floor(y - outer));
    const bottom = Math.min(box.bottom - 1, Math.floor(y + outer));
    for (let row = top; row <= bottom; row++) {
      const dy = row + 0.5 - y;
      const square = outer * outer - dy * dy;
      if (square <= 0) continue;
      const reach = Math.sqrt(square);
      const left = Math.max(box.left, Math.floor(x - reach));
      const right = Math.min(box.right - 1, Math.floor(x + reach));
      for (let column = left; column <= right; column++) {
        const dx = column + 0.5 - x;
        const inside = r - Math.sqrt(dx * dx + dy * dy);
        const rim = half + 0.5 - Math.abs(inside);
        let alpha = inside > 0.5 ? fill : inside > -0.5 ? fill * (inside + 0.5) : 0;
        if (rim > 0) {
          const line = Math.min(rim, 2 * half, 1) * stroke.alpha * 255;
          alpha += line - (alpha * line) / 255;
        }
        if (alpha >= 1) this.#blend(row * this.#width + column, stroke.word, alpha);
      }
    }
  }

  /** The colour of what is on top, and the cover of both. */
  #blend(at, word, alpha) {
    const below = this.#bytes[4 * at + 3];
    const cover = below + alpha - (below * alpha) / 255;
    this.#words[at] = ((cover & 255) << 24) | word;
  }
}
