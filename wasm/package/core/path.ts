// Drawing: plays commands from the library into any context, or writes them as an SVG path.
import { ApolloniusError } from "../errors.js";
import { checkOptions, described } from "./arguments.js";

/**
 * The target of drawing: a canvas context, a Path2D, a d3-path, or anything else with these four
 * methods.
 */
export interface PathContext {
  /** Starts a new piece. */
  moveTo(x: number, y: number): void;
  /** Adds a segment. */
  lineTo(x: number, y: number): void;
  /** Adds a cubic Bezier curve. */
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void;
  /** Closes the piece. */
  closePath(): void;
}

/** How to draw. */
export interface DrawOptions {
  /**
   * Largest distance between a drawn curve and the true one, in the diagram's unit, > 0. Default:
   * 2^-13 of the window's diagonal (a sixth of a pixel if the diagonal is 1300 pixels), but at most
   * a small share of a cell or curve, so that small ones keep their shapes.
   */
  tolerance?: number | undefined;
  /** Decimal places of the numbers in a path string, 0 to 15. Default: all. */
  digits?: number | undefined;
}

// `Command` of src/apollonius/path.h.
const kMove = 0;
const kLine = 1;
const kCurve = 2;

/**
 * Plays the commands with indices from `from` to before `to` into the context. Their coordinates
 * begin at element `k` of `xy`. Returns where they end.
 */
export function play(
  context: PathContext,
  commands: Uint8Array,
  xy: Float64Array,
  k: number = 0,
  from: number = 0,
  to: number = commands.length,
): number {
  for (let i = from; i < to; ++i) {
    const command = commands[i];
    if (command === kMove) {
      context.moveTo(xy[k] as number, xy[k + 1] as number);
      k += 2;
    } else if (command === kLine) {
      context.lineTo(xy[k] as number, xy[k + 1] as number);
      k += 2;
    } else if (command === kCurve) {
      context.bezierCurveTo(
        xy[k] as number,
        xy[k + 1] as number,
        xy[k + 2] as number,
        xy[k + 3] as number,
        xy[k + 4] as number,
        xy[k + 5] as number,
      );
      k += 6;
    } else {
      context.closePath();
    }
  }
  return k;
}

/** Throws "out-of-range" unless it is undefined or an integer from 0 to 15. */
export function checkedDigits(digits: number | undefined): number | undefined {
  if (digits === undefined || (Number.isInteger(digits) && digits >= 0 && digits <= 15))
    return digits;
  throw new ApolloniusError(
    "out-of-range",
    `digits is ${String(digits)}, expected an integer from 0 to 15`,
  );
}

/** A context that writes SVG path data. */
export class PathString implements PathContext {
  #text = "";
  readonly #scale: number | undefined;

  /** Throws as checkedDigits. */
  constructor(digits: number | undefined) {
    const places = checkedDigits(digits);
    this.#scale = places === undefined ? undefined : 10 ** places;
  }

  moveTo(x: number, y: number): void {
    this.#text += `M${this.#number(x)},${this.#number(y)}`;
  }
  lineTo(x: number, y: number): void {
    this.#text += `L${this.#number(x)},${this.#number(y)}`;
  }
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.#text += `C${[x1, y1, x2, y2, x, y].map((value) => this.#number(value)).join(",")}`;
  }
  closePath(): void {
    this.#text += "Z";
  }
  toString(): string {
    return this.#text;
  }

  #number(x: number): number {
    if (this.#scale === undefined) return x;
    const rounded = Math.round(x * this.#scale) / this.#scale;
    return Number.isFinite(rounded) ? rounded : x; // numbers that large have no decimal places
  }
}

/** Returns the context if it can be drawn into; throws "bad-option". */
export function checkedContext<Context extends PathContext>(context: Context): Context {
  for (const name of ["moveTo", "lineTo", "bezierCurveTo", "closePath"] as const)
    if (typeof context?.[name] !== "function")
      throw new ApolloniusError(
        "bad-option",
        `context is ${described(context)} without ${name}(): options go behind it, as in ` +
          "render(null, { digits: 2 })",
      );
  return context;
}

/** Draws into the context if there is one, else returns the path as a string. */
export function drawn(
  context: PathContext | null | undefined,
  options: DrawOptions | undefined,
  draw: (context: PathContext) => void,
): string | void {
  checkOptions(options, "tolerance", "digits");
  if (context !== null && context !== undefined) return draw(checkedContext(context));
  const text = new PathString(options?.digits);
  draw(text);
  return text.toString();
}
