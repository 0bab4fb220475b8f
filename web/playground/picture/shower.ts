// Very many circles, point by point into an image: a canvas takes too long for each path. Costs
// what the area of the circles is, a few nanoseconds a pixel; small ones are stamped.
import { bytesOf } from "../../shared/canvas.js";
import { alphaAt, type Ink, outerOf, Stamps } from "./stamps.js";
import type { Box } from "./view.js";

/** A colour without its alpha, and that, from 0 to 1. */
type Word = { word: number; alpha: number };

const knownWords = new Map<string, Word>();

/** "rgb(31, 86, 115)" or "#1f5673", as bytes in the order of an image's words. */
function wordOf(color: string): Word {
  const known = knownWords.get(color) ?? newWordOf(color);
  knownWords.set(color, known);
  return known;
}

function newWordOf(color: string): Word {
  const [r, g, b, a] = bytesOf(color);
  return { word: (b << 16) | (g << 8) | r, alpha: a / 255 };
}

const kLargestStamp = 12; // device pixels: larger circles are not often alike

export class Shower {
  /** By style. */
  readonly #stamps = new Map<string, Stamps>();
  readonly #width: number;
  readonly #image: ImageData;
  readonly #words: Uint32Array;
  #box: Box;

  /** @param height in device pixels */
  constructor(width: number, height: number) {
    this.#width = width;
    this.#image = new ImageData(width, height);
    this.#words = new Uint32Array(this.#image.data.buffer);
    this.#box = { left: 0, top: 0, right: width, bottom: height };
  }

  /** Empties a box; what is added then is cut to it. @param box in whole device pixels */
  start(box: Box) {
    this.#box = box;
    const { left, top, right, bottom } = box;
    for (let row = top; row < bottom; row++)
      this.#words.fill(0, row * this.#width + left, row * this.#width + right);
  }

  /** Puts the box onto a canvas. */
  show(context: CanvasRenderingContext2D) {
    const { left, top, right, bottom } = this.#box;
    context.putImageData(this.#image, 0, 0, left, top, right - left, bottom - top);
  }

  /**
   * Adds circles.
   * @param xyr in device pixels
   * @param length of the part that counts
   * @param line width of the rim
   */
  add(xyr: Float64Array, length: number, style: { fill: string; stroke: string }, line: number) {
    const stroke = wordOf(style.stroke);
    const stamps = this.#stampsOf(style, line);
    for (let k = 0; k < length; k += 3) {
      const r = xyr[k + 2];
      if (r < 0.75 * line) this.#dot(xyr[k], xyr[k + 1], r, stroke, line);
      else if (r < kLargestStamp) this.#stamp(xyr[k], xyr[k + 1], r, stroke.word, stamps);
      else this.#disc(xyr[k], xyr[k + 1], r, stroke.word, stamps.ink);
    }
  }

  #stampsOf({ fill, stroke }: { fill: string; stroke: string }, line: number) {
    const key = `${fill} ${stroke} ${line}`;
    let stamps = this.#stamps.get(key);
    if (!stamps) {
      const ink = { fill: 255 * wordOf(fill).alpha, stroke: 255 * wordOf(stroke).alpha, line };
      stamps = new Stamps(ink);
      this.#stamps.set(key, stamps);
    }
    return stamps;
  }

  /** A circle of about a pixel or less: its weight on one pixel, at least visible. */
  #dot(x: number, y: number, r: number, stroke: Word, line: number) {
    const column = Math.floor(x);
    const row = Math.floor(y);
    const { left, top, right, bottom } = this.#box;
    if (column < left || row < top || column >= right || row >= bottom) return;
    const alpha = stroke.alpha * Math.min(1, 0.3 + r / line) * 255;
    this.#blend(row * this.#width + column, stroke.word, alpha);
  }

  #stamp(x: number, y: number, r: number, word: number, stamps: Stamps) {
    const { reach, alphas } = stamps.of(x, y, r);
    const { left, top, right, bottom } = this.#box;
    const column = Math.floor(x) - reach;
    const row = Math.floor(y) - reach;
    const size = 2 * reach + 1;
    const firstRow = Math.max(0, top - row);
    const lastRow = Math.min(size, bottom - row);
    const firstColumn = Math.max(0, left - column);
    const lastColumn = Math.min(size, right - column);
    const words = this.#words;
    for (let i = firstRow; i < lastRow; i++) {
      const at = (row + i) * this.#width + column;
      for (let j = firstColumn; j < lastColumn; j++) {
        const alpha = alphas[i * size + j];
        if (alpha === 0) continue;
        const below = words[at + j] >>> 24;
        words[at + j] = (coverOf(below, alpha) << 24) | word;
      }
    }
  }

  #disc(x: number, y: number, r: number, word: number, ink: Ink) {
    const outer = outerOf(r, ink);
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
        const alpha = alphaAt(column + 0.5 - x, dy, r, ink);
        if (alpha >= 1) this.#blend(row * this.#width + column, word, alpha);
      }
    }
  }

  /** The colour of what is on top, and the cover of both. */
  #blend(at: number, word: number, alpha: number) {
    const words = this.#words;
    words[at] = (coverOf(words[at] >>> 24, alpha) << 24) | word;
  }
}

const coverOf = (below: number, alpha: number) =>
  below === 0 ? alpha : below + alpha - (below * alpha) / 255;
