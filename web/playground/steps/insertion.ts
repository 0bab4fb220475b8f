// One insertion in the steps of the paper (sections 3 and 4), told by what the package's calls say:
// the walk to the nearest site, the first vertex in conflict, the region that is lost, the hole and
// the new star. Every step draws over the picture.
import type { Point } from "../app.js";
import type { Circle, Sites } from "../model/sites.js";
import { addCell, windowOf } from "../picture/curves.js";
import { addRim, fillAndStroke } from "../picture/discs.js";
import type { Picture } from "../picture/painter.js";
import { strokePartial } from "../picture/partial.js";
import type { View } from "../picture/view.js";
import { drawHole } from "./hole.js";
import { askedByInsertion, type Questions, stepOfQuestions } from "./questions.js";
import { descent, type Stage, walk } from "./walk.js";

/** A vertex of the diagram, its empty circle, and the lost ones that edges join it to. */
type Vertex = Circle & { id: number; lost: number[] };

export type Step = {
  title: string;
  text: string;
  questions?: Questions;
  draw: (context: CanvasRenderingContext2D, picture: Picture) => void;
};

const kMostSingly = 8; // vertices of the region that get a step each

/** The vertices that the new circle takes, in the order in which they are found. */
function conflictRegion(sites: Sites, circle: Circle, nearest: number): Vertex[] {
  const { coordinates, clearance, sites: corners } = sites.diagram.vertices();
  const { vertices } = sites.diagram.edges();
  const r = circle.r * sites.weight;
  const isTaken = (v: number) =>
    Math.hypot(coordinates[2 * v] - circle.x, coordinates[2 * v + 1] - circle.y) - r < clearance[v];
  const beside = new Map<number, number[]>();
  for (let k = 0; k < vertices.length; k += 2) {
    const [a, b] = [vertices[k], vertices[k + 1]];
    if (a < 0 || b < 0) continue;
    beside.set(a, [...(beside.get(a) ?? []), b]);
    beside.set(b, [...(beside.get(b) ?? []), a]);
  }
  const all = clearance.length;
  const isCorner = (v: number) => corners.subarray(3 * v, 3 * v + 3).includes(nearest);
  let first = -1;
  for (let v = 0; v < all && first < 0; v++) if (isCorner(v) && isTaken(v)) first = v;
  const found = new Set(first < 0 ? [] : [first]);
  for (const v of found) for (const w of beside.get(v) ?? []) if (isTaken(w)) found.add(w);
  return Array.from(
    found,
    (v): Vertex => ({
      id: v,
      x: coordinates[2 * v],
      y: coordinates[2 * v + 1],
      r: clearance[v],
      lost: (beside.get(v) ?? []).filter((w) => found.has(w)),
    }),
  );
}

function drawCircle(
  context: CanvasRenderingContext2D,
  view: View,
  { x, y, r }: Circle,
  stroke: string,
  fill = "",
) {
  const [px, py, reach] = [view.toScreenX(x), view.toScreenY(y), Math.max(r * view.scale, 2)];
  context.strokeStyle = stroke;
  context.lineWidth = 2;
  if (fill) {
    context.fillStyle = fill;
    return fillAndStroke(context, view, px, py, reach);
  }
  context.beginPath();
  addRim(context, view, px, py, reach);
  context.stroke();
}

function drawDot(context: CanvasRenderingContext2D, view: View, point: Point, color: string) {
  context.beginPath();
  context.arc(...screenOf(view, point), 5, 0, 2 * Math.PI);
  context.fillStyle = color;
  context.fill();
}

const screenOf = (view: View, { x, y }: Point): [number, number] => [
  view.toScreenX(x),
  view.toScreenY(y),
];

function drawNew(
  context: CanvasRenderingContext2D,
  { view, theme, sites }: Picture,
  circle: Circle,
) {
  const counted = { ...circle, r: circle.r * sites.weight };
  drawCircle(context, view, counted, theme.selected, theme.selectedFill);
}

/** @param circle the new one @param start of the walk */
export function insertionSteps(sites: Sites, circle: Circle, start: number): Step[] {
  const path = walk(sites.diagram, circle, start);
  const stages = descent(sites, circle);
  const nearest = path[path.length - 1];
  const name = (id: number) => sites.label(id).name;
  const steps: Step[] = [
    {
      title: "A new circle",
      text: "Which part of the plane will be nearer to it than to all others?",
      draw: (context: CanvasRenderingContext2D, picture: Picture) =>
        drawNew(context, picture, circle),
    },
    {
      title: "The walk",
      text:
        `From ${name(start)} to a nearer neighbour, again and again: ${path.length - 1} steps. ` +
        `${name(nearest)} has none, so it is the nearest.` +
        (stages.length > 0 ? "" : " (With more circles, smaller diagrams shorten the walk.)"),
      draw(context: CanvasRenderingContext2D, picture: Picture) {
        drawNew(context, picture, circle);
        drawWalk(context, picture, path);
      },
    },
    ...stages.map((stage) => stepDown(stage, sites, circle, path.length - 1)),
  ];
  const asked = askedByInsertion(sites, circle);
  const site = sites.site(nearest);
  const gap = Math.hypot(site.x - circle.x, site.y - circle.y) - sites.radius(nearest);
  if (gap <= -circle.r * sites.weight)
    return [
      ...steps,
      {
        title: "Hidden",
        text: `It lies inside ${name(nearest)}, so it is nowhere the nearest: no cell.`,
        draw: (context: CanvasRenderingContext2D, picture: Picture) =>
          drawNew(context, picture, circle),
      },
      stepOfQuestions(asked, (context, picture) => drawNew(context, picture, circle)),
    ];

  const region = conflictRegion(sites, circle, nearest);
  const single = region.length <= kMostSingly ? region.map((_, k) => k + 1) : [1, region.length];
  for (const count of single)
    steps.push({
      title: count === 1 ? "The first conflict" : "The region, edge by edge",
      text:
        count === 1
          ? "A vertex’s circle touches three sites and holds none. The new circle reaches into " +
            "this one, so the vertex has to go."
          : `From vertex to vertex along the edges between them: ${count} are in conflict.`,
      draw(context: CanvasRenderingContext2D, picture: Picture) {
        drawRegion(context, picture, region.slice(0, count), count === 1);
        drawNew(context, picture, circle);
      },
    });
  if (region.length === 0)
    steps.push({
      title: "No vertex in conflict",
      text: "The new cell lies along one edge, or far outside: no vertex is lost.",
      draw: (context: CanvasRenderingContext2D, picture: Picture) =>
        drawNew(context, picture, circle),
    });
  const drawFilled = (context: CanvasRenderingContext2D, picture: Picture) => {
    drawCellToBe(context, picture, circle);
    drawStar(context, picture, circle);
    drawNew(context, picture, circle);
  };
  steps.push(
    {
      title: "The hole",
      text: "What is between these vertices is removed: the edges that remain end in the open.",
      draw(context: CanvasRenderingContext2D, picture: Picture) {
        drawCellToBe(context, picture, circle);
        drawNew(context, picture, circle);
      },
    },
    {
      title: "The star",
      text: "The new site is joined to the sites around the hole, and has its cell.",
      draw: drawFilled,
    },
    stepOfQuestions(asked, drawFilled),
  );
  return steps;
}

/** The walk on one level of the hierarchy; `most` is how long it is without levels. */
function stepDown({ level, ids, path }: Stage, sites: Sites, circle: Circle, most: number): Step {
  const steps = path.length - 1;
  const long = steps === 1 ? "one step" : `${steps} steps`;
  return {
    title: level > 0 ? `Level ${level} of the hierarchy` : "Level 0, the diagram itself",
    text:
      level > 0
        ? `The same among ${ids.length} of the circles, which have a diagram of their own: ${long}.`
        : `From where the walk above ended: ${long} instead of ${most}.`,
    draw(context: CanvasRenderingContext2D, picture: Picture) {
      const { view, theme } = picture;
      drawNew(context, picture, circle);
      if (level > 0) {
        context.strokeStyle = theme.level;
        context.lineWidth = 2;
        strokePartial(context, picture, windowOf(view), ids);
        for (const id of Array.from(ids)) drawDot(context, view, sites.site(id), theme.level);
      }
      drawWalk(context, picture, path);
    },
  };
}

function drawWalk(
  context: CanvasRenderingContext2D,
  { sites, view, theme }: Picture,
  path: number[],
) {
  context.strokeStyle = theme.vertex;
  context.lineWidth = 3;
  context.beginPath();
  for (const id of path) context.lineTo(...screenOf(view, sites.site(id)));
  context.stroke();
  for (const id of path.slice(0, -1)) drawDot(context, view, sites.site(id), theme.vertex);
  const last = path[path.length - 1];
  drawCircle(context, view, { ...sites.site(last), r: sites.radius(last) }, theme.accent);
}

function drawRegion(
  context: CanvasRenderingContext2D,
  { view, theme }: Picture,
  region: Vertex[],
  isWithCircle: boolean,
) {
  const known = new Map(region.map((vertex) => [vertex.id, vertex]));
  context.strokeStyle = theme.vertex;
  context.lineWidth = 4;
  context.beginPath();
  for (const vertex of region) {
    for (const other of vertex.lost) {
      const end = known.get(other);
      if (!end || other < vertex.id) continue;
      context.moveTo(...screenOf(view, vertex));
      context.lineTo(...screenOf(view, end));
    }
  }
  context.stroke();
  for (const vertex of region) drawDot(context, view, vertex, theme.vertex);
  if (isWithCircle || region.length > 1)
    drawCircle(context, view, region[region.length - 1], theme.vertex, theme.emptyFill);
}

/** The cell to be, empty. */
function drawCellToBe(context: CanvasRenderingContext2D, picture: Picture, circle: Circle) {
  const { sites, view } = picture;
  drawHole(context, picture, () => sites.tryOut(circle, (id) => addCell(context, sites, view, id)));
}

/** The dual edges of the new site, as straight lines. */
function drawStar(
  context: CanvasRenderingContext2D,
  { sites, view, theme }: Picture,
  circle: Circle,
) {
  const around = sites.tryOut(circle, (id) => [...sites.diagram.neighbors(id)]);
  context.strokeStyle = theme.dual;
  context.lineWidth = 2;
  context.beginPath();
  for (const id of around) {
    context.moveTo(...screenOf(view, circle));
    context.lineTo(...screenOf(view, sites.site(id)));
  }
  context.stroke();
  for (const id of around) drawDot(context, view, sites.site(id), theme.dual);
}
