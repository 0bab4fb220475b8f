// Thousands of random events, as an impatient visitor makes them: nothing may break, whatever comes
// in whatever order. Afterwards the exact check finds nothing, and all can be undone. The benchmark
// runs more of these (bench/js/page.mjs).
import { expect, test } from "@jest/globals";
import { describeInBrowser, describeInFirefox } from "./support/browser.mjs";
import { storm } from "./support/storm.mjs";

const seeds = [1, 2, 3];
const kEvents = 3000; // 5000, and ten seeds: npm run bench -- --only page

const soundness = (page) =>
  page.evaluate(() => {
    const broken = app.diagram.validate();
    const mirror = Array.from(app.diagram.ids()).filter((id) => {
      const a = app.diagram.site(id);
      const b = app.sites.site(id);
      return a.x !== b.x || a.y !== b.y || a.r !== b.r * app.sites.weight;
    });
    const gone = app.selection.ids.filter((id) => !app.diagram.has(id));
    return { broken, mirror, gone };
  });

const kSound = { broken: null, mirror: [], gone: [] };

describeInBrowser("storms", (open) => {
  /** All that is wrong after a storm, and after the way back to its beginning and here again. */
  async function weather(seed) {
    const page = await open({ viewport: { width: 900, height: 700 } });
    await storm(page, { seed, events: kEvents });
    const after = await soundness(page);
    await page.evaluate(() => {
      while (app.model.history.canUndo) app.undo();
      while (app.model.history.canRedo) app.redo();
    });
    const again = await soundness(page);
    await page.context().close();
    return { seed, after, again, errors: page.errors };
  }

  // Side by side, as events mostly wait for the next frame.
  test(`seeds ${seeds}`, async () => {
    const sound = (seed) => ({ seed, after: kSound, again: kSound, errors: [] });
    expect(await Promise.all(seeds.map(weather))).toEqual(seeds.map(sound));
  }, 900_000);
});

describeInFirefox("storms in Firefox", (open) => {
  test("seed 4", async () => {
    const page = await open({ width: 900, height: 700 });
    await storm(page, { seed: 4, events: 1000 });
    expect(await soundness(page)).toEqual(kSound);
    expect(page.errors).toEqual([]);
    await page.close();
  }, 300_000);
});
