// Where cells end: at the coast, and at the frame in which all have the same area.
import { readFileSync } from "node:fs";
import { afterEach, beforeEach, expect, test } from "@jest/globals";
import {
  closePage,
  describeInBrowser,
  painted,
  settled,
  show,
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

  /** The number of lines in a box about a pixel. */
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
    await page.evaluate(() => app.pointer.ask({ neighbors: false }));
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
