// Files that do not load, or cannot be read: the page says so, and works.
import { expect, test } from "@jest/globals";
import { closePage, describeInBrowser, freeSpace, show, stateOf } from "./support/browser.mjs";

describeInBrowser("what fails to load", (open) => {
  test("cities: the page says so, and works", async () => {
    const page = await open({
      prepare: (page) => page.route("**/cities.json", (route) => route.abort()),
    });
    await show(page, "cities");
    expect(await page.textContent("#notice")).toMatch(/could not be loaded/);
    const { x, y } = await freeSpace(page);
    await page.click("#tool-draw");
    await page.mouse.click(x, y);
    expect(await stateOf(page)).toMatchObject({ size: 36, broken: null });
    await closePage(page);
  });

  test("scripts or the package: the page says what is missing", async () => {
    const page = await open({
      ready: null,
      prepare: (page) => page.route("**/start-*.js", (route) => route.abort()),
    });
    await page.waitForSelector("#notice:not([hidden])");
    expect(await page.textContent("#notice")).toMatch(/could not be started.*start-[\w-]+\.js/);
    await closePage(page);
  });

  test("on a phone, what went wrong in a menu is said beside it", async () => {
    const page = await open({ viewport: { width: 390, height: 780 }, hasTouch: true });
    await page.evaluate(() => document.querySelector("#sets").showPopover());
    await page.fill("#paste", "nonsense");
    await page.click("#load-text");
    await page.waitForSelector("#notice:not([hidden])");
    const isOnTop = await page.evaluate(() => {
      const { left, top, width, height } = document
        .querySelector("#notice")
        .getBoundingClientRect();
      return document.elementFromPoint(left + width / 2, top + height / 2)?.id;
    });
    expect(isOnTop).toBe("notice");
    await closePage(page);
  });

  test("a link with nonsense in it: the page says so, and opens", async () => {
    const page = await open({ path: "#set=random&n=50&edits=1:2,x,nonsense" });
    expect(await page.textContent("#notice")).toMatch(/could not be shown/);
    expect((await stateOf(page)).size).toBe(35);
    await closePage(page);
  });
});
