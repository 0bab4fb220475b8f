// Undo, and what must not be lost.
import { expect, test } from "@jest/globals";
import {
  circlesOf,
  describeInBrowser,
  forEachPage,
  freeSpace,
  show,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("undo", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  test("everything has a way back: Clear, Delete, sets", async () => {
    const first = await circlesOf(page);
    await page.evaluate(() => app.edits.clear());
    expect((await stateOf(page)).size).toBe(0);
    await page.keyboard.press("Control+z");
    expect(await circlesOf(page)).toEqual(first);

    await show(page, "gasket");
    const gasket = await circlesOf(page);
    const [id] = await sitesInReach(page);
    const { x, y } = await whereIs(page, id);
    await page.click("#tool-delete");
    await page.mouse.click(x, y);
    expect((await stateOf(page)).size).toBe(gasket.length - 1);
    await page.click("#tool-undo");
    expect(await circlesOf(page)).toEqual(gasket);
    await page.click("#tool-undo");
    expect(await circlesOf(page)).toEqual(first);
    await page.click("#tool-redo");
    expect(await circlesOf(page)).toEqual(gasket);
  });

  test("a swipe to the side cannot leave the page, and leaving it loses nothing", async () => {
    const behaviour = await page.evaluate(() =>
      [document.documentElement, document.body].map(
        (element) => getComputedStyle(element).overscrollBehaviorX,
      ),
    );
    expect(behaviour).toEqual(["none", "none"]);
    const { x, y } = await freeSpace(page);
    await page.click("#tool-draw");
    await page.mouse.click(x, y);
    const edited = await circlesOf(page);
    await page.goto("about:blank");
    await page.goBack();
    await page.waitForFunction(() => window.app);
    expect((await circlesOf(page)).map((row) => row.slice(1))).toEqual(
      edited.map((row) => row.slice(1)),
    );
  });
});
