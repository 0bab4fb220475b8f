// The page as a visitor uses it: every way to change the diagram works as described. After each
// test the diagram's own exact check must find nothing.
import { describe, expect, test } from "@jest/globals";
import {
  circlesOf,
  closePage,
  describeInBrowser,
  drag,
  forEachPage,
  frames,
  freeSpace,
  painted,
  settled,
  show,
  showCircles,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("the page", (open) => {
  let page;
  let before;

  forEachPage(open, async (opened) => {
    page = opened;
    before = await stateOf(page);
  });

  const at = (id) => whereIs(page, id);

  describe("opens", () => {
    test("with composed circles, drawn and counted, and says what it is", async () => {
      expect(before).toMatchObject({ size: 35, hidden: 2 });
      expect(await painted(page, "lines")).toBeGreaterThan(10_000);
      expect(await painted(page, "circles")).toBeGreaterThan(50_000);
      await settled(page);
      expect(await page.textContent("#count-all")).toBe("35");
      expect(await page.textContent("#count-hidden")).toBe("2");
      expect(await page.textContent(".headline")).toMatch(/nearest circle,\s+not the nearest cent/);
      expect(await page.textContent("#install")).toBe("npm install apollonius-diagram");
    });

    test("with every element that its code asks for, of the right kind", async () => {
      const found = await page.evaluate(() => {
        const { element, kElementIds } = app.parts;
        return kElementIds.map((id) => element(id).id === id);
      });
      expect(found.length).toBeGreaterThan(70);
      expect(new Set(found)).toEqual(new Set([true]));
    });

    test("with one circle on its way, until the visitor acts; that is no edit", async () => {
      const moving = await open({ reducedMotion: "no-preference" });
      const first = await circlesOf(moving);
      await moving.waitForFunction(([, x]) => app.diagram.site(3).x !== x, first[3]);
      await moving.focus("#overlay");
      await moving.keyboard.press("Shift");
      const then = await circlesOf(moving);
      await frames(moving, 15);
      expect(await circlesOf(moving)).toEqual(then);
      expect(then.filter((row, k) => `${row}` !== `${first[k]}`)).toHaveLength(1);
      expect(await moving.evaluate(() => app.model.history.canUndo)).toBe(false);
      expect(moving.errors).toEqual([]);
      await closePage(moving);
    });

    test("in the dark, and at high density", async () => {
      const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const light = await paper();
      await page.emulateMedia({ colorScheme: "dark" });
      await settled(page);
      expect(await paper()).not.toBe(light);
      const phone = await open({
        viewport: { width: 390, height: 844 },
        deviceScaleFactor: 3,
        hasTouch: true,
        isMobile: true,
      });
      expect(
        await phone.evaluate(() => [app.painter.canvas("circles").width, app.view.width]),
      ).toEqual([1170, 390]);
      // upright sets for an upright window
      const [width, height] = await phone.evaluate(() => {
        const [xmin, ymin, xmax, ymax] = app.sites.bounds();
        return [xmax - xmin, ymax - ymin];
      });
      expect(height).toBeGreaterThan(width);
      expect(phone.errors).toEqual([]);
      await closePage(phone);
    });
  });

  describe("pointer", () => {
    test("Draw: a click inserts a circle there and selects it; Delete removes it", async () => {
      const { x, y } = await freeSpace(page);
      await page.keyboard.press("d");
      await page.mouse.click(x, y);
      const after = await stateOf(page);
      expect(after).toMatchObject({ size: 36, visible: before.visible + 1 });
      const there = await at(after.selected[0]);
      expect(Math.hypot(there.x - x, there.y - y)).toBeLessThan(0.5);
      await settled(page);
      expect(await page.isVisible("#inspector")).toBe(true);
      await page.focus("#overlay");
      await page.keyboard.press("Delete");
      expect(await stateOf(page)).toEqual(before);
      await settled(page);
      expect(await page.isVisible("#inspector")).toBe(false);
    });

    test("Draw: a drag draws from the centre, and shows the cell to be on the way", async () => {
      const { x, y } = await freeSpace(page);
      await page.click("#tool-draw");
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 40, y, { steps: 4 });
      expect(await page.evaluate(() => app.painter.overlay.draft.r * app.view.scale)).toBeCloseTo(
        40,
        1,
      );
      expect(await painted(page, "overlay")).toBeGreaterThan(3000);
      expect((await stateOf(page)).size).toBe(35); // not yet
      await page.mouse.up();
      const { selected } = await stateOf(page);
      expect((await at(selected[0])).r).toBeCloseTo(40, 0);
    });

    test("Alt-drag draws with any tool; Escape gives it up", async () => {
      const { x, y } = await freeSpace(page);
      await page.keyboard.down("Alt");
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 30, y, { steps: 4 });
      await page.keyboard.up("Alt");
      await page.keyboard.press("Escape");
      await page.mouse.up();
      expect(await stateOf(page)).toEqual(before);
      expect(await page.evaluate(() => app.painter.overlay.draft)).toBeNull();
    });

    test("a second click in the same place selects what lies beneath, and so on", async () => {
      await showCircles(page, [0, 0, 100, 5, 0, 60, -300, 0, 20, 6, 0, 20]);
      const { x, y } = await at(3);
      const seen = [];
      for (let k = 0; k < 4; k++) {
        await page.mouse.click(x, y);
        seen.push((await stateOf(page)).selected);
      }
      expect(seen).toEqual([[0], [1], [3], [0]]);
      await settled(page);
      await page.mouse.click(x, y);
      await settled(page);
      expect(await page.textContent("#card-facts")).toContain("none: it is hidden");
      await page.click("#card-facts button");
      expect((await stateOf(page)).selected).toEqual([0]);
    });

    test("a double click inserts where there is room", async () => {
      const { x, y } = await freeSpace(page);
      await page.mouse.dblclick(x, y);
      expect((await stateOf(page)).size).toBe(36);
    });

    test("Shift: a click adds, a drag selects by a box; all are moved together", async () => {
      await showCircles(page, [0, 0, 10, 100, 0, 10, 200, 0, 10, 100, 150, 10]);
      const places = await Promise.all([0, 1, 2, 3].map(at));
      await page.mouse.click(places[0].x, places[0].y);
      await page.keyboard.down("Shift");
      await page.mouse.click(places[3].x, places[3].y);
      expect((await stateOf(page)).selected).toEqual([0, 3]);
      await page.mouse.click(places[3].x, places[3].y);
      expect((await stateOf(page)).selected).toEqual([0]);
      await drag(
        page,
        { x: places[1].x - 60, y: places[1].y - 60 },
        { x: places[2].x + 40, y: places[2].y + 40 },
      );
      await page.keyboard.up("Shift");
      expect((await stateOf(page)).selected).toEqual([0, 1, 2]);
      await drag(page, places[1], { x: places[1].x + 50, y: places[1].y - 20 });
      const moved = await Promise.all([0, 1, 2, 3].map(at));
      expect(moved.map((p, k) => Math.round(p.x - places[k].x))).toEqual([50, 50, 50, 0]);
      await page.keyboard.press("Control+z");
      expect(await Promise.all([0, 1, 2, 3].map(at))).toEqual(places);
    });

    test("Pan moves the view, also upon circles; so do elsewhere a drag, and Space", async () => {
      const [id] = await sitesInReach(page);
      const from = await at(id);
      const space = await freeSpace(page);
      const circles = await circlesOf(page);
      await page.keyboard.press("h");
      await drag(page, from, { x: from.x + 50, y: from.y - 30 });
      expect((await at(id)).x - from.x).toBeCloseTo(50, 6);
      await page.keyboard.press("v");
      await drag(page, { x: space.x + 50, y: space.y - 30 }, space);
      expect((await at(id)).x - from.x).toBeCloseTo(0, 6);
      await page.focus("#overlay");
      await page.keyboard.down(" ");
      await drag(page, from, { x: from.x + 20, y: from.y });
      await page.keyboard.up(" ");
      expect((await at(id)).x - from.x).toBeCloseTo(20, 6);
      expect(await circlesOf(page)).toEqual(circles);
    });

    test("Delete: a click, and a drag over several", async () => {
      await showCircles(page, [0, 0, 10, 100, 0, 10, 200, 0, 10, 300, 100, 10]);
      const places = await Promise.all([0, 1, 2, 3].map(at));
      await page.click("#tool-delete");
      await page.mouse.click(places[3].x, places[3].y);
      expect((await stateOf(page)).size).toBe(3);
      await drag(page, places[0], places[2], 60);
      expect((await stateOf(page)).size).toBe(0);
      for (let k = 0; k < 4; k++) await page.click("#tool-undo");
      expect(await Promise.all([0, 1, 2, 3].map(at))).toEqual(places);
    });

    test("the wheel zooms about the pointer", async () => {
      const [id] = await sitesInReach(page);
      const from = await at(id);
      await page.mouse.move(from.x, from.y);
      await page.mouse.wheel(0, -100);
      const zoomed = await at(id);
      // the browser rounds the wheel's position
      expect(Math.hypot(zoomed.x - from.x, zoomed.y - from.y)).toBeLessThan(0.5);
      expect(zoomed.r / from.r).toBeCloseTo(Math.exp(0.16), 6);
    });

    test("the handle resizes; a circle that grows hides others, and shrinks back", async () => {
      await show(page, "cities");
      const cities = await stateOf(page);
      const [id] = await sitesInReach(page);
      const { x, y, r } = await at(id);
      await page.mouse.click(x, y);
      const handle = x + Math.max(r + 5, 11);
      await page.mouse.move(handle, y);
      await page.mouse.down();
      await page.mouse.move(handle + 120, y, { steps: 6 });
      const grown = await stateOf(page);
      expect(grown).toMatchObject({ size: 1500, broken: null });
      expect(grown.hidden).toBeGreaterThan(cities.hidden + 3);
      await page.keyboard.press("Escape");
      await page.mouse.up();
      expect(await stateOf(page)).toMatchObject({ hidden: cities.hidden });
      expect((await at(id)).r).toBe(r);
    });

    test("moving highlights the nearest site and its neighbours, as brute force does", async () => {
      await show(page, "cities");
      for (let k = 0; k < 30; k++) {
        await page.mouse.move(320 + ((k * 97) % 640), 180 + ((k * 61) % 490));
        const { hover, nearest, neighbors } = await page.evaluate(() => {
          const { x, y, id, distance } = app.pointer.hover;
          const px = app.view.toWorldX(x);
          const py = app.view.toWorldY(y);
          const nearest = { id: -1, distance: Infinity };
          for (const other of app.diagram.ids()) {
            const site = app.diagram.site(other);
            const d = Math.hypot(px - site.x, py - site.y) - site.r;
            if (d < nearest.distance) Object.assign(nearest, { id: other, distance: d });
          }
          return { hover: { id, distance }, nearest, neighbors: [...app.pointer.hover.neighbors] };
        });
        expect(hover.id).toBe(nearest.id);
        expect(hover.distance).toBeCloseTo(nearest.distance, 6);
        expect(neighbors.length).toBeGreaterThan(0);
        expect(neighbors).not.toContain(hover.id);
      }
      await settled(page);
      const label = await page.evaluate(() => app.sites.label(app.pointer.hover.id).name);
      expect(await page.textContent("#tag")).toContain(label);
      await page.mouse.move(400, 10); // onto the bar
      expect(await page.evaluate(() => app.pointer.hover)).toBeNull();
      await settled(page);
      expect(await page.isVisible("#tag")).toBe(false);
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

  describe("keyboard", () => {
    test("Ctrl with arrows selects the next circle in that direction", async () => {
      await showCircles(
        page,
        [0, 1, 2].flatMap((row) => [0, 1, 2].flatMap((column) => [100 * column, 100 * row, 20])),
      );
      await page.evaluate(() => app.selection.set([4])); // the middle one; y points upwards
      await page.focus("#overlay");
      const reached = [];
      for (const key of ["ArrowUp", "ArrowRight", "ArrowDown", "ArrowDown", "ArrowLeft"]) {
        await page.keyboard.press(`Control+${key}`);
        reached.push((await stateOf(page)).selected[0]);
      }
      expect(reached).toEqual([7, 8, 5, 2, 1]);
      await page.keyboard.press("Control+ArrowDown"); // none is there
      expect((await stateOf(page)).selected).toEqual([1]);
    });

    test("arrows, ], I, Ctrl D, Delete, Ctrl A, and undo of it all", async () => {
      const circles = await circlesOf(page);
      await page.focus("#overlay");
      await page.keyboard.press("Enter");
      const [id] = (await stateOf(page)).selected;
      const from = await at(id);
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("Shift+ArrowUp");
      await page.keyboard.press("]");
      const to = await at(id);
      expect(Math.hypot(to.x - from.x - 4, to.y - from.y + 40)).toBeLessThan(0.5);
      expect(to.r / from.r).toBeCloseTo(1.05, 1);
      await page.keyboard.press("i");
      await page.keyboard.press("Control+d");
      expect((await stateOf(page)).size).toBe(37);
      await page.keyboard.press("Delete");
      await page.keyboard.press("Control+a");
      expect((await stateOf(page)).selected).toHaveLength(36);
      await page.keyboard.press("Escape");
      expect((await stateOf(page)).selected).toEqual([]);
      for (let k = 0; k < 6; k++) await page.keyboard.press("Control+z");
      expect(await circlesOf(page)).toEqual(circles);
      expect(await page.evaluate(() => app.model.history.canUndo)).toBe(false);
      for (let k = 0; k < 6; k++) await page.keyboard.press("Control+Shift+z");
      expect((await stateOf(page)).size).toBe(36);
    });

    test("without a selection arrows move the view and +, − zoom", async () => {
      await page.focus("#overlay");
      const view = () => page.evaluate(() => [app.view.originX, app.view.scale]);
      const [x, scale] = await view();
      await page.keyboard.press("ArrowLeft");
      expect((await view())[0]).toBe(x + 60);
      await page.keyboard.press("+");
      expect((await view())[1]).toBeCloseTo(1.25 * scale, 9);
    });
  });

  describe("inspector", () => {
    test("the card never lies on the circle that it is about", async () => {
      const covered = async (id) => {
        const { x, y } = await at(id);
        await page.mouse.click(x, y);
        expect((await stateOf(page)).selected).toEqual([id]);
        await settled(page);
        return page.$eval(
          "#inspector",
          (card, [x, y]) => {
            const { left, right, top, bottom } = card.getBoundingClientRect();
            return x > left && x < right && y > top && y < bottom;
          },
          [x, y],
        );
      };
      await showCircles(page, [0, 0, 10, 600, 0, 10, 600, 300, 10, 0, 300, 10]);
      for (const id of [0, 1, 2, 3]) {
        expect([id, await covered(id)]).toEqual([id, false]);
        await page.keyboard.press("Escape"); // it may lie on the next one
        await settled(page);
      }
    });

    test("numbers can be edited, and the edit undone; nonsense is refused", async () => {
      const [id] = await sitesInReach(page);
      const { x, y } = await at(id);
      await page.mouse.click(x, y);
      await settled(page);
      const circles = await circlesOf(page);
      await page.fill("#card-r", "33.5");
      await page.press("#card-r", "Enter");
      expect(await page.evaluate((id) => app.diagram.site(id).r, id)).toBe(33.5);
      await page.fill("#card-x", "1e300");
      await page.press("#card-x", "Enter");
      expect(await page.evaluate((id) => app.diagram.site(id).r, id)).toBe(33.5);
      expect(await page.$eval("#card-x", (field) => field.validity.customError)).toBe(true);
      await page.click("#tool-undo");
      expect(await circlesOf(page)).toEqual(circles);
    });

    test("says area, neighbours and what is hidden; duplicates, resizes", async () => {
      await showCircles(page, [0, 0, 50, 10, 0, 8, 300, 0, 10, -300, 0, 10, 0, 300, 9, 0, -300, 9]);
      const { x, y } = await at(0);
      await page.mouse.click(x + 40, y);
      await settled(page);
      const area = await page.evaluate(() =>
        app.diagram.voronoi([-5000, -5000, 5000, 5000]).cellArea(0),
      );
      const facts = await page.textContent("#card-facts");
      expect(Number(facts.match(/area([\d\u202f.]+)/)[1].replaceAll("\u202f", ""))).toBeCloseTo(
        area,
        -1,
      );
      expect(facts).toMatch(/neighbours4hidden inside it1/);
      await page.click("#card-duplicate");
      expect(await stateOf(page)).toMatchObject({ size: 7, selected: [6], broken: null });
      await page.click("#card-larger");
      expect((await page.evaluate(() => app.diagram.site(6).r)) / 50).toBeCloseTo(1.15, 2);
    });
  });

  test("links to elsewhere open beside the page", async () => {
    await show(page, "cities");
    const targets = await page.$$eval("a[href^=http]", (links) =>
      links.map((link) => [link.target, link.rel]),
    );
    expect(targets.length).toBeGreaterThan(2);
    for (const target of targets) expect(target).toEqual(["_blank", "noopener"]);
  });

  test("a hidden circle is seen to come to light when its cover goes", async () => {
    await page.evaluate(() => app.setLayer("hidden", true));
    expect(await page.evaluate(() => app.sites.isHidden(1))).toBe(true);
    const isMarked = await page.evaluate(async () => {
      app.model.remove([0]);
      await new Promise(requestAnimationFrame); // in which the marks are made, just before
      return app.painter.overlay.revived !== null;
    });
    expect(isMarked).toBe(true);
    expect(await page.evaluate(() => app.sites.isHidden(1))).toBe(false);
    await page.waitForFunction(() => app.painter.overlay.revived === null);
  });

  describe("layers", () => {
    const layers = [
      "circles",
      "cells",
      "distances",
      "dual",
      "centres",
      "vertices",
      "levels",
      "hull",
    ];
    test.each(layers)("%s can be switched", async (layer) => {
      const canvas = layer === "circles" ? "circles" : "lines";
      if (layer === "levels") await show(page, "cities"); // few circles have few on levels
      const set = async (isShown) => {
        await page.evaluate(([layer, isShown]) => app.setLayer(layer, isShown), [layer, isShown]);
        return painted(page, canvas);
      };
      for (const other of layers)
        if (other !== layer && other !== "circles")
          await page.evaluate((other) => app.setLayer(other, false), other);
      expect(await set(true)).toBeGreaterThan((await set(false)) + 1000);
    });

    test("the menu switches them, and what is answered at the pointer", async () => {
      await page.click("#open-show");
      await page.uncheck("[name=cells]");
      expect(await page.evaluate(() => app.painter.layers.cells)).toBe(false);
      await page.check("[name=under]");
      await page.check("[name=empty]");
      await page.check("#questions [name=nearest]");
      await page.keyboard.press("Escape");
      const { x, y } = await at(1); // hidden in 0
      await page.mouse.move(x, y);
      await settled(page);
      const { under, nearest, empty } = await page.evaluate(() => ({
        under: [...app.pointer.hover.under],
        nearest: [...app.pointer.hover.nearest],
        empty: app.pointer.hover.empty,
      }));
      expect(under).toEqual([0, 1]);
      expect(nearest).toHaveLength(5);
      const gap = await page.evaluate(
        ({ x, y, r }) => app.diagram.nearest(x, y).distance - r,
        empty,
      );
      expect(gap).toBeCloseTo(0, 6);
      expect(await page.textContent("#tag")).toContain("in Circle 0, Circle 1");
    });
  });
});
