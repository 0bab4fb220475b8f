// Hidden circles that come to light because what covered them has gone are seen to do so: a ring
// spreads from each for a moment.
import type { App } from "./app.js";
import { addRim } from "./picture/discs.js";
import type { Picture } from "./picture/picture.js";

const kTime = 900; // ms
const kReach = 26; // pixels that a ring spreads
const kMostChanged = 12; // circles that change at once
const kMostSites = 20_000; // a large circle among very many has too many around it

export function showRevivals(app: App) {
  let covered: number[] = [];
  /** When each was revived. */
  const revived = new Map<number, number>();
  let isRunning = false;

  /** The circles that come near one's centre by its radius: what it covers is among them. */
  const around = (id: number) => {
    const { x, y } = app.sites.site(id);
    return Array.from(app.diagram.within(x, y, app.sites.radius(id)));
  };

  app.model.on("before", ({ ids, isSet }) => {
    covered = [];
    const { size, hiddenSize } = app.diagram;
    if (isSet || !ids || ids.length > kMostChanged) return;
    if (hiddenSize === 0 || size > kMostSites) return;
    const there = Array.from(ids).filter((id) => app.diagram.has(id));
    covered = [...new Set(there.flatMap(around))].filter((id) => app.sites.isHidden(id));
  });
  app.model.on("change", () => {
    const now = performance.now();
    for (const id of covered)
      if (app.diagram.has(id) && !app.sites.isHidden(id)) revived.set(id, now);
    covered = [];
    if (revived.size === 0 || isRunning) return;
    isRunning = true;
    requestAnimationFrame(frame);
  });

  const frame = () => {
    const now = performance.now();
    for (const [id, start] of revived)
      if (now - start > kTime || !app.diagram.has(id)) revived.delete(id);
    isRunning = revived.size > 0;
    app.mark({ revived: isRunning ? draw : null });
    if (isRunning) requestAnimationFrame(frame);
  };

  const draw = (context: CanvasRenderingContext2D, { sites, view, theme }: Picture) => {
    context.strokeStyle = theme.site;
    for (const [id, start] of revived) {
      if (!sites.diagram.has(id)) continue;
      const t = Math.min(1, (performance.now() - start) / kTime);
      const { x, y } = sites.site(id);
      const r = sites.radius(id) * view.scale + kReach * t;
      context.globalAlpha = 1 - t;
      context.lineWidth = 3;
      context.beginPath();
      addRim(context, view, view.toScreenX(x), view.toScreenY(y), r);
      context.stroke();
    }
    context.globalAlpha = 1;
  };
}
