// The globe of web/examples: its answers about a place, against brute force; turning and zooming.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { expect, test } from "@jest/globals";
import { closePage, describeInBrowser, drag, frames } from "./support/browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** In, near and far from cities, on land and at sea; one near the antimeridian. */
const kPlaces = [
  [2.35, 48.9],
  [3, 47.4],
  [10, 26],
  [-28, 40],
  [24, -20],
  [-179, 5],
];

describeInBrowser("globe", (open) => {
  /** A place's position in the window, and the globe's expected answer about it, by brute force. */
  const onGlobe = (page, place) =>
    page.evaluate(([lon, lat]) => {
      const { cities, projection, above } = window.example;
      const radian = Math.PI / 180;
      const haversine = (angle) => Math.sin(angle / 2) ** 2;
      const distances = cities.map(({ place: [east, north], r }) => {
        const [a, b] = [north * radian, lat * radian];
        const h = haversine(a - b) + Math.cos(a) * Math.cos(b) * haversine((east - lon) * radian);
        return 2 * 6371.0088 * Math.asin(Math.sqrt(h)) - r;
      });
      const least = Math.min(...distances);
      const { left, top } = above.getBoundingClientRect();
      const [x, y] = projection([lon, lat]);
      return { x: left + x, y: top + y, name: cities[distances.indexOf(least)].name, least };
    }, place);
  const said = (page) => page.textContent(".globe output");
  const picked = (page) => page.evaluate(() => window.example.picked());

  /** The share of the canvas that the globe takes. */
  const drawn = (page) =>
    page.evaluate(() => {
      const { canvas } = window.example;
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((value, k) => k % 4 === 3 && value === 255).length / (data.length / 4);
    });

  test("names the nearest city of a place, and how far it is, in the open and inside", async () => {
    const page = await open({ path: "examples/globe.html", ready: "example" });
    for (const place of kPlaces) {
      if (place[0] === -179) {
        await page.evaluate(() => {
          window.example.projection.rotate([170, 0]);
          window.example.turn(0, 0);
        });
        await frames(page, 3);
      }
      const { x, y, name, least } = await onGlobe(page, place);
      await page.mouse.move(x, y);
      await page.waitForFunction(
        (name) => document.querySelector("output").textContent.startsWith(`${name}: `),
        name,
      );
      // The browser rounds where the pointer is.
      const { distance, place: at } = await picked(page);
      expect(Math.hypot(at[0] - place[0], at[1] - place[1])).toBeLessThan(1e-3);
      expect(Math.abs(distance - least)).toBeLessThan(0.1);
      const own = (at) => window.example.diagram.nearest(at[0], at[1]).distance;
      expect(await page.evaluate(own, at)).toBe(distance);
      const km = Math.round(distance);
      const where = km < 0 ? `${-km} km inside its circle` : `${km.toLocaleString("en")} km away`;
      expect(await said(page)).toBe(`${name}: ${where}`);
    }
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("is turned by the pointer and by keys, zoomed, and as large as its window", async () => {
    const page = await open({ path: "examples/globe.html", ready: "example" });
    const [middle, taken] = [await onGlobe(page, [15, 28]), await onGlobe(page, [20, 10])];
    await drag(page, middle, taken);
    // The place that was taken hold of has come along, as near as turning by two angles comes.
    const after = await onGlobe(page, [15, 28]);
    expect(Math.hypot(after.x - taken.x, after.y - taken.y)).toBeLessThan(20);
    expect(Math.hypot(middle.x - taken.x, middle.y - taken.y)).toBeGreaterThan(90);

    const rotation = () => page.evaluate(() => window.example.projection.rotate());
    const before = await rotation();
    await page.focus(".globe canvas[tabindex]");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    const [lon, lat] = await rotation();
    expect([lon - before[0], lat - before[1]].map((angle) => angle.toFixed(6))).toEqual([
      "-5.000000",
      "-5.000000",
    ]);
    // The middle is asked about.
    await frames(page, 3);
    const { name } = await onGlobe(page, [-lon, -lat]);
    expect(await said(page)).toMatch(name);

    const scale = () => page.evaluate(() => window.example.projection.scale());
    const small = await scale();
    await page.keyboard.press("+");
    await page.mouse.wheel(0, -120);
    await page.waitForFunction((least) => window.example.projection.scale() > least, 1.3 * small);
    await page.keyboard.press("-");
    await page.setViewportSize({ width: 500, height: 700 });
    await page.waitForFunction(() => window.example.canvas.width < 500);
    await frames(page, 2);
    expect(await drawn(page)).toBeGreaterThan(0.3);
    expect(await page.evaluate(() => document.documentElement.scrollHeight)).toBe(700);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run());
    expect(violations.map(({ id }) => id)).toEqual([]);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
});
