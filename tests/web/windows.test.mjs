// Where cells end: at the coast, and at the frame in which all have the same area.
import { readFileSync } from "node:fs";
import { afterEach, beforeEach, expect, test } from "@jest/globals";
import {
  circlesOf,
  closePage,
  describeInBrowser,
  painted,
  settled,
  show,
  showCircles,
  stateOf,
  whereIs,
} from "./support/browser.mjs";

const { cities } = JSON.parse(
  readFileSync(new URL("../../web/data/cities.json", import.meta.url), "utf8"),
);
const idOf = (name) => cities.findIndex(([other]) => other === name);

describeInBrowser("the coast", (open) => {
  let page;
  beforeEach(async () => {
    page = await open({ path: "#set=cities" });
    await page.click("#open-show");
    await page.click("#layer-coast");
    await page.keyboard.press("Escape");
    await settled(page);
  });
  afterEach(async () => {
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  /** How many lines there are in a box about a pixel. */
  const linesAt = (x, y) =>
    page.evaluate(
      ([x, y]) => {
        app.painter.flush();
        const context = app.painter.canvas("lines").getContext("2d");
        const { data } = context.getImageData(x - 50, y - 50, 100, 100);
        return data.filter((value, k) => k % 4 === 3 && value > 0).length;
      },
      [x, y],
    );
  const pixelOf = (x, y) =>
    page.evaluate(([x, y]) => [app.view.toScreenX(x), app.view.toScreenY(y)], [x, y]);

  test("there are no lines in the sea, as there are without it; the address says so", async () => {
    const sea = await pixelOf(-4200, 3000); // km: in the Atlantic
    expect(await linesAt(...sea)).toBe(0);
    expect(await linesAt(...(await pixelOf(1500, 6000)))).toBeGreaterThan(200); // Europe
    await page.waitForFunction(() => location.hash.includes("show=coast"));
    await page.evaluate(() => app.setLayer("coast", false));
    expect(await linesAt(...sea)).toBeGreaterThan(50);
  });

  test("distances are those on the Earth, not those of the map", async () => {
    const { x, y } = await whereIs(page, idOf("Honolulu"));
    await page.mouse.move(x + 40, y);
    await settled(page);
    const said = Number(
      /([\d\s]+) km away/.exec(await page.textContent("#tag"))[1].replace(/\s/g, ""),
    );
    const [onEarth, onMap] = await page.evaluate((id) => {
      const { x, y, r } = app.sites.site(id);
      const at = [app.view.toWorldX(app.view.toScreenX(x) + 40), y];
      const [[lon, lat], [otherLon, otherLat]] = [[x, y], at].map((point) =>
        app.parts.equalEarth.invert(point).map((degrees) => (degrees * Math.PI) / 180),
      );
      const cosine =
        Math.sin(lat) * Math.sin(otherLat) +
        Math.cos(lat) * Math.cos(otherLat) * Math.cos(lon - otherLon);
      return [6371 * Math.acos(cosine) - r, at[0] - x - r];
    }, idOf("Honolulu"));
    expect(Math.abs(said - onEarth)).toBeLessThan(1);
    expect(Math.abs(said - onMap)).toBeGreaterThan(50);
  });

  test("a link with it opens with it, and the switch says so", async () => {
    const other = await open({ path: "#set=cities&show=coast" });
    expect(await other.isChecked("#layer-coast input")).toBe(true);
    expect(await other.evaluate(() => app.painter.ends !== null)).toBe(true);
    await show(other, "opening");
    expect(await other.evaluate(() => app.painter.ends)).toBeNull();
    await other.click("#open-show");
    expect(await other.isVisible("#layer-coast")).toBe(false);
    await closePage(other);
  });

  test("what is pointed at is lit on land only, and the card says how much that is", async () => {
    const id = idOf("Honolulu");
    const lit = async () => {
      const { x, y } = await whereIs(page, id);
      await page.mouse.move(x, y);
      await settled(page);
      return painted(page, "overlay");
    };
    await page.evaluate(() => app.ask({ neighbors: false }));
    const onLand = await lit();
    const { x, y } = await whereIs(page, id);
    await page.mouse.click(x, y);
    const area = await page.textContent("#card-facts dt:has-text('area') + dd");
    expect(Number(area.replace(/[^\d]/g, ""))).toBeGreaterThan(5_000);
    expect(Number(area.replace(/[^\d]/g, ""))).toBeLessThan(40_000); // km² of islands
    await page.keyboard.press("Escape");
    await page.evaluate(() => app.setLayer("coast", false));
    expect(await lit()).toBeGreaterThan(20 * onLand);
  });

  test("a city that is dragged takes its land along", async () => {
    const id = idOf("Tokyo");
    const area = () => page.evaluate((id) => app.painter.ends.cellArea(id), id);
    const before = await area();
    const total = () =>
      page.evaluate(() => app.painter.ends.cellAreas().reduce((a, b) => a + b, 0));
    const whole = await total();
    const { x, y } = await whereIs(page, id);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 60, y - 20, { steps: 6 });
    await page.mouse.up();
    expect(await area()).not.toBe(before);
    expect((await total()) / whole).toBeCloseTo(1, 9);
    expect((await stateOf(page)).broken).toBeNull();
  });

  test("exports end there, too", async () => {
    const found = await page.evaluate(() => {
      const { toGeoJson, toSvg } = app.parts;
      const { features } = JSON.parse(toGeoJson(app));
      const svg = new DOMParser().parseFromString(toSvg(app), "image/svg+xml");
      return {
        several: features.filter(({ geometry }) => geometry.type === "MultiPolygon").length,
        path: svg.querySelector(".cells").innerHTML.length,
        error: svg.querySelector("parsererror")?.textContent,
      };
    });
    expect(found.several).toBeGreaterThan(50);
    expect(found.path).toBeGreaterThan(10_000);
    expect(found.error).toBeUndefined();
  });
});

describeInBrowser("the same area for all", (open) => {
  let page;
  beforeEach(async () => {
    page = await open({ path: "#set=opening" });
  });
  afterEach(async () => {
    expect((await stateOf(page)).broken).toBeNull();
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  const press = async () => {
    await page.click("#open-show");
    await page.click("#same-areas");
  };
  const isOn = () => page.isChecked("#same-areas");
  const whenOn = () => page.waitForFunction(() => app.painter.frame && !app.motion.isRunning);
  /** The largest area in the frame as a share of the smallest. */
  const spread = () =>
    page.evaluate(() => {
      const areas = Array.from(app.sites.ids, (id) => app.painter.ends.cellArea(id) ?? 0);
      return Math.max(...areas) / Math.min(...areas);
    });

  test("it is one edit: undone, done again, and taken back", async () => {
    const before = await circlesOf(page);
    await press();
    await whenOn();
    expect(await isOn()).toBe(true);
    expect(await spread()).toBeLessThan(1 + 1e-5);
    expect((await stateOf(page)).hidden).toBe(0); // two were
    const after = await circlesOf(page);
    expect(after.map(([id, x, y]) => [id, x, y])).toEqual(before.map(([id, x, y]) => [id, x, y]));

    await page.keyboard.press("Control+z");
    expect(await circlesOf(page)).toEqual(before);
    expect(await isOn()).toBe(false);
    expect(await page.evaluate(() => app.painter.ends)).toBeNull();
    await page.keyboard.press("Control+y");
    expect(await circlesOf(page)).toEqual(after);
    expect(await isOn()).toBe(true);

    await press();
    expect(await circlesOf(page)).toEqual(before);
    expect(await isOn()).toBe(false);
    await page.keyboard.press("Control+z");
    expect(await isOn()).toBe(true);
  });

  test("an edit ends it: areas are no longer the same then", async () => {
    await press();
    await whenOn();
    await page.evaluate(() => app.selection.set([0]));
    await page.focus("#overlay");
    await page.keyboard.press("ArrowLeft");
    expect(await isOn()).toBe(false);
    expect(await page.evaluate(() => app.painter.frame)).toBeNull();
  });

  test("circles overlap nowhere, and radii below nothing are drawn", async () => {
    await press();
    await whenOn();
    const least = await page.evaluate(() => {
      app.painter.flush();
      const all = Array.from(app.sites.ids, (id) => app.diagram.site(id));
      const gaps = all.flatMap((a, k) =>
        all.slice(k + 1).map((b) => Math.hypot(a.x - b.x, a.y - b.y) - a.r - b.r),
      );
      return { gap: Math.min(...gaps), r: Math.min(...all.map(({ r }) => r)) };
    });
    expect(least.gap).toBeGreaterThan(-1e-9);
    expect(least.r).toBeLessThan(0);
    expect(await painted(page, "lines")).toBeGreaterThan(5000);
  });

  test("centres become circles first, and are the areas' no longer when chosen again", async () => {
    await page.check("[name=weight][value='0']");
    await press();
    await whenOn();
    expect(await page.evaluate(() => app.sites.weight)).toBe(1);
    expect(await spread()).toBeLessThan(1 + 1e-5);
    await page.check("[name=weight][value='0']");
    expect(await isOn()).toBe(false);
    await page.check("[name=weight][value='1']");
    expect(await isOn()).toBe(true);
  });

  test("how far it is is shown, and Escape gives it up", async () => {
    await show(page, "random", { n: "9000", hidden: "50" });
    const before = await page.evaluate(() => app.sites.xyr.slice());
    const undoable = await page.evaluate(() => app.model.history.canUndo);
    await press();
    await page.waitForFunction(() =>
      /^Step \d+: /.test(document.querySelector("#progress-text").textContent),
    );
    expect(await page.isVisible("#progress")).toBe(true);
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => document.querySelector("#progress").hidden);
    expect(await isOn()).toBe(false);
    expect(await page.evaluate(() => app.sites.xyr.slice())).toEqual(before);
    expect(await page.evaluate(() => app.model.history.canUndo)).toBe(undoable);
    expect(await page.isVisible("#notice")).toBe(false);
  });

  test("whoever changes a circle meanwhile stops it", async () => {
    await show(page, "random", { n: "9000", hidden: "50" });
    await press();
    await page.waitForSelector("#progress:not([hidden])");
    await page.evaluate(() => app.insertCircle({ x: 5, y: 5, r: 1 }));
    await page.waitForFunction(() => document.querySelector("#progress").hidden);
    expect(await isOn()).toBe(false);
    expect((await stateOf(page)).size).toBe(9001);
  });

  test("above 10 000 circles it is not offered, and why not is said", async () => {
    await show(page, "random", { n: "10001" });
    await page.click("#open-show");
    expect(await page.isDisabled("#same-areas")).toBe(true);
    expect(await page.textContent("#same-areas-hindrance")).toBe("For up to 10,000 circles");
    await page.keyboard.press("Escape");
    await showCircles(page, [0, 0, 10]);
    await page.click("#open-show");
    expect(await page.textContent("#same-areas-hindrance")).toBe("For two circles or more");
  });

  test.each([
    ["one centre for two", [0, 0, 20, 0, 0, 10, 100, 100, 10], "its centre is another's, too"],
    [
      "centres so close that numbers cannot divide what is around them",
      [100, 50, 5, 100 + 1e-12, 50, 5, 130, 20, 5, 20, 90, 5],
      "no radii were found: ",
    ],
  ])("what cannot be done is said, and changes nothing: %s", async (_, xyr, why) => {
    await showCircles(page, xyr);
    const before = await circlesOf(page);
    await press();
    await page.waitForSelector("#notice:not([hidden])");
    const said = await page.textContent("#notice");
    expect(said).toContain("The areas cannot be the same");
    expect(said).toContain(why);
    expect(await isOn()).toBe(false);
    expect(await circlesOf(page)).toEqual(before);
  });

  test("circles grow and shrink on the way there, as one edit", async () => {
    const moving = await open({ path: "#set=opening", reducedMotion: "no-preference" });
    const r = () => moving.evaluate(() => app.diagram.site(0).r);
    const before = await r();
    await moving.evaluate(() => {
      window.seen = [];
      app.model.addEventListener("change", () => {
        if (app.motion.isRunning) window.seen.push(app.diagram.site(0).r);
      });
    });
    await moving.click("#open-show");
    await moving.click("#same-areas");
    await moving.waitForFunction(() => app.painter.frame && !app.motion.isRunning);
    const after = await r();
    const isBetween = (value) => (value - before) * (value - after) < 0;
    expect((await moving.evaluate(() => window.seen)).some(isBetween)).toBe(true);
    expect(await moving.isChecked("#same-areas")).toBe(true);
    await moving.keyboard.press("Control+z");
    expect(await r()).toBe(before);
    expect(moving.errors).toEqual([]);
    await closePage(moving);
  });
});
