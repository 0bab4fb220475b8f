// One deletion in the steps of the paper (section 5): what is left open when a site goes is shared
// out by the diagram of its neighbours and of the circles that it alone had covered.
import type { Sites } from "../model/sites.js";
import { addCell, windowOf } from "../picture/curves.js";
import type { Picture } from "../picture/painter.js";
import { strokePartial } from "../picture/partial.js";
import { drawHole } from "./hole.js";
import type { Step } from "./insertion.js";
import { askedByDeletion, stepOfQuestions } from "./questions.js";

/** The circles that this one hides. */
function hiddenIn(sites: Sites, id: number) {
  const { x, y } = sites.site(id);
  const r = sites.radius(id);
  return [...sites.diagram.within(x, y, r)].filter((other) => {
    if (!sites.isHidden(other)) return false;
    const site = sites.site(other);
    return Math.hypot(site.x - x, site.y - y) + sites.radius(other) <= r;
  });
}

export function deletionSteps(sites: Sites, id: number): Step[] {
  const { name } = sites.label(id);
  if (sites.isHidden(id))
    return [
      {
        title: "Nothing to do",
        text: `${name} is hidden: the diagram does not change when it goes.`,
        draw() {},
      },
    ];
  const around = [...sites.diagram.neighbors(id)];
  const revived = hiddenIn(sites, id);
  const drawOpen = (context: CanvasRenderingContext2D, picture: Picture) =>
    drawHole(context, picture, () => addCell(context, picture.sites, picture.view, id));
  const drawPatch = (context: CanvasRenderingContext2D, picture: Picture) => {
    drawOpen(context, picture);
    drawFilling(context, picture, id, [...around, ...revived]);
  };
  return [
    {
      title: "The star",
      text: `${name} has ${around.length} neighbours; their cells will share out its own.`,
      draw(context: CanvasRenderingContext2D, { view, theme }: Picture) {
        context.strokeStyle = theme.dual;
        context.lineWidth = 2;
        context.beginPath();
        const { x, y } = sites.site(id);
        for (const other of around) {
          const site = sites.site(other);
          context.moveTo(view.toScreenX(x), view.toScreenY(y));
          context.lineTo(view.toScreenX(site.x), view.toScreenY(site.y));
        }
        context.stroke();
      },
    },
    {
      title: "The hole",
      text: "The site goes, and its cell with it.",
      draw: drawOpen,
    },
    {
      title: revived.length > 0 ? "The small diagram, with what was hidden" : "The small diagram",
      text:
        revived.length > 0
          ? `The diagram of the neighbours and of ${revived.length} circles that it covered.`
          : "The diagram of the neighbours alone, inside the hole, is what fills it.",
      draw: drawPatch,
    },
    stepOfQuestions(askedByDeletion(sites, id), drawPatch),
  ];
}

/** The cells of these sites alone, inside the cell of one that goes. */
function drawFilling(
  context: CanvasRenderingContext2D,
  picture: Picture,
  id: number,
  others: number[],
) {
  const { sites, view, theme } = picture;
  context.save();
  context.beginPath();
  addCell(context, sites, view, id);
  context.clip();
  context.strokeStyle = theme.cell;
  context.lineWidth = 2;
  strokePartial(context, picture, windowOf(view), others);
  context.restore();
}
