// Motion without the visitor, and when it comes to rest; touch.
import { expect, test } from "@jest/globals";
import {
  circlesOf,
  closePage,
  describeInBrowser,
  forEachPage,
  frames,
  freeSpace,
  settled,
  show,
  showCircles,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("motion", (open) => {
  let page;
  forEachPage(open, (opened) => {
    page = opened;
  });

  const press = async (id) => {
    await page.click("#open-show");
    await page.click(`#${id}`);
  };

  test("drift: all circles move, as one edit", async () => {
    await show(page, "random", { n: "200", hidden: "5" });
    const before = await circlesOf(page);
    await press("drift");
    await page.waitForFunction(([, x]) => Math.abs(app.diagram.site(0).x - x) > 0.5, before[0]);
    expect((await stateOf(page)).broken).toBeNull();
    await page.evaluate(() => document.getElementById("drift").click());
    const after = await circlesOf(page);
    await frames(page, 10);
    expect(await circlesOf(page)).toEqual(after);
    const moved = after.filter((row, k) => row[1] !== before[k][1]).length;
    expect(moved).toBeGreaterThan(150);
    await page.evaluate(() => app.edits.undo());
    expect(await circlesOf(page)).toEqual(before);
  });

  test("what comes to rest has short numbers: 500 that drifted fit into a link", async () => {
    await show(page, "random", { n: "500" });
    const before = await circlesOf(page);
    await press("drift");
    await page.waitForFunction((x) => app.diagram.site(0).x !== x, before[0][1]);
    const { link, shift } = await page.evaluate(() => {
      const moving = app.sites.triples(app.sites.ids);
      app.motion.stop();
      const shift = app.sites.triples(app.sites.ids).map((value, k) => value - moving[k]);
      const link = app.navigation.write();
      return { link, shift: Math.max(...shift.map(Math.abs)) * app.view.scale };
    });
    expect(link.isWhole).toBe(true);
    expect(shift).toBeGreaterThan(0);
    expect(shift).toBeLessThan(1 / 60); // in pixels
    const after = await circlesOf(page);
    await page.reload();
    await page.waitForFunction(() => window.app);
    expect(await circlesOf(page)).toEqual(after);
  });

  test("what comes to rest is visible if it was before", async () => {
    await showCircles(page, [0, 0, 100, 60, 0, 50, 300, 0, 20]);
    const xyr = [1 / 3, 1 / 3, 100, 1 / 3 + 50.0004, 1 / 3, 50, 900 / 7, 0, 20];
    await page.evaluate(async (xyr) => {
      app.motion.start(app.sites.ids, () => Float64Array.from(xyr));
      while (app.diagram.site(0).x === 0) await new Promise(requestAnimationFrame);
      app.motion.stop();
    }, xyr);
    expect((await stateOf(page)).hidden).toBe(0);
    expect((await circlesOf(page)).map(([, x]) => x)).toEqual([0.333, 50.334, 128.571]);
  });

  test("any other edit ends the motion", async () => {
    await press("drift");
    await page.waitForFunction(() => app.motion.isRunning);
    await page.evaluate(() => app.edits.insertCircle({ x: 500, y: 300, r: 5 }));
    await page.waitForFunction(() => document.querySelector("#drift").ariaPressed === "false");
    expect((await stateOf(page)).size).toBe(36);
  });

  test.each([
    ["Stop, which can be seen", (page) => page.click("#stop-motion")],
    ["Escape", (page) => page.keyboard.press("Escape")],
    [
      "a click",
      async (page) => page.mouse.click(...Object.values(await freeSpace(page)).slice(0, 2)),
    ],
  ])("%s ends the motion", async (_, act) => {
    await press("drift");
    await page.waitForFunction(() => app.motion.isRunning);
    await act(page);
    await page.waitForFunction(() => !app.motion.isRunning);
    expect(await page.isVisible("#stop-motion")).toBe(false);
    expect(await page.getAttribute("#drift", "aria-pressed")).toBe("false");
  });
});

/**
 * Runs before a page's scripts: the page gets a frame when the test gives one, at the test's time.
 */
function giveFramesByHand() {
  let asked = new Map();
  let count = 0;
  window.requestAnimationFrame = (act) => {
    asked.set(++count, act);
    return count;
  };
  window.cancelAnimationFrame = (id) => asked.delete(id);
  const clock = { now: 1000 };
  window.byHand = {
    /** Does the page ask for a frame? */
    get isAsked() {
      return asked.size > 0;
    },
    /** A screen of 60 Hz for some seconds. @returns how many seconds the page asked for frames */
    run(seconds) {
      for (let k = 0; k < 60 * seconds; k++) {
        if (asked.size === 0) return k / 60;
        const acts = asked.values();
        asked = new Map();
        clock.now += 1000 / 60;
        for (const act of acts) act(clock.now);
      }
      return seconds;
    },
  };
}

/**
 * A finger that stays for half a second holds, and on a busy machine that can pass between any two
 * events of a test: so no timer starts when one comes down, unless the test says `canHold`.
 */
function neverHold() {
  const { setTimeout } = window;
  addEventListener(
    "pointerdown",
    () => {
      if (!window.canHold) window.setTimeout = () => 0;
    },
    true,
  );
  addEventListener("pointerdown", () => {
    window.setTimeout = setTimeout;
  });
}

describeInBrowser("untouched and seen, after ten seconds no frame is asked for", (open) => {
  const openByHand = (path, ready) =>
    open({
      path,
      ready,
      reducedMotion: "no-preference",
      prepare: (page) => page.addInitScript(giveFramesByHand),
    });

  test("the playground: one circle goes round and comes home", async () => {
    const page = await openByHand("playground/", "app");
    const { home, steps, far, after, address } = await page.evaluate(async () => {
      const where = () => app.sites.triples([3]).join();
      const home = where();
      let steps = 0;
      let far = 0;
      app.model.on("change", () => {
        steps++;
        far = Math.max(far, Math.abs(app.sites.site(3).x - Number(home.split(",")[0])));
      });
      byHand.run(10.1);
      // The canvases may still have to draw how it ends, by the real clock.
      for (let k = 0; byHand.isAsked && k < 1000; k++) {
        byHand.run(1 / 60);
        await new Promise((resolve) => setTimeout(resolve, 5));
      }
      const moved = steps;
      return {
        home,
        far,
        steps: moved,
        after: [where(), byHand.isAsked, app.model.open, app.model.history.canUndo],
        address: app.navigation.write().hash,
      };
    });
    expect(after).toEqual([home, false, null, false]);
    expect(far).toBeGreaterThan(20);
    expect(steps).toBeLessThanOrEqual(302); // 30 a second, the first, and the way home
    expect(steps).toBeGreaterThan(250);
    expect(address).not.toContain("edits");
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("the first figure: a tour, again after each touch, nothing while unseen", async () => {
    const page = await openByHand("./", "figures");
    const drawn = () => page.evaluate(() => window.drawn);
    const run = (seconds) => page.evaluate((seconds) => byHand.run(seconds), seconds);
    await page.waitForFunction(() => figures.has("twins"));
    await page.evaluate(() => {
      const twins = figures.get("twins");
      window.drawn = 0;
      const draw = twins.draw.bind(twins);
      twins.draw = () => {
        window.drawn++;
        draw();
      };
      twins.restart();
    });
    const at = () => page.evaluate(() => figures.get("twins").state.at);
    const first = await at();
    await run(5);
    expect(await at()).not.toEqual(first);
    expect(await run(6)).toBeLessThan(5.1);
    expect(await at()).toEqual(first);
    const tour = await drawn();
    expect(tour).toBeGreaterThan(250);
    expect(tour).toBeLessThanOrEqual(301);

    // Led by the pointer it is drawn when that moves; when it has left, the tour begins again.
    const stage = await page.locator("[data-figure=twins] .stage").boundingBox();
    await page.mouse.move(stage.x + 50, stage.y + 60);
    await page.waitForFunction(() => byHand.isAsked);
    expect(await run(1)).toBeLessThan(0.1);
    expect((await drawn()) - tour).toBeLessThan(4);
    await page.mouse.move(1, 1);
    await page.waitForFunction(() => byHand.isAsked);
    expect(await run(2)).toBe(2);

    // Out of the window, the figure asks for no frame; seen again, it goes on.
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await page.waitForFunction(() => byHand.run(1 / 60) === 0);
    const hidden = await drawn();
    await page.evaluate(() => scrollTo(0, 0));
    await page.waitForFunction(() => byHand.isAsked);
    expect(await drawn()).toBe(hidden);
    expect(await run(20)).toBeLessThan(10);
    expect(await at()).toEqual(first);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
});

describeInBrowser("touch", (open) => {
  let page;
  let send;
  const use = async (opened) => {
    page = opened;
    await page.evaluate(neverHold);
    const session = await page.context().newCDPSession(page);
    send = (type, ...points) =>
      session.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: points.map(([x, y], id) => ({ x, y, id })),
      });
  };
  forEachPage(open, use, { viewport: { width: 800, height: 900 }, hasTouch: true });

  /** Acts with a finger and waits until the page has felt that it has left. */
  const untilItLeaves = async (act) => {
    await page.evaluate(() => {
      window.left = new Promise((resolve) =>
        addEventListener("pointerup", resolve, { once: true }),
      );
    });
    await act();
    await page.evaluate(() => window.left);
  };

  const tap = ({ x, y }) => untilItLeaves(() => page.touchscreen.tap(x, y));

  /** The finger rests before it leaves: after a fling, Chromium takes the next tap as its end. */
  const swipe = (from, to, steps = 10) =>
    untilItLeaves(async () => {
      await send("touchStart", from);
      for (let k = 1; k <= steps; k++)
        await send("touchMove", [
          from[0] + ((to[0] - from[0]) * k) / steps,
          from[1] + ((to[1] - from[1]) * k) / steps,
        ]);
      await page.waitForFunction(
        ([x, y]) => app.pointer.at && Math.hypot(app.pointer.at.x - x, app.pointer.at.y - y) < 1,
        to,
      );
      await frames(page, 10);
      await send("touchMove", to);
      await frames(page, 10);
      await send("touchEnd");
    });

  test("a tap selects, a drag moves, and elsewhere moves the view", async () => {
    await showCircles(page, [0, 0, 20, 100, 0, 10, 100, 100, 10]);
    const from = await whereIs(page, 0);
    await tap(from);
    expect((await stateOf(page)).selected).toEqual([0]);
    await swipe([from.x, from.y], [from.x + 40, from.y + 30]);
    const to = await whereIs(page, 0);
    expect(Math.hypot(to.x - from.x - 40, to.y - from.y - 30)).toBeLessThan(1);
    const space = [to.x, to.y - 250];
    await swipe(space, [space[0] + 60, space[1]]);
    expect((await whereIs(page, 0)).x - to.x).toBeCloseTo(60, 3);
  });

  test("the handle resizes, the Delete tool deletes, the card duplicates", async () => {
    await showCircles(page, [0, 0, 20, 100, 0, 10, 100, 100, 10]);
    const { x, y, r } = await whereIs(page, 0);
    await tap({ x, y });
    expect((await stateOf(page)).selected).toEqual([0]);
    await swipe([x + r + 5, y], [x + r + 45, y]);
    expect((await whereIs(page, 0)).r - r).toBeCloseTo(40, 0);
    await page.tap("#card-duplicate");
    expect((await stateOf(page)).size).toBe(4);
    await page.tap("#tool-undo");
    await page.evaluate(() => app.selection.clear());
    await page.tap("#tool-delete");
    const other = await whereIs(page, 2);
    await tap(other);
    expect((await stateOf(page)).size).toBe(2);
  });

  test("two fingers zoom; what the first one had begun is given up", async () => {
    const before = await circlesOf(page);
    const [id] = await sitesInReach(page);
    const { x, y } = await whereIs(page, id);
    const scale = await page.evaluate(() => app.view.scale);
    await send("touchStart", [x, y]);
    await send("touchMove", [x + 20, y]);
    await send("touchMove", [x + 30, y]);
    // to the left, as the card of the first site is at the right
    await send("touchStart", [x + 30, y], [x - 70, y]);
    await send("touchMove", [x + 50, y], [x - 90, y]);
    await send("touchMove", [x + 80, y], [x - 120, y]);
    await send("touchEnd");
    expect((await page.evaluate(() => app.view.scale)) / scale).toBeGreaterThan(1.3);
    expect(await circlesOf(page)).toEqual(before);
  });

  test("holding adds to the selection, or selects by a box", async () => {
    await showCircles(page, [0, 0, 20, 100, 0, 10, 100, 100, 10]);
    const [a, b, c] = await Promise.all([0, 1, 2].map((id) => whereIs(page, id)));
    await tap(a);
    await page.evaluate(() => {
      window.canHold = true;
    });
    await send("touchStart", [b.x, b.y]);
    await page.waitForFunction(() => app.selection.size === 2);
    await send("touchEnd");
    expect((await stateOf(page)).selected).toEqual([0, 1]);
    const corner = [b.x - 60, b.y + 50];
    await send("touchStart", corner);
    await page.waitForFunction(() => app.painter.overlay.box !== null);
    for (let k = 1; k <= 8; k++)
      await send("touchMove", [
        corner[0] + (k * 120) / 8,
        corner[1] + ((c.y - 40 - corner[1]) * k) / 8,
      ]);
    await send("touchEnd");
    expect((await stateOf(page)).selected).toEqual([0, 1, 2]);
  });

  test("Draw: a tap inserts, a drag draws", async () => {
    const { x, y } = await freeSpace(page);
    await page.tap("#tool-draw");
    await tap({ x, y });
    expect((await stateOf(page)).size).toBe(36);
    await page.tap("#tool-undo");
    await swipe([x, y], [x + 50, y]);
    const { selected } = await stateOf(page);
    expect((await whereIs(page, selected[0])).r).toBeCloseTo(50, 0);
    await settled(page);
  });
});
