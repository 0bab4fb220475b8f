// Answers of figures on the pages "Home", "Hidden circles", "Asking" and "Regions and the globe",
// against brute force in the page.
import { expect, test } from "@jest/globals";
import { closePage, describeInBrowser, drag } from "./support/browser.mjs";

const paths = { twins: "./", cover: "hidden/", ask: "asking/", flood: "asking/" };
const path = (name) => paths[name] ?? "regions/";

describeInBrowser("answers of figures", (open) => {
  /** A page with a figure that runs, and parts of it. */
  async function figure(name) {
    const page = await open({ path: path(name), ready: "figures" });
    const whole = page.locator(`#${name}`);
    await whole.scrollIntoViewIfNeeded();
    await page.waitForFunction((name) => window.figures.has(name), name);
    const text = async (selector) => {
      await page.evaluate(() => new Promise(requestAnimationFrame));
      return (await whole.locator(selector).textContent()).replaceAll("\u202f", "");
    };
    const state = (read) =>
      page.evaluate(
        ([name, read]) => new Function("state", `return (${read})(state)`)(figures.get(name).state),
        [name, String(read)],
      );
    return { page, whole, text, state };
  }

  test("twins: the smallest bubble under the pointer is right; shares are of bubbles", async () => {
    const { page, whole, text, state } = await figure("twins");
    const stage = await whole.locator(".stage").boundingBox();
    const bubbles = await state(({ circles }) => Array.from(circles, ({ x, y, r }) => [x, y, r]));
    const inside = ([x, y, r], px, py) => Math.hypot(px - x, py - y) <= r;
    const pick = (px, py) => {
      const under = bubbles.filter((bubble) => inside(bubble, px, py));
      if (under.length > 0) return bubbles.indexOf(under.sort((a, b) => a[2] - b[2])[0]);
      const distances = bubbles.map(([x, y, r]) => Math.hypot(px - x, py - y) - r);
      return distances.indexOf(Math.min(...distances));
    };
    const centre = (px, py) => {
      const distances = bubbles.map(([x, y]) => Math.hypot(px - x, py - y));
      return distances.indexOf(Math.min(...distances));
    };
    const [title, width] = [26, 740];
    const unit = stage.width / width;
    // A small bubble lies on the rim of the large one.
    for (let x = 66; x <= 78; x += 3)
      for (let y = 190; y <= 202; y += 3) {
        await page.mouse.move(stage.x + x * unit, stage.y + (y + title) * unit);
        await page.evaluate(() => new Promise(requestAnimationFrame));
        const [px, py] = await state(({ at }) => at);
        expect(Math.hypot(px - x, py - y)).toBeLessThan(1.5);
        const isWrong = /^Nearest centre picks the wrong/.test(await text(".said"));
        expect([px, py, isWrong]).toEqual([px, py, centre(px, py) !== pick(px, py)]);
      }
    const counts = { inside: 0, insideWrong: 0, all: 0, wrong: 0 };
    for (let x = 1.5; x < 360; x += 3)
      for (let y = 1.5; y < 360; y += 3) {
        const right = pick(x, y);
        const isWrong = right !== centre(x, y);
        counts.all++;
        if (isWrong) counts.wrong++;
        if (!inside(bubbles[right], x, y)) continue;
        counts.inside++;
        if (isWrong) counts.insideWrong++;
      }
    const percents = (await text(".said")).match(/\d+(?= ?%)/g).map(Number);
    expect(percents).toEqual([
      Math.round((100 * counts.insideWrong) / counts.inside),
      Math.round((100 * counts.wrong) / counts.all),
    ]);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("cover: what is hidden, and on how many levels", async () => {
    const { page, whole, text, state } = await figure("cover");
    const brute = () =>
      state(({ circles, hasCover, diagram }) => {
        const all = circles.filter((_, id) => hasCover || diagram.has(id));
        const covers = (a, b) => a !== b && Math.hypot(a.x - b.x, a.y - b.y) <= a.r - b.r;
        const deep = (b) => Math.max(0, ...all.filter((a) => covers(a, b)).map((a) => 1 + deep(a)));
        const levels = all.map(deep);
        return [levels.filter((level) => level > 0).length, Math.max(...levels)];
      });
    const said = async () => (await text(".said")).match(/\d+/g).map(Number);
    const expectBrute = async () => {
      const [hidden, levels] = await brute();
      const [first, , third] = await said();
      expect([first, third]).toEqual([hidden, levels]);
    };
    await expectBrute();
    const cover = whole.locator(".handle").first();
    await cover.focus();
    for (let k = 0; k < 6; k++) {
      await page.keyboard.press("Shift+ArrowRight");
      await expectBrute();
    }
    await whole.getByRole("button", { name: "Take the cover away" }).click();
    await expectBrute();
    expect(page.errors).toEqual([]);
    await closePage(page);
  });

  test("ask: the line of code is the call with its answer", async () => {
    const { page, whole, text, state } = await figure("ask");
    const sorted = () =>
      state(({ circles, at }) =>
        circles
          .map(([x, y, r], id) => ({ id, r, distance: Math.hypot(x - at[0], y - at[1]) - r }))
          .sort((a, b) => a.distance - b.distance),
      );
    const answer = async () => JSON.parse((await text(".live-code")).split("//")[1]);
    const slider = whole.locator(".slider:visible");
    for (const steps of [0, 7, 9]) {
      await whole.locator(".stage").focus();
      for (let k = 0; k < steps; k++) await page.keyboard.press("Shift+ArrowRight");
      const near = await sorted();
      const ids = (some) => some.map(({ id }) => id);
      const inside = near.filter(({ distance }) => distance <= 0).sort((a, b) => a.r - b.r);
      const wanted = {
        find: near[0].id,
        pick: (inside[0] ?? near[0]).id,
        within: ids(near.filter(({ distance }) => distance <= 40)),
        kNearest: ids(near.slice(0, 5)),
      };
      for (const [call, expected] of Object.entries(wanted)) {
        await whole.locator(`input[value=${call}]`).check({ force: true });
        expect([call, await answer()]).toEqual([call, expected]);
        expect(await slider.count()).toBe(call === "within" || call === "kNearest" ? 1 : 0);
      }
    }
    await closePage(page);
  });

  test("flood: as many questions as pixels, and the nearest circle of each", async () => {
    const { page, text, state } = await figure("flood");
    const wrong = await state(({ pixels, ids, xyr }) => {
      let count = 0;
      for (let k = 0; k < ids.length; k += 997) {
        const distance = (id) =>
          Math.hypot(pixels[2 * k] - xyr[3 * id], pixels[2 * k + 1] - xyr[3 * id + 1]) -
          xyr[3 * id + 2];
        for (let id = 0; id < xyr.length / 3; id++)
          if (distance(id) < distance(ids[k]) - 1e-9) count++;
      }
      return count;
    });
    expect(wrong).toBe(0);
    const count = await state(({ ids }) => ids.length);
    expect(await text(".said")).toMatch(new RegExp(`^${count} questions in [\\d.]+ ms`));
    await closePage(page);
  });

  test("draw_region: the sum of the areas; a window without an inside is refused", async () => {
    const { page, whole, text, state } = await figure("draw_region");
    const shoelace = () =>
      state(({ coast, lake }) => {
        const area = (ring) =>
          ring.reduce((sum, [x, y], k) => {
            const [nextX, nextY] = ring[(k + 1) % ring.length];
            return sum + (x * nextY - nextX * y) / 2;
          }, 0);
        return Math.abs(area(coast)) - Math.abs(area(lake));
      });
    const shown = async () => Number((await text(".live-code")).split("//")[1]);
    const corner = whole.getByLabel("Coast: corner 1 of");
    for (let k = 0; k < 3; k++) {
      expect(await shown()).toBeCloseTo(await shoelace(), 6);
      await corner.focus();
      await page.keyboard.press("Shift+ArrowRight");
    }
    await whole.locator("input[value=flat]").check({ force: true });
    expect(await text(".said")).toMatch(/^Refused: the region has no area/);
    await corner.focus();
    await page.keyboard.press("ArrowDown");
    expect(await text(".said")).toMatch(/cells? fills? the window/);
    await closePage(page);
  });

  test("globe: the nearest city by great circles, wherever it is turned", async () => {
    const { page, whole, text, state } = await figure("globe");
    const brute = () =>
      state(({ projection, diagram }) => {
        const [lon, lat] = projection.invert(projection.translate());
        const radian = Math.PI / 180;
        const haversine = (angle) => Math.sin(angle / 2) ** 2;
        const all = [...diagram].map(({ lon: east, lat: north, r }) => {
          const [a, b] = [north * radian, lat * radian];
          const h = haversine(a - b) + Math.cos(a) * Math.cos(b) * haversine((east - lon) * radian);
          const whole = 2 * 6371.0088 * Math.asin(Math.sqrt(h));
          return { whole, distance: whole - r };
        });
        return Math.round(all.sort((a, b) => a.distance - b.distance)[0].whole);
      });
    const expectBrute = async () =>
      expect(await text(".said")).toContain(`${await brute()} km away`);
    await expectBrute();
    const { x, y, width, height } = await whole.locator(".stage").boundingBox();
    const before = await state(({ projection }) => projection.rotate());
    const middle = { x: x + width / 2, y: y + height / 2 };
    await drag(page, middle, { x: middle.x - 120, y: middle.y - 40 });
    await page.mouse.move(x + 5, y + 5); // beside the globe: the middle asks
    expect(await state(({ projection }) => projection.rotate())).not.toEqual(before);
    await expectBrute();
    await whole.locator(".stage").focus();
    for (let k = 0; k < 8; k++) {
      await page.keyboard.press("Shift+ArrowRight");
      await expectBrute();
    }
    await closePage(page);
  });
});
