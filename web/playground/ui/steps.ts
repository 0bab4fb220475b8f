// Steps through one insertion or one deletion; the last one does it. What they tell of is beside
// the panel that tells it.
import type { App, Point } from "../app.js";
import { deletionSteps } from "../steps/deletion.js";
import { insertionSteps, type Step } from "../steps/insertion.js";
import type { Box } from "../picture/view.js";
import type { Questions } from "../steps/questions.js";
import { grouped } from "./dom.js";
import { element } from "./elements.js";
import { notify } from "./notice.js";

const kEdge = 30; // pixels from the border of what is free, at least
const kTallest = 300; // pixels: the panel of the longest step
const kMostShown = 20_000; // circles: all vertices are looked at

export function makeSteps(app: App) {
  const box = element("steps");
  let steps: Step[] = [];
  let at = 0;
  let finish = () => {};

  function show() {
    const step = steps[at];
    element("steps-title").textContent = step.title;
    element("steps-count").textContent = `${at + 1} of ${steps.length}`;
    element("steps-text").textContent = step.text;
    element("steps-back").disabled = at === 0;
    element("steps-next").textContent = at === steps.length - 1 ? "Do it" : "Next";
    showQuestions(step.questions);
    app.mark({ marks: step.draw });
  }

  function begin(found: Step[], done: () => void) {
    steps = found;
    finish = done;
    at = 0;
    box.hidden = false;
    element("show").hidePopover();
    app.selection.clear();
    show();
    element("steps-next").focus();
  }

  function end() {
    box.hidden = true;
    app.mark({ marks: null });
  }

  element("steps-next").addEventListener("click", () => {
    if (at < steps.length - 1) {
      at++;
      show();
      return;
    }
    end();
    finish();
  });
  element("steps-back").addEventListener("click", () => {
    at = Math.max(0, at - 1);
    show();
  });
  element("steps-end").addEventListener("click", end);
  app.model.on("change", () => {
    if (!box.hidden) end(); // they tell of a diagram that is no more
  });

  element("step-insert").addEventListener("click", () => {
    const free = freeBox(app);
    const circle = isTooMuch(app) ? null : newCircle(app, free);
    if (!circle) return;
    bringInto(app, free, circle);
    const steps = insertionSteps(app.sites, circle, startOf(app, free, circle));
    begin(steps, () => app.insertCircle(circle));
  });
  element("step-delete").addEventListener("click", () => {
    const free = freeBox(app);
    const id = app.selection.single >= 0 ? app.selection.single : middleOne(app, free);
    if (isTooMuch(app) || id < 0) return;
    bringInto(app, free, app.sites.site(id));
    begin(deletionSteps(app.sites, id), () => app.model.remove([id]));
  });
}

function showQuestions(questions?: Questions) {
  element("steps-questions").hidden = !questions;
  if (!questions) return;
  const rows = questions.rows.filter(({ stages }) => stages.some((count) => count > 0));
  element("steps-counts").replaceChildren(
    ...rows.map(({ question, stages }) => {
      const row = document.createElement("tr");
      const head = document.createElement("th");
      head.scope = "row";
      head.textContent = question;
      row.append(head);
      for (const count of stages) row.insertCell().textContent = grouped(count);
      return row;
    }),
  );
}

function isTooMuch(app: App) {
  const isSo = app.sites.size > kMostShown || app.sites.size < 3;
  if (isSo) notify(`This is shown for 3 to ${kMostShown.toLocaleString("en")} circles.`);
  return isSo;
}

/** What neither the bars nor the panel cover: it lies at the right, on a phone at the bottom. */
function freeBox({ view, insets }: App): Box {
  const panel = element("steps");
  const wasHidden = panel.hidden;
  panel.hidden = false;
  const { left: panelLeft, width } = panel.getBoundingClientRect();
  panel.hidden = wasHidden;
  const { left, top, right, bottom } = insets();
  const isBelow = width > view.width / 2;
  return {
    left: left + kEdge,
    top: top + kEdge,
    right: (isBelow ? view.width - right : panelLeft) - kEdge,
    bottom: view.height - bottom - kEdge - (isBelow ? kTallest : 0),
  };
}

const middleOf = ({ view }: App, { left, top, right, bottom }: Box) => [
  view.toWorldX((left + right) / 2),
  view.toWorldY((top + bottom) / 2),
];

/** Moves the view as little as it must to show a place there. */
function bringInto(app: App, { left, top, right, bottom }: Box, { x, y }: Point) {
  const [px, py] = [app.view.toScreenX(x), app.view.toScreenY(y)];
  const into = (p: number, low: number, high: number) => Math.min(Math.max(p, low), high) - p;
  const [dx, dy] = [into(px, left, right), into(py, top, bottom)];
  if (dx !== 0 || dy !== 0) app.pan(dx, dy);
}

const middleOne = (app: App, free: Box) => {
  const [x, y] = middleOf(app, free);
  return app.diagram.find(x, y);
};

/** One that takes several vertices: around the vertex nearest to the middle of what is free. */
function newCircle(app: App, free: Box) {
  const { diagram, view } = app;
  const { coordinates, clearance } = diagram.vertices();
  const [x, y] = middleOf(app, free);
  let best = -1;
  let least = Infinity;
  clearance.forEach((room, k) => {
    const distance = Math.hypot(coordinates[2 * k] - x, coordinates[2 * k + 1] - y);
    if (room * view.scale < 12 || distance >= least) return;
    least = distance;
    best = k;
  });
  if (best < 0) {
    notify("Zoom in: there is no room for another circle here.");
    return null;
  }
  const room = clearance[best];
  return { x: coordinates[2 * best] + 0.2 * room, y: coordinates[2 * best + 1], r: 0.5 * room };
}

/** Where the walk begins: at the visible site farthest away in what is free. */
function startOf({ sites, view, diagram }: App, free: Box, { x, y }: Point) {
  let best = -1;
  let most = -1;
  for (const id of sites.ids) {
    const site = sites.site(id);
    const [px, py] = [view.toScreenX(site.x), view.toScreenY(site.y)];
    const isSeen = px > free.left && py > free.top && px < free.right && py < free.bottom;
    const distance = Math.hypot(site.x - x, site.y - y);
    if (!isSeen || sites.isHidden(id) || distance <= most) continue;
    most = distance;
    best = id;
  }
  return best < 0 ? diagram.find(x, y) : best;
}
