// Keys: what each does wherever the focus is.
import { expect, test } from "@jest/globals";
import {
  circlesOf,
  describeInBrowser,
  forEachPage,
  settled,
  show,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("keys", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });
  const scale = () => page.evaluate(() => app.view.scale);

  test("+ and − zoom wherever the focus is, with a selection too; [ and ] resize", async () => {
    const [id] = await sitesInReach(page);
    await page.evaluate((id) => app.selection.set([id]), id);
    await settled(page);
    const circles = await circlesOf(page);
    for (const focus of ["#overlay", "#tool-fit", "#open-sets", "#open-code-2"]) {
      await page.focus(focus);
      const before = await scale();
      await page.keyboard.press("+");
      expect((await scale()) / before).toBeCloseTo(1.25, 6);
      await page.keyboard.press("-");
      expect(await scale()).toBeCloseTo(before, 6);
    }
    expect(await circlesOf(page)).toEqual(circles);
    const { r } = await whereIs(page, id);
    await page.keyboard.press("]");
    expect((await whereIs(page, id)).r / r).toBeCloseTo(1.05, 1);
    await page.keyboard.press("[");
    expect((await whereIs(page, id)).r / r).toBeCloseTo(1, 1);
    await page.click("#card-larger");
    expect((await whereIs(page, id)).r).toBeGreaterThan(r);
    expect(await page.textContent("#keys-text")).toMatch(/\[ \] make smaller and larger/);
    expect(await page.textContent("#keys-text")).toMatch(/\+ − zoom/);
  });

  test("in text fields keys write, and Ctrl Z is the field's", async () => {
    const [id] = await sitesInReach(page);
    await page.evaluate((id) => app.selection.set([id]), id);
    await page.evaluate(() => app.edits.grow(1.5));
    await settled(page);
    const circles = await circlesOf(page);
    const before = await scale();
    await page.click("#card-x");
    await page.keyboard.type("7-");
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Escape");
    await page.click("#open-sets");
    await page.click("#paste");
    await page.keyboard.type("1+[]");
    await page.keyboard.press("Control+z");
    expect(await scale()).toBe(before);
    await page.keyboard.press("Escape");
    expect((await circlesOf(page)).find(([other]) => other === id)[3]).toBe(
      circles.find(([other]) => other === id)[3],
    );
  });

  test("sixty presses of N reach sixty circles", async () => {
    await show(page, "random", { n: "100", hidden: "0" });
    await page.focus("#overlay");
    await page.keyboard.press("Enter");
    const reached = new Set();
    for (let k = 0; k < 60; k++) {
      await page.keyboard.press("n");
      reached.add((await stateOf(page)).selected[0]);
    }
    expect(reached.size).toBe(60);
    await page.keyboard.press("p");
    expect(reached.has((await stateOf(page)).selected[0])).toBe(true);
  });

  test("the card's Delete leaves the focus on the diagram", async () => {
    const [id] = await sitesInReach(page);
    const { x, y } = await whereIs(page, id);
    await page.mouse.click(x, y);
    await settled(page);
    await page.click("#card-delete");
    expect(await page.evaluate(() => document.activeElement.id)).toBe("overlay");
  });
});
