// One insertion in the steps of the paper (sections 3 and 4), told by what the package's calls say:
// the walk to the nearest site, the first vertex in conflict, the region that is lost, the hole and
// the new star. Every step draws over the picture.
import { addCell, windowOf } from "../picture/curves.js";
import { addDisc, addRim } from "../picture/discs.js";
import { strokePartial } from "../picture/partial.js";
import { askedByInsertion, stepOfQuestions } from "./questions.js";
import { descent, walk } from "./walk.js";

/** @typedef {import("../model/sites.js").Sites} Sites */
/** @typedef {import("../model/sites.js").Circle} Circle */
/** @typedef {import("../picture/painter.js").Picture} Picture */
/**
 * @typedef {{ title: string, text: string, questions?: import("./questions.js").Questions,
 *   draw: (context: CanvasRenderingContext2D, picture: Picture) => void }} Step
 */

const kMostSingly = 8; // vertices of the region that get a step each

/** The vertices that the new circle takes, in the order in which they are found. */
function conflictRegion(sites, circle, nearest) {
  const { coordinates, clearance, sites: corners } = sites.diagram.vertices();
  const { vertices } = sites.diagram.edges();
  const r = circle.r * sites.weight;
  const isTaken = (v) =>
    Math.hypot(coordinates[2 * v] - circle.x, coordinates[2 * v + 1] - circle.y) - r < clearance[v];
  const beside = new Map();
  for (let k = 0; k < vertices.length; k += 2) {
    const [a, b] = [vertices[k], vertices[k + 1]];
    if (a < 0 || b < 0) continue;
    beside.set(a, [...(beside.get(a) ?? []), b]);
    beside.set(b, [...(beside.get(b) ?? []), a]);
  }
  const all = clearance.length;
  const isCorner = (v) => corners.subarray(3 * v, 3 * v + 3).includes(nearest);
  let first = -1;
  for (let v = 0; v < all && first < 0; v++) if (isCorner(v) && isTaken(v)) first = v;
  const found = new Set(first < 0 ? [] : [first]);
  for (const v of found) for (const w of beside.get(v) ?? []) if (isTaken(w)) found.add(w);
  return Array.from(found, (v) => ({
    id: v,
    x: coordinates[2 * v],
    y: coordinates[2 * v + 1],
    r: clearance[v],
    lost: (beside.get(v) ?? []).filter((w) => found.has(w)),
  }));
}

function drawCircle(context, view, { x, y, r }, stroke, fill = null) {
  const [px, py, reach] = [view.toScreenX(x), view.toScreenY(y), Math.max(r * view.scale, 2)];
  context.strokeStyle = stroke;
  context.lineWidth = 2;
  if (fill) {
    context.fillStyle = fill;
    context.beginPath();
    addDisc(context, view, px, py, reach);
    context.fill();
  }
  context.beginPath();
  addRim(context, view, px, py, reach);
  context.stroke();
}

function drawDot(context, view, point, color) {
  context.beginPath();
  context.arc(...screenOf(view, point), 5, 0, 2 * Math.PI);
  context.fillStyle = color;
  context.fill();
}

/** @returns {[number, number]} */
const screenOf = (view, { x, y }) => [view.toScreenX(x), view.toScreenY(y)];

function drawNew(context, { view, theme, sites }, circle) {
  const counted = { ...circle, r: circle.r * sites.weight };
  drawCircle(context, view, counted, theme.selected, theme.selectedFill);
}

/**
 * @param {Sites} sites @param {Circle} circle the new one @param {number} start of the walk
 * @returns {Step[]}
 */
export function insertionSteps(sites, circle, start) {
  const path = walk(sites.diagram, circle, start);
  const stages = descent(sites, circle);
  const nearest = path.at(-1);
  const name = (id) => sites.label(id).name;
  /** @type {Step[]} */
  const steps = [
    {
      title: "A new circle",
      text: "Which part of the plane will be nearer to it than to all others?",
      draw: (context, picture) => drawNew(context, picture, circle),
    },
    {
      title: "The walk",
      text:
        `From ${name(start)} to a nearer neighbour, again and again: ${path.length - 1} steps. ` +
        `${name(nearest)} has none, so it is the nearest.` +
        (stages.length > 0 ? "" : " (With more circles, smaller diagrams shorten the walk.)"),
      draw(context, picture) {
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
        draw: (context, picture) => drawNew(context, picture, circle),
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
      draw(context, picture) {
        drawRegion(context, picture, region.slice(0, count), count === 1);
        drawNew(context, picture, circle);
      },
    });
  if (region.length === 0)
    steps.push({
      title: "No vertex in conflict",
      text: "The new cell lies along one edge, or far outside: no vertex is lost.",
      draw: (context, picture) => drawNew(context, picture, circle),
    });
  const drawFilled = (context, picture) => {
    drawHole(context, picture, circle);
    drawStar(context, picture, circle);
    drawNew(context, picture, circle);
  };
  steps.push(
    {
      title: "The hole",
      text: "What is between these vertices is removed: the edges that remain end in the open.",
      draw(context, picture) {
        drawHole(context, picture, circle);
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
function stepDown({ level, ids, path }, sites, circle, most) {
  const steps = path.length - 1;
  const long = steps === 1 ? "one step" : `${steps} steps`;
  return {
    title: level > 0 ? `Level ${level} of the hierarchy` : "Level 0, the diagram itself",
    text:
      level > 0
        ? `The same among ${ids.length} of the circles, which have a diagram of their own: ${long}.`
        : `From where the walk above ended: ${long} instead of ${most}.`,
    draw(context, picture) {
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

function drawWalk(context, { sites, view, theme }, path) {
  context.strokeStyle = theme.vertex;
  context.lineWidth = 3;
  context.beginPath();
  for (const id of path) context.lineTo(...screenOf(view, sites.site(id)));
  context.stroke();
  for (const id of path.slice(0, -1)) drawDot(context, view, sites.site(id), theme.vertex);
  const last = path.at(-1);
  drawCircle(context, view, { ...sites.site(last), r: sites.radius(last) }, theme.accent);
}

function drawRegion(context, { view, theme }, region, isWithCircle) {
  const known = new Map(region.map((vertex) => [vertex.id, vertex]));
  context.strokeStyle = theme.vertex;
  context.lineWidth = 4;
  context.beginPath();
  for (const vertex of region) {
    for (const other of vertex.lost) {
      if (!known.has(other) || other < vertex.id) continue;
      context.moveTo(...screenOf(view, vertex));
      context.lineTo(...screenOf(view, known.get(other)));
    }
  }
  context.stroke();
  for (const vertex of region) drawDot(context, view, vertex, theme.vertex);
  if (isWithCircle || region.length > 1)
    drawCircle(context, view, region.at(-1), theme.vertex, theme.emptyFill);
}

/** The cell to be, empty. */
function drawHole(context, { sites, view, theme }, circle) {
  context.beginPath();
  sites.tryOut(circle, (id) => addCell(context, sites, view, id));
  context.fillStyle = theme.paper;
  context.fill();
  context.strokeStyle = theme.selected;
  context.lineWidth = 2;
  context.stroke();
}

/** The dual edges of the new site, as straight lines. */
function drawStar(context, { sites, view, theme }, circle) {
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
