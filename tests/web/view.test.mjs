// The view: Fit, and zooming as deep as it goes.
import { expect, test } from "@jest/globals";
import {
  closePage,
  describeInBrowser,
  forEachPage,
  settled,
  show,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("the view", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  test.each([
    [1024, 768],
    [800, 600],
    [1280, 800],
  ])("Fit at %i x %i: all that there is, beside the bars", async (width, height) => {
    await page.setViewportSize({ width, height });
    await show(page, "cities");
    await page.evaluate(() => app.edits.insertCircle({ x: 30_000, y: 4000, r: 500 }));
    await page.click("#tool-fit");
    const outside = await page.evaluate(() => {
      const bars = [".bar", "#tools", "#status", "#library"].map((name) =>
        document.querySelector(name).getBoundingClientRect(),
      );
      return Array.from(app.diagram.ids()).filter((id) => {
        const { x, y } = app.diagram.site(id);
        const [px, py] = [app.view.toScreenX(x), app.view.toScreenY(y)];
        if (px < 0 || py < 0 || px > innerWidth || py > innerHeight) return true;
        return bars.some(
          (bar) => px > bar.left && px < bar.right && py > bar.top && py < bar.bottom,
        );
      });
    });
    expect(outside).toEqual([]);
  });

  test("Fit after Clear shows no world, but room to draw", async () => {
    await show(page, "cities");
    await page.evaluate(() => app.edits.clear());
    await page.click("#tool-fit");
    expect(await page.evaluate(() => app.view.width / app.view.scale)).toBeLessThan(3000);
  });

  test("a circle moved by arrows stays in the window", async () => {
    const [id] = await sitesInReach(page);
    const { x, y } = await whereIs(page, id);
    await page.mouse.click(x, y);
    for (const key of ["ArrowRight", "ArrowUp", "ArrowLeft", "ArrowDown"]) {
      for (let k = 0; k < 45; k++) await page.keyboard.press(`Shift+${key}`);
      const at = await whereIs(page, id);
      expect(at.x).toBeGreaterThan(0);
      expect(at.x).toBeLessThan(1280);
      expect(at.y).toBeGreaterThan(40);
      expect(at.y).toBeLessThan(760);
    }
  });
});

describeInBrowser("deep zoom", (open) => {
  // Whole rims, millions of pixels long, were stroked and dashed: frames took seconds, then the tab
  // crashed. What is drawn now is no longer than the window.
  test("sixty steps in and out: the page goes on, and draws the same", async () => {
    const page = await open({ isAlone: true });
    const [id] = await sitesInReach(page);
    const { x, y, r } = await whereIs(page, id);
    const at = { x: x + r + 6, y };
    await page.mouse.move(at.x, at.y);
    for (const wheel of [-120, 120]) {
      for (let step = 0; step < 60; ++step) {
        await page.mouse.wheel(0, wheel);
        if (step % 10 === 9) await settled(page);
      }
      await settled(page);
      expect((await stateOf(page)).broken).toBeNull();
    }
    expect((await whereIs(page, id)).r).toBeCloseTo(r, 3);
    await closePage(page);
  });

  test("of a circle as large as can be seen, paths have what is in the window", async () => {
    const page = await open();
    const found = await page.evaluate(() => {
      const { addDisc, addRim } = app.parts;
      const view = { width: 800, height: 600 };
      const record = (add, ...circle) => {
        const points = [];
        const path = new Proxy(
          {},
          {
            get:
              (_, name) =>
              (...xy) =>
                points.push([name, ...xy]),
          },
        );
        add(path, view, ...circle);
        return points;
      };
      const onRim = (points, x, y, r) =>
        points
          .filter(([name]) => name !== "closePath" && name !== "rect")
          .map((point) => Math.abs(Math.hypot(point.at(-2) - x, point.at(-1) - y) - r));
      const half = [400, 300 + 1e9, 1e9]; // its rim crosses the middle of the window
      return {
        whole: record(addRim, 100, 100, 50).map(([name]) => name),
        rim: Math.max(...onRim(record(addRim, ...half), ...half)),
        reach: Math.max(...record(addDisc, ...half).flatMap(([, ...xy]) => xy.map(Math.abs))),
        corners: record(addDisc, ...half).filter(([name]) => name === "lineTo").length,
        covered: record(addDisc, 400, 300, 1e9).map(([name]) => name),
        rimOfCovered: record(addRim, 400, 300, 1e9),
        elsewhere: record(addDisc, 1e9, 300, 1e8),
      };
    });
    expect(found.whole).toEqual(["moveTo", "arc"]);
    expect(found.rim).toBeLessThan(1e-3);
    expect(found.reach).toBeLessThan(2000);
    expect(found.corners).toBe(2);
    expect(found.covered).toEqual(["rect"]);
    expect(found.rimOfCovered).toEqual([]);
    expect(found.elsewhere).toEqual([]);
    await closePage(page);
  });
});
