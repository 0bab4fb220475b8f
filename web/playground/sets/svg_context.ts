// A drawing context that writes SVG: as much of the canvas's as the layers of the picture use, so
// that a file has the lines that the canvas shows.
import { contextOf } from "../picture/context.js";

const kDigits = 2; // of pixels

export const rounded = (value: number) => Number(value.toFixed(kDigits));
export const escaped = (text: string) =>
  text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

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
  #drawn: string[] = [];
  #saved: State[] = [];
  #clips = 0;
  #ruler: CanvasRenderingContext2D | null = null;

  /** For the layers, which draw on a canvas's context. It has all that they call. */
  asCanvas() {
    return this as unknown as CanvasRenderingContext2D;
  }

  /** What has been drawn since this was last asked. */
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

  /** Clockwise on the screen, as far as a whole turn. */
  arc(x: number, y: number, r: number, from: number, to: number) {
    const at = (angle: number) => [x + r * Math.cos(angle), y + r * Math.sin(angle)] as const;
    const start = at(from).map(rounded).join();
    if (this.#path.at(-1) !== `M${start}`) this.lineTo(...at(from));
    const middle = (from + to) / 2; // SVG knows no arc from a point to itself
    for (const angle of [middle, to])
      this.#path.push(`A${rounded(r)},${rounded(r)},0,0,1,${at(angle).map(rounded).join()}`);
  }

  stroke() {
    const { lineWidth, lineCap, lineJoin, dash, globalAlpha } = this;
    this.#draw({
      fill: "none",
      stroke: this.strokeStyle,
      "stroke-width": lineWidth,
      "stroke-linecap": lineCap === "butt" ? undefined : lineCap,
      "stroke-linejoin": lineJoin === "miter" ? undefined : lineJoin,
      "stroke-dasharray": dash.length > 0 ? dash.join(" ") : undefined,
      opacity: globalAlpha < 1 ? globalAlpha : undefined,
    });
  }

  fill() {
    this.#draw({
      fill: this.fillStyle,
      opacity: this.globalAlpha < 1 ? this.globalAlpha : undefined,
    });
  }

  /** Limits what is drawn until `restore` to the path. */
  clip() {
    const outer = this.clipId;
    this.clipId = `apollonius-${++this.#clips}`;
    const both = { id: this.clipId, "clip-path": outer ? `url(#${outer})` : undefined };
    this.#drawn.push(`<clipPath${attributes(both)}><path d="${this.#path.join("")}"/></clipPath>`);
  }

  measureText(text: string) {
    this.#ruler ??= contextOf(document.createElement("canvas"));
    this.#ruler.font = this.font;
    return this.#ruler.measureText(text);
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

  #draw(look: Look) {
    if (this.#path.length === 0) return;
    const clip = this.clipId ? `url(#${this.clipId})` : undefined;
    const all = { d: this.#path.join(""), ...look, "clip-path": clip };
    this.#drawn.push(`<path${attributes(all)}/>`);
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
