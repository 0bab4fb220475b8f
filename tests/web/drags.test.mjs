// Drags, and circles that are drawn by one: each is one edit, and goes on with its own circle.
import { describe, expect, test } from "@jest/globals";
import {
  circlesOf,
  closePage,
  describeInBrowser,
  drag,
  forEachPage,
  freeSpace,
  show,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("drags", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  describe("during a drag", () => {
    // A drag that went on after its circle was gone changed another circle, or threw.
    test.each([
      ["Delete", (page) => page.keyboard.press("Delete")],
      ["undo of everything", (page) => page.keyboard.press("Control+z")],
      ["I", (page) => page.keyboard.press("i")],
      [
        "select all and Delete",
        async (page) => {
          await page.keyboard.press("Control+a");
          await page.keyboard.press("Delete");
        },
      ],
      ["another set", (page) => show(page, "nesting")],
    ])("%s", async (_, act) => {
      const [id] = await sitesInReach(page);
      const { x, y } = await whereIs(page, id);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 30, y + 20, { steps: 3 });
      await act(page);
      const then = await circlesOf(page);
      await page.mouse.move(x + 120, y + 60, { steps: 4 });
      expect(await circlesOf(page)).toEqual(then);
      await page.mouse.up();
      expect(await circlesOf(page)).toEqual(then);
    });

    test("what was under the pointer is gone before the drag begins", async () => {
      const [id] = await sitesInReach(page);
      const { x, y } = await whereIs(page, id);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.evaluate(() => app.edits.clear());
      await page.mouse.move(x + 50, y, { steps: 3 });
      await page.mouse.up();
      expect(await stateOf(page)).toMatchObject({ size: 0, selected: [] });
    });

    test("N selects another circle, and the drag goes on with its own", async () => {
      const [id] = await sitesInReach(page);
      const { x, y } = await whereIs(page, id);
      const others = (rows) => rows.filter(([other]) => other !== id);
      const before = await circlesOf(page);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 30, y, { steps: 3 });
      await page.keyboard.press("n");
      await page.mouse.move(x + 60, y, { steps: 3 });
      await page.mouse.up();
      expect(others(await circlesOf(page))).toEqual(others(before));
      expect((await whereIs(page, id)).x).toBeCloseTo(x + 60, 0);
    });

    test("the same for a resize", async () => {
      const [id] = await sitesInReach(page);
      const { x, y, r } = await whereIs(page, id);
      await page.mouse.click(x, y);
      await page.mouse.move(x + Math.max(r + 5, 11), y);
      await page.mouse.down();
      await page.mouse.move(x + r + 25, y, { steps: 3 });
      await page.keyboard.press("Delete");
      const then = await circlesOf(page);
      expect(then.some(([other]) => other === id)).toBe(false);
      await page.mouse.move(x + r + 90, y, { steps: 3 });
      await page.mouse.up();
      expect(await circlesOf(page)).toEqual(then);
    });

    test("Escape gives it up", async () => {
      const before = await circlesOf(page);
      const [id] = await sitesInReach(page);
      const { x, y } = await whereIs(page, id);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 60, y, { steps: 3 });
      expect(await circlesOf(page)).not.toEqual(before);
      await page.keyboard.press("Escape");
      await page.mouse.move(x + 90, y, { steps: 3 });
      await page.mouse.up();
      expect(await circlesOf(page)).toEqual(before);
      expect(await page.evaluate(() => app.model.history.canUndo)).toBe(false);
    });
  });
});

describeInBrowser("a drag", (open) => {
  test("a circle keeps its id and size, and the edit is one", async () => {
    const page = await open();
    const [id] = await sitesInReach(page);
    const from = await whereIs(page, id);
    await drag(page, from, { x: from.x + 80, y: from.y + 40 }, 20);
    const to = await whereIs(page, id);
    expect(to.r).toBe(from.r);
    expect(Math.hypot(to.x - from.x - 80, to.y - from.y - 40)).toBeLessThan(0.5);
    await page.keyboard.press("Control+z");
    expect(await whereIs(page, id)).toEqual(from);
    expect(await page.evaluate(() => app.model.history.canUndo)).toBe(false);
    await closePage(page);
  });
});

describeInBrowser("drawing by a drag", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  const draw = async () => {
    const { x, y } = await freeSpace(page);
    await page.click("#tool-draw");
    await drag(page, { x, y }, { x: x + 30, y });
    return { x, y };
  };

  test("Delete takes the circle that was drawn, and the next click inserts none", async () => {
    const { x, y } = await draw();
    expect((await stateOf(page)).size).toBe(36);
    await page.click("#tool-delete");
    await page.mouse.click(x, y);
    expect((await stateOf(page)).size).toBe(35);
  });

  test("the handle of the circle that was drawn resizes it", async () => {
    const { x, y } = await draw();
    const [id] = (await stateOf(page)).selected;
    const before = await whereIs(page, id);
    await drag(page, { x: x + before.r + 5, y }, { x: x + before.r + 25, y });
    expect((await stateOf(page)).size).toBe(36);
    expect((await whereIs(page, id)).r).toBeCloseTo(before.r + 20, 0);
  });
});
