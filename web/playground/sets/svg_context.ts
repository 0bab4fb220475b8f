// A drawing context that writes SVG: as much of the canvas's as the layers of the picture use, so
// that a file has what the canvas shows. Circles are circles, so that they can be edited.
import { contextOf } from "../../shared/canvas.js";
import { roundedTo } from "../../shared/rounding.js";
import { escaped } from "../../shared/svg.js";

const kDigits = 2; // of pixels

export const rounded = (value: number) => roundedTo(value, kDigits);

const kAnchors: Partial<Record<CanvasTextAlign, string>> = { center: "middle", right: "end" };

type State = {
  strokeStyle: string;
  fillStyle: string;
  lineWidth: number;
  lineCap: CanvasLineCap;
  lineJoin: CanvasLineJoin;
  globalAlpha: number;
  font: string;
  textAlign: CanvasTextAlign;
  textBaseline: CanvasTextBaseline;
  dash: number[];
  clipId: string; // the id of what limits the drawing
};

export class SvgContext implements State {
  strokeStyle = "#000";
  fillStyle = "#000";
  lineWidth = 1;
  lineCap: CanvasLineCap = "butt";
  lineJoin: CanvasLineJoin = "miter";
  globalAlpha = 1;
  font = "10px sans-serif";
  textAlign: CanvasTextAlign = "start";
  textBaseline: CanvasTextBaseline = "alphabetic";
  dash: number[] = [];
  clipId = "";

  #path: string[] = [];
  #circles: string[] = []; // which the path has, too
  #drawn: string[] = [];
  #saved: State[] = [];
  #clips = 0;
  #ruler: CanvasRenderingContext2D | null = null;

  /** For the layers, which draw on a canvas's context. It has all that they call. */
  asCanvas() {
    return this as unknown as CanvasRenderingContext2D;
  }

  /** Returns what has been drawn since the last call. */
  take() {
    const drawn = this.#drawn.join("");
    this.#drawn = [];
    return drawn;
  }

  // --- As of a canvas ----------------------------------------------------------------------------

  save() {
    const { strokeStyle, fillStyle, lineWidth, lineCap, lineJoin, globalAlpha } = this;
    const { font, textAlign, textBaseline, dash, clipId } = this;
    const lines = { strokeStyle, fillStyle, lineWidth, lineCap, lineJoin, globalAlpha };
    this.#saved.push({ ...lines, font, textAlign, textBaseline, dash, clipId });
  }

  restore() {
    Object.assign(this, this.#saved.pop());
  }

  setLineDash(dash: number[]) {
    this.dash = dash;
  }

  beginPath() {
    this.#path = [];
    this.#circles = [];
  }

  moveTo(x: number, y: number) {
    this.#add("M", x, y);
  }

  lineTo(x: number, y: number) {
    this.#add(this.#path.length > 0 ? "L" : "M", x, y);
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number) {
    this.#add("C", x1, y1, x2, y2, x, y);
  }

  closePath() {
    this.#path.push("Z");
  }

  rect(x: number, y: number, width: number, height: number) {
    const [right, bottom] = [rounded(x + width), rounded(y + height)];
    this.#path.push(`M${rounded(x)},${rounded(y)}H${right}V${bottom}H${rounded(x)}Z`);
  }

  /**
   * A whole circle, which is all that layers draw by it; they have moved to its beginning. No arcs:
   * where numbers are rounded two halves of a circle would not meet its place by up to a pixel.
   */
  arc(x: number, y: number, r: number) {
    this.#path.pop();
    const [cx, cy] = [rounded(x), rounded(y)];
    this.#circles.push(`<circle${attributes({ cx, cy, r: rounded(r) })}/>`);
  }

  stroke() {
    const { lineWidth, lineCap, lineJoin, dash } = this;
    this.#draw(this.strokeStyle, (color) => ({
      fill: "none",
      stroke: color,
      "stroke-width": lineWidth,
      "stroke-linecap": lineCap === "butt" ? undefined : lineCap,
      "stroke-linejoin": lineJoin === "miter" ? undefined : lineJoin,
      "stroke-dasharray": dash.length > 0 ? dash.join(" ") : undefined,
    }));
  }

  fill() {
    this.#draw(this.fillStyle, (color) => ({ fill: color }));
  }

  /** Limits what is drawn until `restore` to the path. */
  clip() {
    const outer = this.clipId;
    this.clipId = `apollonius-${++this.#clips}`;
    const both = { id: this.clipId, "clip-path": outer ? `url(#${outer})` : undefined };
    this.#drawn.push(`<clipPath${attributes(both)}><path d="${this.#path.join("")}"/></clipPath>`);
  }

  measureText(text: string) {
    const canvas = this.#canvas;
    canvas.font = this.font;
    return canvas.measureText(text);
  }

  fillText(text: string, x: number, y: number) {
    const look = {
      x: rounded(x),
      y: rounded(y),
      dy: this.textBaseline === "middle" ? "0.35em" : undefined,
      "text-anchor": kAnchors[this.textAlign],
      ...fontOf(this.font),
      fill: this.fillStyle,
    };
    this.#drawn.push(`<text${attributes(look)}>${escaped(text)}</text>`);
  }

  #add(letter: string, ...numbers: number[]) {
    this.#path.push(letter + numbers.map(rounded).join());
  }

  #draw(style: string, lookOf: (color: string) => Look) {
    const [color, alpha] = this.#colorOf(style);
    const opacity = alpha * this.globalAlpha;
    const path = this.#path.length > 0 ? [`<path${attributes({ d: this.#path.join("") })}/>`] : [];
    const shapes = [...path, ...this.#circles];
    if (shapes.length === 0 || opacity === 0) return;
    const look = attributes({
      ...lookOf(color),
      opacity: opacity < 1 ? opacity : undefined, // of all: overlaps are not darker, as on a canvas
      "clip-path": this.clipId ? `url(#${this.clipId})` : undefined,
    });
    this.#drawn.push(
      shapes.length > 1
        ? `<g${look}>${shapes.join("")}</g>`
        : shapes[0].replace("/>", () => `${look}/>`),
    );
  }

  /** As every program reads it: without alpha, which is apart. */
  #colorOf(style: string): [color: string, alpha: number] {
    this.#canvas.fillStyle = style;
    const color = String(this.#canvas.fillStyle);
    const [, rgb, alpha] = color.match(/^rgba\((.*), ([\d.]+)\)$/) ?? [];
    return rgb === undefined ? [color, 1] : [`rgb(${rgb})`, Number(alpha)];
  }

  get #canvas() {
    this.#ruler ??= contextOf(document.createElement("canvas"));
    return this.#ruler;
  }
}

/** "500 11px sans-serif" as attributes: a style would need leave where there is a policy. */
function fontOf(font: string): Look {
  const [, weight, size, family] = font.match(/^(?:(\w+) )?([\d.]+)px (.*)$/) ?? [];
  return { "font-weight": weight, "font-size": size, "font-family": family };
}

type Look = Record<string, string | number | undefined>;

const attributes = (look: Look) =>
  Object.entries(look)
    .filter(([, value]) => value !== undefined)
    .map(([name, value]) => ` ${name}="${escaped(String(value))}"`)
    .join("");
