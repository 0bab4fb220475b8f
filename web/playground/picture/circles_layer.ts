// The circles, visible and hidden, and names in them. Few are drawn as paths, many point by point.
// A circle of negative radius is a cross at its centre.
import type { Sites } from "../model/sites.js";
import { boundsOf } from "./curves.js";
import { addDisc, addRim } from "./discs.js";
import type { Layers, Picture } from "./picture.js";
import { Shower } from "./shower.js";
import type { Theme } from "../../shared/theme.js";
import type { Box, View } from "./view.js";

const kDot = 1.1; // pixels: smaller circles are drawn as dots of this size
const kDashFrom = 5; // hidden circles at least this large (pixels) are dashed
const kNameFrom = 15; // and visible ones may show their names
const kThinBelow = 6; // pixels: smaller circles have thin rims
const kThinLine = 0.8;
const kLine = 1.25;
const kCross = 3; // pixels from a cross's middle to its ends
const kMostPaths = 1500;
const kManySites = 30_000; // from here on the diagram is asked for those in the window
const kLargestPoints = 24; // device pixels: larger circles are paths anyway

/** x, y, r in device pixels or CSS pixels, in an array that grows and is used again. */
class Triples {
  xyr = new Float64Array(3 * 1024);
  length = 0;

  clear() {
    this.length = 0;
  }

  push(x: number, y: number, r: number) {
    if (this.length + 3 > this.xyr.length) {
      const larger = new Float64Array(2 * this.xyr.length);
      larger.set(this.xyr);
      this.xyr = larger;
    }
    this.xyr[this.length++] = x;
    this.xyr[this.length++] = y;
    this.xyr[this.length++] = r;
  }

  get size() {
    return this.length / 3;
  }
}

export class CirclesLayer {
  #visible = new Triples();
  #hidden = new Triples();
  #negative = new Triples();
  #large = new Triples();
  #widths = new Map<string, number>(); // of names, in pixels
  #shower: Shower | null = null;
  #size = "";

  #isMany = false;
  #countedScale = 1;
  #countedFor: Sites | null = null;

  /** How many circles of each kind the window met when all of it was drawn last. */
  counts = { visible: 0, hidden: 0 };

  /**
   * @param context with CSS pixels as its unit, empty in the box
   * @param box the window, or in whole device pixels a part of it
   * @param isWhole whether it is the window
   */
  draw(context: CanvasRenderingContext2D, picture: Picture, box: Box, isWhole: boolean) {
    const { sites, view, layers, theme, pixelRatio } = picture;
    this.#collect(sites, view, box);
    const size = this.#visible.size + this.#negative.size;
    if (isWhole) {
      this.counts = { visible: size, hidden: this.#hidden.size };
      this.#countedScale = view.scale;
      this.#isMany = size + this.#hidden.size > kMostPaths;
    }
    if (this.#isMany) {
      this.#drawMany(context, view, layers, theme, pixelRatio, box);
      return;
    }
    for (const _ of this.#drawParts(context, picture, box));
  }

  /** Draws all as paths, however many there are, part by part. */
  *drawParts(context: CanvasRenderingContext2D, picture: Picture, box: Box) {
    this.#collect(picture.sites, picture.view, box);
    this.#isMany = this.#visible.size + this.#hidden.size > kMostPaths;
    yield* this.#drawParts(context, picture, box);
  }

  *#drawParts(
    context: CanvasRenderingContext2D,
    { sites, view, layers, theme }: Picture,
    box: Box,
  ): Generator<"circles" | "hidden" | "names"> {
    if (layers.circles) {
      drawPaths(context, view, this.#visible, theme);
      drawCrosses(context, this.#negative, theme);
      yield "circles";
    }
    if (layers.hidden) {
      drawHidden(context, view, this.#hidden, theme);
      yield "hidden";
    }
    if (layers.circles && !this.#isMany) {
      this.#drawNames(context, sites, view, box, theme);
      yield "names";
    }
  }

  /** Collects the circles that the window meets. */
  #collect(sites: Sites, view: View, box: Box) {
    const { xyr } = sites;
    const ids = this.#candidates(sites, view, box);
    const isHiding = sites.diagram.hiddenSize > 0;
    this.#visible.clear();
    this.#hidden.clear();
    this.#negative.clear();
    for (let k = 0; k < ids.length; k++) {
      const id = ids[k];
      const x = view.toScreenX(xyr[3 * id]);
      const y = view.toScreenY(xyr[3 * id + 1]);
      const r = Math.max(xyr[3 * id + 2] * view.scale, 0);
      const reach = r + kCross + 1;
      if (x + reach < box.left || x - reach > box.right) continue;
      if (y + reach < box.top || y - reach > box.bottom) continue;
      const isHidden = isHiding && sites.isHidden(id);
      if (xyr[3 * id + 2] < 0 && !isHidden) this.#negative.push(x, y, r);
      else (isHidden ? this.#hidden : this.#visible).push(x, y, r);
    }
  }

  /**
   * The ids to look at: all, or where the box meets few of very many circles, as far as that can be
   * foretold, those that the diagram finds there.
   */
  #candidates(sites: Sites, view: View, box: Box) {
    const { visible, hidden } = this.counts;
    const zoom = (this.#countedScale / view.scale) ** 2;
    const share = ((box.right - box.left) * (box.bottom - box.top)) / (view.width * view.height);
    const expected = (visible + hidden) * zoom * share;
    const isUnknown = this.#countedFor !== sites;
    this.#countedFor = sites;
    if (isUnknown || sites.size < kManySites || expected > sites.size / 100) return sites.ids;
    const bounds = boundsOf(view, box, 3);
    return bounds ? sites.diagram.search(...bounds) : sites.ids;
  }

  #drawMany(
    context: CanvasRenderingContext2D,
    view: View,
    layers: Layers,
    theme: Theme,
    ratio: number,
    box: Box,
  ) {
    const { width, height } = context.canvas;
    if (this.#size !== `${width} ${height}`) this.#shower = null;
    this.#size = `${width} ${height}`;
    this.#shower ??= new Shower(width, height);
    const shower = this.#shower;
    shower.start({
      left: Math.max(0, Math.round(box.left * ratio)),
      top: Math.max(0, Math.round(box.top * ratio)),
      right: Math.min(width, Math.round(box.right * ratio)),
      bottom: Math.min(height, Math.round(box.bottom * ratio)),
    });
    this.#large.clear();
    if (layers.circles)
      for (const triples of [this.#visible, this.#negative])
        this.#shed(shower, triples, theme.siteFill, theme.site, ratio);
    if (layers.hidden) this.#shed(shower, this.#hidden, theme.hiddenFill, theme.hidden, ratio);
    shower.show(context);
    if (layers.circles) drawPaths(context, view, this.#large, theme);
  }

  /** The small ones of these; the large ones go elsewhere. */
  #shed(shower: Shower, triples: Triples, fill: string, stroke: string, ratio: number) {
    const { xyr } = triples;
    let length = 0;
    for (let k = 0; k < triples.length; k += 3) {
      const r = xyr[k + 2] * ratio;
      if (r > kLargestPoints) {
        this.#large.push(xyr[k], xyr[k + 1], xyr[k + 2]);
        continue;
      }
      xyr[length++] = xyr[k] * ratio;
      xyr[length++] = xyr[k + 1] * ratio;
      xyr[length++] = r;
    }
    shower.add(xyr, length, { fill, stroke }, ratio);
  }

  /** Names of sites that have one, inside their circles. */
  #drawNames(context: CanvasRenderingContext2D, sites: Sites, view: View, box: Box, theme: Theme) {
    if (sites.labels.size === 0) return;
    context.font = `500 11px ${theme.sans}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = theme.name;
    for (const [id, { name }] of sites.labels) {
      const r = sites.site(id).r * view.scale;
      if (r < kNameFrom || sites.isHidden(id)) continue;
      const x = view.toScreenX(sites.xyr[3 * id]);
      const y = view.toScreenY(sites.xyr[3 * id + 1]);
      if (x + r < box.left || x - r > box.right || y + r < box.top || y - r > box.bottom) continue;
      let width = this.#widths.get(name);
      if (width === undefined) {
        width = context.measureText(name).width;
        this.#widths.set(name, width);
      }
      if (width < 2 * r - 2 && !this.#isCrowded(x, y, width / 2 + 4)) context.fillText(name, x, y);
    }
  }

  /** Whether another visible circle has its centre where the name would be. */
  #isCrowded(x: number, y: number, halfWidth: number) {
    const { xyr, length } = this.#visible;
    for (let k = 0; k < length; k += 3) {
      const dx = Math.abs(xyr[k] - x);
      if (dx > 0.01 && dx < halfWidth && Math.abs(xyr[k + 1] - y) < 9) return true;
    }
    return false;
  }
}

function drawCrosses(context: CanvasRenderingContext2D, { xyr, length }: Triples, theme: Theme) {
  context.strokeStyle = theme.site;
  context.lineWidth = kLine;
  context.beginPath();
  for (let k = 0; k < length; k += 3) {
    const [x, y] = [xyr[k], xyr[k + 1]];
    context.moveTo(x - kCross, y - kCross);
    context.lineTo(x + kCross, y + kCross);
    context.moveTo(x - kCross, y + kCross);
    context.lineTo(x + kCross, y - kCross);
  }
  context.stroke();
}

function addCircles(
  context: CanvasRenderingContext2D,
  view: View,
  { xyr, length }: Triples,
  add: typeof addRim,
) {
  context.beginPath();
  for (let k = 0; k < length; k += 3)
    add(context, view, xyr[k], xyr[k + 1], Math.max(xyr[k + 2], kDot));
}

/** Small and large ones, whose rims are drawn differently: small ones would be all rim. */
function split({ xyr, length }: Triples, size: number) {
  const small = new Triples();
  const large = new Triples();
  for (let k = 0; k < length; k += 3)
    (xyr[k + 2] < size ? small : large).push(xyr[k], xyr[k + 1], xyr[k + 2]);
  return [small, large];
}

function drawPaths(context: CanvasRenderingContext2D, view: View, triples: Triples, theme: Theme) {
  addCircles(context, view, triples, addDisc);
  context.fillStyle = theme.siteFill;
  context.fill();
  context.strokeStyle = theme.site;
  const [small, large] = split(triples, kThinBelow);
  context.lineWidth = kThinLine;
  addCircles(context, view, small, addRim);
  context.stroke();
  context.lineWidth = kLine;
  addCircles(context, view, large, addRim);
  context.stroke();
}

function drawHidden(context: CanvasRenderingContext2D, view: View, triples: Triples, theme: Theme) {
  addCircles(context, view, triples, addDisc);
  context.fillStyle = theme.hiddenFill;
  context.fill();
  context.strokeStyle = theme.hidden;
  const [small, large] = split(triples, kDashFrom);
  context.lineWidth = kThinLine;
  addCircles(context, view, small, addRim);
  context.stroke();
  context.lineWidth = kLine;
  context.setLineDash([3, 3]);
  addCircles(context, view, large, addRim);
  context.stroke();
  context.setLineDash([]);
}
