// The page as a visitor uses it: it opens on real data, and every way to change the diagram does
// what it says. After each interaction the diagram's own exact check must find nothing.
import { afterEach, beforeEach, describe, expect, test } from "@jest/globals";
import {
  describeInBrowser,
  freeSpace,
  settled,
  sitesInReach,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

/** How many pixels of a canvas are not transparent. */
const painted = (page, name) =>
  page.evaluate((name) => {
    const canvas = app.painter.canvases[name];
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let k = 3; k < data.length; k += 4) if (data[k] > 0) count++;
    return count;
  }, name);

const texts = (page, ...ids) =>
  page.evaluate((ids) => ids.map((id) => document.getElementById(id).textContent), ids);

describeInBrowser("the page", (open) => {
  let page;
  let before;

  beforeEach(async () => {
    page = await open();
    before = await stateOf(page);
  });

  afterEach(async () => {
    expect((await stateOf(page)).broken).toBeNull();
    expect(page.errors).toEqual([]);
    await page.context().close();
  });

  describe("opens", () => {
    test("on the cities of the world, drawn, counted and credited", async () => {
      expect(before.size).toBe(1500);
      expect(before.hidden).toBeGreaterThan(100);
      // The first drawing waits for the canvas to get its size, which can take more than two frames
      // while the machine is busy.
      for (let k = 0; k < 300 && (await painted(page, "map")) === 0; ++k) await settled(page);
      expect(await painted(page, "map")).toBeGreaterThan(100_000);
      expect(await painted(page, "base")).toBeGreaterThan(50_000);
      expect(await texts(page, "count-all", "count-visible", "count-hidden")).toEqual(
        [before.size, before.visible, before.hidden].map((n) =>
          n.toLocaleString("en").replace(",", "\u202f"),
        ),
      );
      const credit = await page.textContent("#credit");
      expect(credit).toMatch(/GeoNames/);
      expect(credit).toMatch(/CC BY/);
      expect(credit).toMatch(/Natural Earth/);
    });

    test("in the dark, on a small touch screen, and at high density", async () => {
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
      expect(await phone.evaluate(() => [app.painter.canvases.base.width, app.view.width])).toEqual(
        [1170, 390],
      );
      expect(await phone.isVisible("#controls")).toBe(false);
      await phone.tap("#fold");
      expect(await phone.isVisible("#controls")).toBe(true);
      expect(phone.errors).toEqual([]);
      await phone.context().close();
    });
  });

  describe("pointer", () => {
    test("a click in empty space inserts a circle there and selects it", async () => {
      const { x, y } = await freeSpace(page);
      await page.mouse.click(x, y);
      const after = await stateOf(page);
      expect(after).toMatchObject({
        size: before.size + 1,
        visible: before.visible + 1,
        broken: null,
      });
      const at = await whereIs(page, after.selected);
      expect([at.x, at.y]).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 6)]);
      await settled(page);
      expect(await page.isVisible("#card")).toBe(true);
      await page.keyboard.press("Delete"); // the click has focused the canvas
      expect(await stateOf(page)).toEqual(before);
      await settled(page);
      expect(await page.isVisible("#card")).toBe(false);
    });

    test("a click on a circle selects it; Alt-click inserts upon it, or hidden", async () => {
      const id = await page.evaluate(() =>
        [...app.diagram.ids()].find((id) => app.scene.label(id).name === "Berlin"),
      );
      const { x, y, r } = await whereIs(page, id);
      expect(r).toBeGreaterThan(16);
      await page.mouse.click(x, y);
      expect(await stateOf(page)).toMatchObject({ size: before.size, selected: id });
      await page.keyboard.down("Alt");
      await page.mouse.click(x, y);
      await page.keyboard.up("Alt");
      const after = await stateOf(page);
      expect(after).toMatchObject({ size: before.size + 1, hidden: before.hidden + 1 });
      expect(await page.evaluate((id) => app.diagram.coverOf(id), after.selected)).toBe(id);
      await settled(page);
      expect(await page.textContent("#card-numbers")).toContain("hidden inside Berlin");
    });

    test("Shift-click deletes", async () => {
      const [id] = await sitesInReach(page);
      const { x, y } = await whereIs(page, id);
      await page.keyboard.down("Shift");
      await page.mouse.click(x, y);
      await page.keyboard.up("Shift");
      expect(await stateOf(page)).toMatchObject({ size: before.size - 1, broken: null });
      expect(await page.evaluate((id) => app.diagram.has(id), id)).toBe(false);
    });

    test("a drag moves a circle, which keeps its id and size", async () => {
      const [id] = await sitesInReach(page);
      const from = await whereIs(page, id);
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      for (let k = 1; k <= 20; k++) await page.mouse.move(from.x + 4 * k, from.y + 2 * k);
      await page.mouse.up();
      const to = await whereIs(page, id);
      expect([to.x - from.x, to.y - from.y, to.r]).toEqual(
        [80, 40, from.r].map((n) => expect.closeTo(n, 6)),
      );
      expect(await stateOf(page)).toMatchObject({ size: before.size, selected: id, broken: null });
    });

    test("a drag of empty space moves the view, not the diagram", async () => {
      const { x, y } = await freeSpace(page);
      const [id] = await sitesInReach(page);
      const from = await whereIs(page, id);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 50, y - 30, { steps: 5 });
      await page.mouse.up();
      const to = await whereIs(page, id);
      expect([to.x - from.x, to.y - from.y]).toEqual([
        expect.closeTo(50, 6),
        expect.closeTo(-30, 6),
      ]);
      expect(await stateOf(page)).toEqual(before);
    });

    test("Alt-drag draws a circle of that size", async () => {
      const { x, y } = await freeSpace(page);
      await page.keyboard.down("Alt");
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 40, y, { steps: 4 });
      await page.mouse.up();
      await page.keyboard.up("Alt");
      const after = await stateOf(page);
      expect(after.size).toBe(before.size + 1);
      expect((await whereIs(page, after.selected)).r).toBeCloseTo(40, 6);
    });

    test("the wheel resizes over the selected circle, and zooms elsewhere", async () => {
      const [id] = await sitesInReach(page);
      const from = await whereIs(page, id);
      await page.mouse.move(from.x, from.y);
      await page.mouse.wheel(0, -100); // not selected yet: zooms about the pointer
      const zoomed = await whereIs(page, id);
      // the browser rounds the wheel's position
      expect(Math.abs(zoomed.x - from.x)).toBeLessThan(0.5);
      expect(zoomed.r / from.r).toBeCloseTo(Math.exp(0.16), 6);
      await page.waitForTimeout(300); // another gesture
      await page.mouse.click(from.x, from.y);
      const scale = await page.evaluate(() => app.view.scale);
      await page.mouse.wheel(0, -100);
      await page.mouse.wheel(0, -100);
      expect((await whereIs(page, id)).r / zoomed.r).toBeCloseTo(Math.exp(0.2), 6);
      expect(await page.evaluate(() => app.view.scale)).toBe(scale);
      expect(await stateOf(page)).toMatchObject({ size: before.size, selected: id, broken: null });
    });

    test("the handle resizes; a circle that grows hides others, and shrinks back", async () => {
      const id = await page.evaluate(() =>
        [...app.diagram.ids()].find((id) => app.scene.label(id).name === "Berlin"),
      );
      const { x, y, r } = await whereIs(page, id);
      await page.mouse.click(x, y);
      await page.mouse.move(x + r + 5, y);
      await page.mouse.down();
      await page.mouse.move(x + r + 125, y, { steps: 6 });
      expect((await whereIs(page, id)).r).toBeCloseTo(r + 120, 6);
      const grown = await stateOf(page);
      expect(grown).toMatchObject({ size: before.size, broken: null });
      expect(grown.hidden).toBeGreaterThan(before.hidden + 3);
      await page.mouse.move(x + r + 5, y, { steps: 6 });
      await page.mouse.up();
      expect(await stateOf(page)).toMatchObject({ visible: before.visible, hidden: before.hidden });
    });

    test("moving highlights the nearest site and its neighbours, as brute force does", async () => {
      for (let k = 0; k < 30; k++) {
        await page.mouse.move(320 + ((k * 97) % 900), 30 + ((k * 61) % 740));
        const { hover, nearest, neighbors } = await page.evaluate(() => {
          const { x, y, id, distance } = app.hover;
          const px = app.view.toWorldX(x);
          const py = app.view.toWorldY(y);
          const nearest = { id: -1, distance: Infinity };
          for (const other of app.diagram.ids()) {
            const site = app.diagram.site(other);
            const d = Math.hypot(px - site.x, py - site.y) - site.r;
            if (d < nearest.distance) Object.assign(nearest, { id: other, distance: d });
          }
          return { hover: { id, distance }, nearest, neighbors: [...app.hover.neighbors] };
        });
        expect(hover.id).toBe(nearest.id);
        expect(hover.distance).toBeCloseTo(nearest.distance, 6);
        expect(neighbors.length).toBeGreaterThan(0);
        expect(neighbors).not.toContain(hover.id);
      }
      await settled(page);
      const label = await page.evaluate(() => app.scene.label(app.hover.id).name);
      expect(await page.textContent("#nearest-name")).toBe(label);
      expect(await painted(page, "overlay")).toBeGreaterThan(500);
      await page.mouse.move(100, 300); // onto the panel
      expect(await page.evaluate(() => app.hover)).toBeNull();
    });
  });

  describe("touch", () => {
    test("a tap inserts or selects, a drag moves, two fingers zoom", async () => {
      const phone = await open({ viewport: { width: 800, height: 900 }, hasTouch: true });
      const { x, y } = await freeSpace(phone);
      await phone.touchscreen.tap(x, y);
      const inserted = await stateOf(phone);
      expect(inserted.size).toBe(1501);
      const id = inserted.selected;

      const touch = await phone.context().newCDPSession(phone);
      const send = (type, ...points) =>
        touch.send("Input.dispatchTouchEvent", {
          type,
          touchPoints: points.map(([px, py], k) => ({ x: px, y: py, id: k })),
        });
      await send("touchStart", [x, y]);
      for (let k = 1; k <= 10; k++) await send("touchMove", [x - 3 * k, y + 2 * k]);
      await send("touchEnd");
      const moved = await whereIs(phone, id);
      expect([moved.x - x, moved.y - y]).toEqual([expect.closeTo(-30, 6), expect.closeTo(20, 6)]);

      const scale = await phone.evaluate(() => app.view.scale);
      await send("touchStart", [400, 400]);
      await send("touchStart", [400, 400], [500, 400]);
      await send("touchMove", [380, 400], [520, 400]);
      await send("touchMove", [350, 400], [550, 400]);
      await send("touchEnd");
      expect((await phone.evaluate(() => app.view.scale)) / scale).toBeGreaterThan(1.3);
      expect(await stateOf(phone)).toMatchObject({ size: 1501, broken: null });
      await phone.tap("#card-delete");
      expect(await stateOf(phone)).toMatchObject({ size: 1500, broken: null });
      expect(phone.errors).toEqual([]);
      await phone.context().close();
    });
  });

  describe("keyboard", () => {
    test("keys: Enter selects, arrows move, + and - resize, N walks, I inserts", async () => {
      const { x, y } = await freeSpace(page);
      await page.mouse.move(x, y);
      await page.focus("#overlay");
      await page.keyboard.press("Enter");
      const { selected: id } = await stateOf(page);
      expect(id).toBe(await page.evaluate(() => app.hover.id));
      const from = await whereIs(page, id);
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("Shift+ArrowUp");
      await page.keyboard.press("+");
      const to = await whereIs(page, id);
      expect([to.x - from.x, to.y - from.y]).toEqual([
        expect.closeTo(4, 6),
        expect.closeTo(-40, 6),
      ]);
      expect(to.r / from.r).toBeCloseTo(1.05, 6);
      await page.keyboard.press("-");
      expect((await whereIs(page, id)).r).toBeCloseTo(from.r, 6);
      const neighbors = await page.evaluate((id) => [...app.diagram.neighbors(id)], id);
      await page.keyboard.press("n");
      expect(neighbors).toContain((await stateOf(page)).selected);
      await page.keyboard.press("Delete");
      expect(await stateOf(page)).toMatchObject({
        size: before.size - 1,
        selected: -1,
        broken: null,
      });
      await page.keyboard.press("i");
      expect(await stateOf(page)).toMatchObject({ size: before.size, broken: null });
      await page.keyboard.press("Escape");
      expect((await stateOf(page)).selected).toBe(-1);
    });
  });

  describe("buttons", () => {
    test.each([
      ["100", 0],
      ["1000", 20],
      ["10000", 50],
    ])("%s random circles, %i %% hidden", async (count, share) => {
      await page.fill("#share", String(share));
      await page.click(`[data-count="${count}"]`);
      const hidden = (Number(count) * share) / 100;
      expect(await stateOf(page)).toEqual({
        size: Number(count),
        visible: Number(count) - hidden,
        hidden,
        selected: -1,
        broken: null,
      });
      await settled(page);
      expect(await painted(page, "base")).toBeGreaterThan(20_000);
      expect(await page.isVisible("#credit")).toBe(false);
    });

    test("Clear empties; a click inserts again; Cities brings them back", async () => {
      await page.click("#clear");
      expect(await stateOf(page)).toMatchObject({ size: 0, broken: null });
      await page.mouse.move(700, 400);
      await settled(page);
      expect(await painted(page, "base")).toBe(0);
      for (const [x, y] of [
        [700, 400],
        [800, 400],
        [900, 400],
        [800, 500],
      ]) {
        await page.mouse.click(x, y);
        await settled(page);
        expect((await stateOf(page)).broken).toBeNull();
      }
      expect(await stateOf(page)).toMatchObject({ size: 4, visible: 4 });
      for (let left = 3; left >= 0; left--) {
        await page.evaluate(() => app.select(app.diagram.ids()[0]));
        await page.focus("#overlay");
        await page.keyboard.press("Delete");
        expect(await stateOf(page)).toMatchObject({ size: left, broken: null });
      }
      await page.click("#set-cities");
      expect(await stateOf(page)).toMatchObject({ size: 1500, broken: null });
    });

    test("hidden sites are shown in their own colour, and only while their layer is", async () => {
      await page.fill("#share", "50");
      await page.click('[data-count="100"]');
      const reddish = () =>
        page.evaluate(() => {
          app.painter.flush();
          const canvas = app.painter.canvases.base;
          const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
          let count = 0;
          for (let k = 0; k < data.length; k += 4)
            if (data[k + 3] > 100 && data[k] > data[k + 2] + 60) count++;
          return count;
        });
      expect(await reddish()).toBeGreaterThan(500);
      await page.uncheck("[name=hidden]");
      expect(await reddish()).toBe(0);
    });

    test.each(["circles", "cells", "dual"])("the layer %s can be switched", async (layer) => {
      await page.click('[data-count="100"]');
      const on = () =>
        page.evaluate(() => void app.painter.flush()).then(() => painted(page, "base"));
      await page.setChecked(`[name=${layer}]`, true);
      const withLayer = await on();
      await page.setChecked(`[name=${layer}]`, false);
      expect(await on()).toBeLessThan(withLayer - 1000);
    });
  });
});
