// The code that makes this diagram: to be copied and run as it is.
import type { Diagram } from "apollonius-diagram";
import type { App } from "../app.js";
import type { Sites } from "../model/sites.js";
import { short } from "./dom.js";
import { element } from "./elements.js";
import { copy } from "./share.js";

const kMostInline = 60; // circles

export function makeCodeDialog(app: App) {
  const dialog = element("code");
  const open = () => {
    element("code-text").textContent = codeOf(app);
    element("show").hidePopover();
    dialog.showModal();
  };
  for (const id of ["open-code", "open-code-2", "open-code-3"] as const)
    element(id).addEventListener("click", open);
  element("code-close").addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  element("code-copy").addEventListener("click", () =>
    copy(element("code-text").textContent, "The code is copied."),
  );
  element("install").addEventListener("click", () =>
    copy("npm install apollonius-diagram", "The install line is copied."),
  );
}

export function codeOf({ sites, diagram, view, pointer: { hover } }: App) {
  const [px, py] = hover ? [hover.x, hover.y] : [view.width / 2, view.height / 2];
  const number = (value: number) => Number(value.toPrecision(5));
  const [x, y] = [number(view.toWorldX(px)), number(view.toWorldY(py))];
  const found = diagram.find(x, y);
  // Ids are rows, as long as none was deleted.
  const isRow = sites.ids.every((id, k) => id === k);
  const window = [
    view.toWorldX(0),
    view.toWorldY(view.height),
    view.toWorldX(view.width),
    view.toWorldY(0),
  ].map(number);
  return `import { Diagram } from "apollonius-diagram";

${circlesOf(sites)}
const diagram = Diagram.from(circles);

diagram.find(${x}, ${y});${found >= 0 && isRow ? ` // ${found}: the nearest circle` : ""}
diagram.nearest(${x}, ${y}); // and how far it is${distanceOf(diagram, x, y)}
diagram.visibleSize; // ${diagram.visibleSize} of ${diagram.size}: the others are inside these
const cells = diagram.voronoi([${window.join(", ")}]);
const path = cells.render(); // for SVG; cells.render(context) for a canvas
`;
}

function distanceOf(diagram: Diagram, x: number, y: number) {
  const nearest = diagram.nearest(x, y);
  return nearest ? `: ${short(nearest.distance)}` : "";
}

/** All of them, if they are few. */
function circlesOf(sites: Sites) {
  if (sites.size > kMostInline)
    return `// x, y, r of ${sites.size} circles: Share, Export, JSON
const rows = await (await fetch("apollonius-diagram.json")).json();
const circles = rows.map(({ x, y, r }) => [x, y, r]);`;
  const rows = Array.from(sites.ids, (id) => {
    const { x, y, r } = sites.site(id);
    return `[${x}, ${y}, ${r}]`;
  });
  const lines: string[] = [];
  for (const row of rows) {
    const line = lines.at(-1);
    if (line !== undefined && line.length + row.length < 76)
      lines[lines.length - 1] = `${line} ${row},`;
    else lines.push(`  ${row},`);
  }
  return `const circles = [ // x, y, r\n${lines.join("\n")}\n];`;
}
