// Panels, buttons, the card, and what is said in words.
import { expect, test } from "@jest/globals";
import {
  closePage,
  describeInBrowser,
  drag,
  forEachPage,
  frames,
  settled,
  show,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

const kPhone = { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true };

const boxOf = (page, selector) =>
  page.$eval(selector, (node) => node.getBoundingClientRect().toJSON());
const meets = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

describeInBrowser("what runs", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  test("the button says what it stops", async () => {
    await page.evaluate(() => document.getElementById("drift").click());
    expect(await page.textContent("#stop-motion")).toBe("Stop drift");
    await page.click("#stop-motion");
    expect(await page.isVisible("#stop-motion")).toBe(false);
  });

  test("two at once have a button each, and Escape ends one after another", async () => {
    await page.evaluate(() => {
      document.getElementById("drift").click();
      app.navigation.load("random", { n: "900000" });
    });
    await page.waitForSelector("#progress:not([hidden])");
    expect(await page.textContent("#progress-cancel")).toBe("Cancel building");
    expect(await page.textContent("#stop-motion")).toBe("Stop drift");
    expect(meets(await boxOf(page, "#progress"), await boxOf(page, "#stop-motion"))).toBe(false);
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => document.getElementById("progress").hidden);
    expect(await page.evaluate(() => app.motion.isRunning)).toBe(true);
    await page.keyboard.press("Escape");
    expect(await page.evaluate(() => app.motion.isRunning)).toBe(false);
  });
});

describeInBrowser("neighbours", (open) => {
  test("a square of the grid has four, and the card explains the dual graph’s six", async () => {
    const page = await open({ path: "#set=grid" });
    const id = await page.evaluate(() => {
      const inner = app.sites.ids.find((id) => app.diagram.neighbors(id).length === 6);
      app.selection.set([inner]);
      const { x, y } = app.sites.site(inner);
      app.pointer.moveTo({ x: app.view.toScreenX(x), y: app.view.toScreenY(y) });
      return inner;
    });
    expect(id).toBeDefined();
    await settled(page);
    expect(await page.textContent("#card-facts")).toMatch(/neighbours4 \(6 in the dual graph/);
    expect(await page.textContent("#tag")).toContain("4 neighbours");
    expect(await page.evaluate(() => app.pointer.hover.neighbors.length)).toBe(4);
    await closePage(page);
  });
});

describeInBrowser("panels", (open) => {
  test.each([320, 360, 390])("at %i px nothing is cut off", async (width) => {
    const page = await open({ ...kPhone, viewport: { width, height: 700 } });
    for (const id of ["open-share", "open-sets", "open-show", "tool-select", "tool-fit"]) {
      const { left, right } = await boxOf(page, `#${id}`);
      expect([id, left >= 0 && right <= width]).toEqual([id, true]);
    }
    await closePage(page);
  });

  test.each([700, 800, 1000])("at %i px the card leaves the introduction free", async (width) => {
    const page = await open({ viewport: { width, height: 800 } });
    await page.evaluate(() => app.selection.set([3]));
    await settled(page);
    expect(meets(await boxOf(page, "#inspector"), await boxOf(page, "#intro"))).toBe(false);
    const { right } = await boxOf(page, "#open-share");
    expect(right).toBeLessThanOrEqual(width);
    await closePage(page);
  });

  test("grounds of menus, the introduction and the card let nothing shine through", async () => {
    const page = await open();
    const alphas = await page.evaluate(() =>
      ["show", "sets", "share", "intro", "inspector"].map((id) => {
        const color = getComputedStyle(document.getElementById(id)).backgroundColor;
        return [id, color.startsWith("rgb(")];
      }),
    );
    for (const [id, isOpaque] of alphas) expect([id, isOpaque]).toEqual([id, true]);
    await closePage(page);
  });

  test("phone: the picture goes back with the sheet, and header and card agree", async () => {
    const page = await open({ ...kPhone, path: "#set=random" });
    const origin = () => page.evaluate(() => [app.view.originX, app.view.originY]);
    const first = await origin();
    await page.evaluate(() => {
      const place = [app.view.toWorldX(100), app.view.toWorldY(550)];
      app.selection.set([app.diagram.find(...place)]);
      app.pointer.moveTo({ x: 300, y: 200 });
    });
    await page.tap("#grip");
    await page.waitForFunction((y) => app.view.originY !== y, first[1]);
    await settled(page);
    const name = await page.textContent("#card-name");
    expect(await page.textContent("#answer b")).toBe(name);
    await page.tap("#grip");
    await frames(page, 3);
    const back = await origin();
    expect(Math.hypot(back[0] - first[0], back[1] - first[1])).toBeLessThan(1e-6);
    await closePage(page);
  });

  test("an empty canvas says how to begin, and a drag draws", async () => {
    const page = await open({ path: "#set=empty" });
    await settled(page);
    expect(await page.textContent("#invitation")).toMatch(/Draw a circle: drag here/);
    expect(await page.isVisible("#invitation")).toBe(true);
    await drag(page, { x: 600, y: 400 }, { x: 660, y: 400 });
    await settled(page);
    expect((await stateOf(page)).size).toBe(1);
    expect((await whereIs(page, 0)).r).toBeCloseTo(60, 0);
    expect(await page.isVisible("#invitation")).toBe(false);
    await page.keyboard.press("Delete");
    await settled(page);
    expect(await page.isVisible("#invitation")).toBe(true);
    await closePage(page);
  });
});

describeInBrowser("what is told", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });
  const announced = (pattern) =>
    page.waitForFunction(
      (source) => new RegExp(source).test(document.getElementById("announcer").textContent),
      pattern.source,
    );

  test("moves, resizes and tools are announced", async () => {
    await page.focus("#overlay");
    await page.evaluate(() => app.selection.set([3]));
    await announced(/Circle 3 selected, \d+ neighbours/);
    await page.keyboard.press("ArrowLeft");
    await announced(/Circle 3 moved to x \d+, y \d+/);
    await page.keyboard.press("]");
    await announced(/Circle 3 resized, radius \d+/);
    await page.keyboard.press("d");
    await announced(/Draw tool/);
  });

  test("the status stays as large as it is, whatever it says", async () => {
    const sizes = new Set();
    for (const key of ["two", "nesting", "opening", "gasket"]) {
      await show(page, key);
      const { width, height } = await boxOf(page, "#status");
      sizes.add(`${width} ${height}`);
      await page.waitForTimeout(900);
      const later = await boxOf(page, "#status");
      sizes.add(`${later.width} ${later.height}`);
    }
    expect(sizes.size).toBe(1);
  });

  test("no name that only the paper's readers know", async () => {
    const text = await page.evaluate(() => document.body.textContent);
    for (const name of ["Composed", "Hierarchy levels", "Table 1", "Appendix A"])
      expect(text).not.toContain(name);
  });

  test("a thumbnail has all circles of its set, and none is cut", async () => {
    await page.click("#open-sets");
    const cut = await page.$$eval("#presets svg", (all) =>
      all.flatMap((svg, k) => {
        const box = svg.getBoundingClientRect();
        return Array.from(svg.querySelectorAll("circle"), (circle) => {
          const { left, top, right, bottom } = circle.getBoundingClientRect();
          const isCut =
            left < box.left || top < box.top || right > box.right || bottom > box.bottom;
          return isCut ? k : -1;
        }).filter((index) => index >= 0);
      }),
    );
    expect(cut).toEqual([]);
    expect(await page.$$eval("[data-set=grid] circle", (all) => all.length)).toBe(96);
  });
});
