// Cells of nodes while a treemap is made, each in a frame of its own: so areas of small cells deep
// down are as exact as those of large ones.
import { checkedBounds, checkNumber, taken } from "../core/arguments.js";
import { Diagram } from "../core/diagram.js";
import type { Bounds, Site } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import { voronoi } from "../shapes/functions.js";
import { isRegion } from "../shapes/region.js";
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

/** As a share of the shape's diagonal, and of the root of the smaller area along a curve. */
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
  readonly circle: Site | null;
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

interface Framed {
  readonly frame: Frame;
  readonly outline: Outline;
  readonly bounds?: Bounds;
}

/** A shape as it was when it was set, and the bounds that it was. */
export interface Shape extends Pick<Framed, "bounds"> {
  /** The cell of the root. */
  readonly cell: Cell;
  /** The tolerance of polygons and drawings, in all of the shape. */
  readonly tolerance: number;
}

export function shapeOf(shape: TreemapShape): Shape {
  const framed = isDisc(shape)
    ? discOf(shape)
    : isRegion(shape)
      ? regionOf(shape)
      : boundsOf(shape);
  const { frame, outline } = framed;
  const corners = polygonOf(outline, () => 1);
  const { xmin, ymin, xmax, ymax } = boxOf(corners);
  const diagonal = Math.sqrt((xmax - xmin) ** 2 + (ymax - ymin) ** 2);
  const polygon = (factor: number) =>
    polygonOf(outline, () => factor * kToleranceOfShape * diagonal);
  const rings = polygon(1);
  const cell = { frame, outline, polygon, rings, ...momentsOf(rings), circle: null, fit: null };
  return { ...framed, cell, tolerance: kToleranceOfShape * diagonal * frame.scale };
}

function boundsOf(shape: unknown): Framed {
  const bounds = checkedBounds(shape);
  const [xmin, ymin, xmax, ymax] = bounds;
  const frame = frameOf({ xmin, ymin, xmax, ymax });
  const ring = Float64Array.of(xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax);
  return { frame, outline: outlineOf(movedInto(frame, [ring])), bounds };
}

function discOf(disc: Disc): Framed {
  for (const name of ["x", "y", "r"] as const) checkNumber(`${name} of the disc`, disc[name]);
  const { x, y, r } = { x: taken(disc.x), y: taken(disc.y), r: taken(disc.r) };
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
function regionOf(shape: Exclude<TreemapShape, Disc>): Framed {
  using diagram = new Diagram([0, 0, 0]);
  using view = voronoi(diagram, shape);
  const outline = view.cellCurves(0);
  if (outline === null) throw new ApolloniusError("bad-bounds", "the shape has no inside");
  const frame = frameOf(view);
  return { frame, outline: curvesMovedInto(frame, outline) };
}

/** The window that padding leaves of a cell, in a frame of its own. */
export function windowOf(cell: Cell, padding: number, factor: number): Window {
  const whole = factor === 1 ? cell.rings : cell.polygon(factor);
  const rings = inset(whole, padding / cell.frame.scale);
  const frame = frameOf(boxOf(rings));
  return { frame: composed(cell.frame, frame), rings: movedInto(frame, rings) };
}

/** The cell of an only child: all of the window. */
export function onlyCell(cell: Cell, { frame, rings }: Window, padding: number): Cell {
  if (!(padding > 0)) return { ...cell, circle: null, fit: null };
  const outline = outlineOf(rings);
  const polygon = () => rings;
  return { frame, outline, polygon, rings, ...momentsOf(rings), circle: null, fit: null };
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
      circle: {
        x: frame.x + frame.scale * xyr[3 * id]!,
        y: frame.y + frame.scale * xyr[3 * id + 1]!,
        r: frame.scale * xyr[3 * id + 2]!,
      },
      fit: null,
    };
  });
}
