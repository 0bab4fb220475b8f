// Writes SVG: the first picture of a page, made where the site is built, before any script. Colours
// are those of theme.css, so the picture is light or dark as the page is.
import { roundedTo } from "../shared/rounding.js";
import { escaped } from "../shared/svg.js";
import { type ThemeName, variableOf } from "../shared/theme.js";
import { type LookName, lookOf, type Pen, type TextOptions } from "./pen.js";

const kDigits = 1;
const kNumber = /-?\d*\.?\d+(e[+-]?\d+)?/g;
const number = (value: number) => String(roundedTo(value, kDigits));
const paint = (name: ThemeName) => `var(${variableOf(name)})`;

export class SvgPen implements Pen {
  readonly scale = 1;
  readonly #parts: string[] = [];
  #clips = 0;

  constructor(
    readonly name: string,
    readonly width: number,
    readonly height: number,
  ) {}

  #paint(look: LookName) {
    const { fill, stroke, width = 1, dash } = lookOf(look);
    const line = stroke ? ` stroke="${paint(stroke)}" stroke-width="${width}"` : "";
    const dashes = dash ? ` stroke-dasharray="${dash.join(" ")}"` : "";
    return `fill="${fill ? paint(fill) : "none"}" fill-rule="evenodd"${line}${dashes}`;
  }

  circle(x: number, y: number, r: number, look: LookName) {
    const [cx, cy, radius] = [x, y, Math.max(r, 0)].map(number);
    this.#parts.push(`<circle cx="${cx}" cy="${cy}" r="${radius}" ${this.#paint(look)}/>`);
  }

  path(data: string, look: LookName) {
    const short = data.replace(kNumber, (digits) => number(Number(digits)));
    this.#parts.push(`<path d="${escaped(short)}" ${this.#paint(look)}/>`);
  }

  line(x0: number, y0: number, x1: number, y1: number, look: LookName) {
    this.path(`M${number(x0)},${number(y0)}L${number(x1)},${number(y1)}`, look);
  }

  rectangle(x: number, y: number, width: number, height: number, look: LookName) {
    const right = number(x + width);
    this.path(`M${number(x)},${number(y)}H${right}V${number(y + height)}H${number(x)}Z`, look);
  }

  text(text: string, x: number, y: number, look: LookName, options: TextOptions = {}) {
    const { align = "start", size = 14, isBold = false } = options;
    const fill = lookOf(look).fill ?? "ink";
    this.#parts.push(
      `<text x="${number(x)}" y="${number(y)}" dy="0.35em" text-anchor="${align}" ` +
        `font-size="${size}" font-weight="${isBold ? 600 : 400}" fill="${paint(fill)}">` +
        `${escaped(text)}</text>`,
    );
  }

  inside(x: number, y: number, width: number, height: number, draw: () => void) {
    const clip = `${this.name}-${++this.#clips}`;
    this.#parts.push(
      `<clipPath id="${clip}">` +
        `<rect width="${number(width)}" height="${number(height)}"/></clipPath>` +
        `<g transform="translate(${number(x)} ${number(y)})"><g clip-path="url(#${clip})">`,
    );
    draw();
    this.#parts.push("</g></g>");
  }

  tone(): [number, number, number] {
    return [0, 0, 0];
  }

  pixels() {} // they are drawn when the figure has started

  /**
   * The whole picture. It has no text of its own: the figure's caption says what it shows.
   * @param kind a class: on which windows it is shown
   */
  toSvg(kind = "") {
    const box = `0 0 ${number(this.width)} ${number(this.height)}`;
    const inner = this.#parts.join("");
    return `<svg class="poster ${kind}" viewBox="${box}" aria-hidden="true">${inner}</svg>`;
  }
}
