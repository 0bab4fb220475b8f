// What once broke on the page, or misled. Each of these failed before it was mended.
import { describe, expect, test } from "@jest/globals";
import {
  circlesOf,
  closePage,
  describeInBrowser,
  drag,
  forEachPage,
  freeSpace,
  settled,
  show,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("defects", (open) => {
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

  test("a dropped file is read, not opened in place of the page", async () => {
    await page.evaluate(() => {
      const data = new DataTransfer();
      data.items.add(new File(["x,y,r\n1,2,3\n10,20,4\n"], "two.csv"));
      const event = (type) =>
        new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
      const results = ["dragover", "drop"].map((type) => document.body.dispatchEvent(event(type)));
      if (results.some(Boolean)) throw new Error("the browser would open the file");
    });
    await page.waitForFunction(() => app.diagram.size === 2);
    expect((await circlesOf(page)).map((row) => row.slice(1))).toEqual([
      [1, 2, 3],
      [10, 20, 4],
    ]);
  });

  test("links to elsewhere open beside the page", async () => {
    await show(page, "cities");
    const targets = await page.$$eval("a[href^=http]", (links) =>
      links.map((link) => [link.target, link.rel]),
    );
    expect(targets.length).toBeGreaterThan(2);
    for (const target of targets) expect(target).toEqual(["_blank", "noopener"]);
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

  test("the card's Delete leaves the focus on the diagram", async () => {
    const [id] = await sitesInReach(page);
    const { x, y } = await whereIs(page, id);
    await page.mouse.click(x, y);
    await settled(page);
    await page.click("#card-delete");
    expect(await page.evaluate(() => document.activeElement.id)).toBe("overlay");
  });

  test("a click selects what hovering highlights, wherever it is inside a circle", async () => {
    await show(page, "random", { n: "100", hidden: "30", seed: "3" });
    let count = 0;
    for (let k = 0; k < 100; k++) {
      const [x, y] = [60 + ((k * 97) % 1160), 170 + ((k * 61) % 500)];
      await page.mouse.move(x, y);
      const [hovered, isInside] = await page.evaluate(() => [
        app.pointer.hover?.id,
        app.pointer.hover?.distance <= 0,
      ]);
      if (!isInside) continue;
      count++;
      await page.keyboard.press("Escape");
      await page.mouse.click(x, y);
      expect((await stateOf(page)).selected).toEqual([hovered]);
    }
    expect(count).toBeGreaterThan(12);
  });
});

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

describeInBrowser("drawing", (open) => {
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

describeInBrowser("drags", (open) => {
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
