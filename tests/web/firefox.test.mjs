// The commonest things that visitors do, in Firefox: by real mouse and keyboard, the state asserted
// through the page's own model. Pages are Puppeteer's.
import { describe, expect, test } from "@jest/globals";
import {
  circlesOf,
  describeInFirefox,
  drag,
  forEachPage,
  freeSpace,
  painted,
  press,
  settled,
  show,
  showCircles,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";
import { isThorough } from "../support/effort.mjs";
import { kSound, kStorm, soundness, storm } from "./support/storm.mjs";

describeInFirefox("the page in Firefox", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  const at = (id) => whereIs(page, id);
  const fill = async (selector, value) => {
    await page.click(selector, { count: 3 });
    await page.keyboard.type(value);
  };

  test("it is drawn; Draw inserts, Delete removes, undo and redo", async () => {
    expect(await painted(page, "lines")).toBeGreaterThan(10_000);
    expect(await painted(page, "circles")).toBeGreaterThan(50_000);
    const before = await circlesOf(page);
    const { x, y } = await freeSpace(page);
    await page.keyboard.press("d");
    await page.mouse.click(x, y);
    const { size, selected } = await stateOf(page);
    expect(size).toBe(36);
    const there = await at(selected[0]);
    expect(Math.hypot(there.x - x, there.y - y)).toBeLessThan(0.5);
    await page.focus("#overlay");
    await page.keyboard.press("Delete");
    expect(await circlesOf(page)).toEqual(before);
    await press(page, "Control+z");
    expect((await stateOf(page)).size).toBe(36);
    await press(page, "Control+z");
    expect(await circlesOf(page)).toEqual(before);
    await press(page, "Control+y");
    expect((await stateOf(page)).size).toBe(36);
  });

  test("Draw: a drag draws from the centre; Alt-drag with any tool", async () => {
    const { x, y } = await freeSpace(page);
    await page.click("#tool-draw");
    await drag(page, { x, y }, { x: x + 40, y }, 4);
    const [id] = (await stateOf(page)).selected;
    expect((await at(id)).r).toBeCloseTo(40, 0);
    await page.click("#tool-select");
    await page.keyboard.down("Alt");
    await drag(page, { x: x + 5, y }, { x: x + 25, y }, 4);
    await page.keyboard.up("Alt");
    expect((await stateOf(page)).size).toBe(37);
  });

  test("a drag moves, Escape gives it up, the handle resizes, the wheel zooms", async () => {
    const before = await circlesOf(page);
    const [id] = await sitesInReach(page);
    const from = await at(id);
    await drag(page, from, { x: from.x + 60, y: from.y + 30 });
    const to = await at(id);
    expect(Math.hypot(to.x - from.x - 60, to.y - from.y - 30)).toBeLessThan(0.5);
    await page.mouse.down();
    await page.mouse.move(to.x + 90, to.y, { steps: 3 });
    await page.keyboard.press("Escape");
    await page.mouse.up();
    expect(await at(id)).toEqual(to);
    const handle = { x: to.x + Math.max(to.r + 5, 11), y: to.y };
    await drag(page, handle, { x: handle.x + 20, y: handle.y });
    expect((await at(id)).r - to.r).toBeCloseTo(20, 0);
    await page.click("#tool-undo");
    await page.click("#tool-undo");
    expect(await circlesOf(page)).toEqual(before);
    await page.mouse.move(from.x, from.y);
    await page.mouse.wheel({ deltaY: -100 });
    await page.waitForFunction(
      (r, id) => app.diagram.site(id).r * app.view.scale > r,
      {},
      from.r,
      id,
    );
  });

  test("a box and Ctrl A select, the Delete tool deletes, a second click goes deeper", async () => {
    await showCircles(page, [0, 0, 4, 100, 0, 4, 100, 100, 4, 1, 0, 1]);
    const [a, b] = [await at(0), await at(2)];
    await page.keyboard.down("Shift");
    await drag(page, { x: a.x - 40, y: a.y + 40 }, { x: b.x + 40, y: b.y - 40 });
    await page.keyboard.up("Shift");
    expect((await stateOf(page)).selected).toEqual([0, 1, 2, 3]);
    await page.keyboard.press("Escape");
    await page.mouse.click(a.x, a.y);
    await page.mouse.click(a.x, a.y);
    expect((await stateOf(page)).selected).toEqual([3]);
    await press(page, "Control+a");
    expect((await stateOf(page)).selected).toHaveLength(4);
    await page.keyboard.press("Escape");
    await page.click("#tool-delete");
    await page.mouse.click(b.x, b.y);
    expect((await stateOf(page)).size).toBe(3);
  });

  test("keys: neighbours, arrows, growing, duplicates", async () => {
    await page.focus("#overlay");
    await page.keyboard.press("Enter");
    const [id] = (await stateOf(page)).selected;
    const from = await at(id);
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("]");
    const to = await at(id);
    expect(to.x - from.x).toBeCloseTo(4, 0);
    expect(to.r).toBeGreaterThan(from.r);
    await press(page, "Control+d");
    expect((await stateOf(page)).size).toBe(36);
    await press(page, "Control+ArrowRight");
    await page.keyboard.press("n");
    expect((await stateOf(page)).selected).toHaveLength(1);
  });

  test("numbers can be edited", async () => {
    const [id] = await sitesInReach(page);
    const { x, y } = await at(id);
    await page.mouse.click(x, y);
    await settled(page);
    await fill("#card-r", "33.5");
    await page.keyboard.press("Enter");
    expect(await page.evaluate((id) => app.diagram.site(id).r, id)).toBe(33.5);
  });

  test("presets; random circles, many of them from the worker", async () => {
    const keys = await page.$$eval("#presets button", (all) =>
      all.map(({ dataset }) => dataset.set),
    );
    for (const key of keys.filter((_, k) => isThorough || k % 3 === 0)) {
      await page.click("#open-sets");
      await page.click(`#presets [data-set=${key}]`);
      await page.waitForFunction((key) => app.sites.info.key === key, {}, key);
      await settled(page);
      expect((await stateOf(page)).broken).toBeNull();
    }
    await page.click("#open-sets");
    await fill("#random [name=n]", "400");
    await page.click("#random [type=submit]");
    await page.waitForFunction(() => app.diagram.size === 400);
    await page.evaluate(() => app.navigation.load("random", { n: "120000", hidden: "5" }));
    expect(await page.evaluate(() => app.diagram.hiddenSize)).toBe(6000);
    await page.click("#tool-undo"); // it is exact, but checking it takes long
  });

  describe("files", () => {
    /** Returns what would be saved in this format; nothing is. */
    const saved = (format) =>
      page.evaluate(async (format) => {
        const { save } = app.parts;
        const { createObjectURL } = URL;
        const { click } = HTMLAnchorElement.prototype;
        let kept;
        URL.createObjectURL = (blob) => {
          kept = blob;
          return createObjectURL.call(URL, blob);
        };
        HTMLAnchorElement.prototype.click = () => {};
        await save(app, format);
        URL.createObjectURL = createObjectURL;
        HTMLAnchorElement.prototype.click = click;
        return [...new Uint8Array(await kept.arrayBuffer())];
      }, format);
    const drop = (bytes, name) =>
      page.evaluate(
        (bytes, name) => {
          const dataTransfer = new DataTransfer();
          dataTransfer.items.add(new File([Uint8Array.from(bytes)], name));
          const event = new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true });
          document.body.dispatchEvent(event);
        },
        bytes,
        name,
      );

    test("are read as they were written; a picture is one of the window", async () => {
      const numbers = async () => (await circlesOf(page)).map((row) => row.slice(1));
      for (const format of ["csv", "json"]) {
        await show(page, "nesting");
        const before = await numbers();
        const bytes = await saved(format);
        await show(page, "two");
        await drop(bytes, `a.${format}`);
        await page.waitForFunction((size) => app.diagram.size === size, {}, before.length);
        expect(await numbers()).toEqual(before);
      }
      const png = Buffer.from(await saved("png"));
      expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([1280, 800]);
    });

    test("text is pasted; the address brings it back, and Back what was before", async () => {
      await page.click("#open-sets");
      await page.click("#paste");
      await page.keyboard.type("x,y,r,name\n1,2,3,first\n10,20,4,\n");
      await page.click("#load-text");
      await page.waitForFunction(() => app.diagram.size === 2);
      await page.evaluate(() => app.navigation.write());
      await page.reload();
      await page.waitForFunction(() => window.app);
      expect((await circlesOf(page)).map((row) => row.slice(1))).toEqual([
        [1, 2, 3],
        [10, 20, 4],
      ]);
      await page.goBack();
      await page.waitForFunction(() => window.app?.diagram.size === 35);
    });
  });

  test("a storm of random events leaves the diagram sound", async () => {
    await page.setViewport(kStorm.window);
    await storm(page, { seed: 4, events: kStorm.events });
    expect(await soundness(page)).toEqual(kSound);
  });

  test("drift moves all", async () => {
    await page.click("#open-show");
    await page.click("#drift");
    await page.waitForFunction(() => app.motion.isRunning);
    const before = await circlesOf(page);
    await page.waitForFunction((x) => app.diagram.site(0).x !== x, {}, before[0][1]);
    await page.evaluate(() => app.motion.stop());
  });
});
