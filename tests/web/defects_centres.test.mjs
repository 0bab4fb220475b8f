// What once misled in the state Centres, where circles shrank to dots and nothing looked wrong.
// Each of these failed before it was mended.
import { expect, test } from "@jest/globals";
import {
  describeInBrowser,
  drag,
  forEachPage,
  settled,
  show,
  whereIs,
} from "./support/browser.mjs";

describeInBrowser("centres", (open) => {
  let page;
  forEachPage(open, async (opened) => {
    page = opened;
    await page.check("[name=weight][value='0']", { force: true });
    await page.waitForFunction(() => app.sites.weight === 0);
    await settled(page);
  });

  /** Alphas of the canvas of circles at angles around a circle, at a share of its radius. */
  const alphasAround = (id, share) =>
    page.evaluate(
      ([id, share]) => {
        app.painter.flush();
        const context = app.painter.canvas("circles").getContext("2d");
        const { x, y, r } = app.sites.site(id);
        return [0.3, 1.7, 2.9, 4.4].map((angle) => {
          const px = app.view.toScreenX(x) + share * r * app.view.scale * Math.cos(angle);
          const py = app.view.toScreenY(y) + share * r * app.view.scale * Math.sin(angle);
          const { data } = context.getImageData(Math.round(px) - 1, Math.round(py) - 1, 3, 3);
          return Math.max(...data.filter((_, k) => k % 4 === 3));
        });
      },
      [id, share],
    );

  test("the circles' outlines stay at their radii, without a fill", async () => {
    for (const alpha of await alphasAround(3, 1)) expect(alpha).toBeGreaterThan(150);
    for (const alpha of await alphasAround(5, 0.5)) expect(alpha).toBe(0);
  });

  test("what is picked is the nearest centre's, and what is wrong is said so", async () => {
    const at = await page.evaluate(() => {
      const places = [];
      for (let x = 300; x < 1000; x += 15)
        for (let y = 180; y < 680; y += 15) {
          const [wx, wy] = [app.view.toWorldX(x), app.view.toWorldY(y)];
          const nearest = (weight) =>
            Array.from(app.sites.ids)
              .map((id) => ({ id, ...app.sites.site(id) }))
              .map((site) => [Math.hypot(site.x - wx, site.y - wy) - weight * site.r, site.id])
              .sort((a, b) => a[0] - b[0])[0][1];
          places.push({ x, y, picked: nearest(0), right: nearest(1) });
        }
      return places;
    });
    const hovered = await page.evaluate(
      (at) =>
        at.map(({ x, y }) => {
          app.hoverAt({ x, y });
          return { x, y, picked: app.hover.id, right: app.hover.right };
        }),
      at,
    );
    expect(hovered).toEqual(at);
    const wrong = at.find(({ picked, right }) => picked !== right);
    await page.evaluate(({ x, y }) => app.hoverAt({ x, y }), wrong);
    await settled(page);
    expect(await page.textContent("#tag")).toMatch(/wrong: Circle \d+ is nearer/);
    expect(await page.getAttribute("#tag", "class")).toContain("wrong");
  });

  test("a circle is dragged by all of its disc, and resized by its handle", async () => {
    const { x, y, r } = await page.evaluate(() => {
      const site = app.sites.site(5);
      const { view } = app;
      return { x: view.toScreenX(site.x), y: view.toScreenY(site.y), r: site.r * view.scale };
    });
    await drag(page, { x: x - 0.7 * r, y }, { x: x - 0.7 * r + 40, y });
    expect((await whereIs(page, 5)).x).toBeCloseTo(x + 40, 0);
    await drag(page, { x: x + 40 + r + 5, y }, { x: x + 40 + r + 25, y });
    const after = await page.evaluate(() => app.sites.site(5).r * app.view.scale);
    expect(after).toBeCloseTo(r + 20, 0);
  });

  test("headline and sentence are true in each state, and say how much is wrong", async () => {
    const headline = async () => (await page.textContent(".headline")).replace(/\s+/g, " ").trim();
    expect(await headline()).toBe("The nearest centre, not the nearest circle");
    await page.waitForFunction(() => /\d %/.test(document.getElementById("verdict").textContent));
    const said = Number((await page.textContent("#verdict")).match(/on (\d+) %/)[1]);
    const counted = await page.evaluate(() => {
      let wrong = 0;
      let all = 0;
      for (let x = 3; x < innerWidth; x += 11)
        for (let y = 3; y < innerHeight; y += 11) {
          app.hoverAt({ x, y });
          wrong += app.hover.id !== app.hover.right;
          all++;
        }
      return (100 * wrong) / all;
    });
    expect(Math.abs(counted - said)).toBeLessThan(1.5);
    await show(page, "equal");
    await page.waitForFunction(() => /0 %/.test(document.getElementById("verdict").textContent));
    await page.check("[name=weight][value='1']", { force: true });
    expect(await headline()).toBe("The nearest circle, not the nearest centre");
    expect(await page.isVisible("#verdict")).toBe(false);
    expect(await page.isVisible("#about")).toBe(true);
  });
});
