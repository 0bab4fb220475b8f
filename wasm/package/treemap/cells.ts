// Cells of nodes while a treemap is made, each in a frame of its own: so areas of small cells deep
// down are as exact as those of large ones.
import { numberError } from "../core/arguments.js";
import { Diagram } from "../core/diagram.js";
import type { Site } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { voronoi } from "../shapes/functions.js";
import { Voronoi } from "../shapes/voronoi.js";
import { inset } from "./inset.js";
import { circle, type Outline, outlineOf, polygonOf, type Rings } from "./outline.js";
import {
  boxOf,
  composed,
  curvesMovedInto,
  type Frame,
  frameOf,
  momentsOf,
  movedInto,
} from "./rings.js";
import type { Disc, TreemapFit, TreemapShape } from "./types.js";

/** Of the shape's diagonal, and of the root of the smaller area along a curve. */
const kToleranceOfShape = 2 ** -13;
const kToleranceOfCell = 2 ** -9;

export interface Cell {
  readonly frame: Frame;
  /** The rest is in it. */
  readonly outline: Outline;
  /** The outline as a polygon of the same area, within tolerances that are smaller by a factor. */
  readonly polygon: (factor: number) => Rings;
  readonly rings: Rings;
  readonly area: number;
  readonly x: number;
  readonly y: number;
  /** Outside the frame, in the shape's coordinates. */
  readonly site: Site | null;
  fit: TreemapFit | null;
}

/** The window of a node's children: rings in a frame. */
export interface Window {
  readonly frame: Frame;
  readonly rings: Rings;
}

function isDisc(shape: unknown): shape is Disc {
  return typeof shape === "object" && shape !== null && "r" in shape;
}

/** The cell of the root, and the tolerance of polygons: in all of the shape. */
export function rootCell(shape: TreemapShape): { cell: Cell; tolerance: number } {
  const { frame, outline } = isDisc(shape) ? discOf(shape) : regionOf(shape);
  const corners = polygonOf(outline, () => 1);
  const { xmin, ymin, xmax, ymax } = boxOf(corners);
  const diagonal = Math.sqrt((xmax - xmin) ** 2 + (ymax - ymin) ** 2);
  const polygon = (factor: number) =>
    polygonOf(outline, () => factor * kToleranceOfShape * diagonal);
  const rings = polygon(1);
  const cell = { frame, outline, polygon, rings, ...momentsOf(rings), site: null, fit: null };
  return { cell, tolerance: kToleranceOfShape * diagonal * frame.scale };
}

function discOf({ x, y, r }: Disc): { frame: Frame; outline: Outline } {
  for (const [name, value] of Object.entries({ x, y, r })) {
    const error = numberError(`${name} of the disc`, value);
    if (error) throw error;
  }
  if (!(r > 0)) throw new ApolloniusError("bad-bounds", `r of the disc is ${r}, expected above 0`);
  const frame = frameOf({ xmin: x - r, xmax: x + r, ymin: y - r, ymax: y + r });
  const { curves, starts } = circle();
  const size = r / frame.scale;
  return {
    frame: { ...frame, x, y },
    outline: { curves: curves.map((value, k) => (k % 7 === 4 ? value : size * value)), starts },
  };
}

/** As the library reads it: rings, each with its inside on the left. */
function regionOf(shape: Exclude<TreemapShape, Disc>): { frame: Frame; outline: Outline } {
  using diagram = new Diagram([0, 0, 0]);
  using view = voronoi(diagram, shape);
  const outline = view.cellCurves(0);
  if (outline === null) throw new ApolloniusError("bad-bounds", "the shape has no inside");
  const frame = frameOf(view);
  return { frame, outline: curvesMovedInto(frame, outline) };
}

/** What padding leaves of a cell, in a frame of its own. */
export function windowOf(cell: Cell, padding: number, factor: number): Window {
  const whole = factor === 1 ? cell.rings : cell.polygon(factor);
  const rings = inset(whole, padding / cell.frame.scale);
  const frame = frameOf(boxOf(rings));
  return { frame: composed(cell.frame, frame), rings: movedInto(frame, rings) };
}

/** The cell of an only child: all of the window. */
export function onlyCell(cell: Cell, { frame, rings }: Window, padding: number): Cell {
  if (!(padding > 0)) return { ...cell, site: null, fit: null };
  const outline = outlineOf(rings);
  const polygon = () => rings;
  return { frame, outline, polygon, rings, ...momentsOf(rings), site: null, fit: null };
}

/** The cells of all sites of a diagram in a window, by id; `tolerance` is of the whole shape. */
export function cellsIn(view: Voronoi, { frame }: Window, tolerance: number): Cell[] {
  const own = tolerance / frame.scale;
  const { ids, xyr } = view.diagram.sites();
  const moments = Array.from(ids, (id) => Voronoi.momentsOf(view, id));
  return moments.map((ownMoments, id): Cell => {
    const outline = view.cellCurves(id);
    if (outline === null || ownMoments.isEmpty)
      throw new ApolloniusError("no-convergence", "a cell has vanished by rounding");
    const { area, centroidX, centroidY } = ownMoments;
    const toleranceOf = (curve: number) => {
      const other = outline.neighbors[curve]!;
      const smaller = other === -1 ? area : Math.min(area, moments[other]!.area);
      return Math.min(own, kToleranceOfCell * Math.sqrt(smaller));
    };
    const polygon = (factor: number) => polygonOf(outline, (curve) => factor * toleranceOf(curve));
    return {
      frame,
      outline,
      polygon,
      rings: polygon(1),
      area,
      x: centroidX,
      y: centroidY,
      site: {
        x: frame.x + frame.scale * xyr[3 * id]!,
        y: frame.y + frame.scale * xyr[3 * id + 1]!,
        r: frame.scale * xyr[3 * id + 2]!,
      },
      fit: null,
    };
  });
}
