// Thousands of random events, as an impatient visitor makes them: nothing may break, whatever comes
// in whatever order. Afterwards the exact check finds nothing, and all can be undone. The benchmark
// runs more of these (bench/js/page.mjs).
import { expect, test } from "@jest/globals";
import { describeInBrowser, describeInFirefox } from "./support/browser.mjs";
import { storm } from "./support/storm.mjs";

const seeds = [1, 2, 3];
const kEvents = 2000; // 5 000 in the benchmark; npm test is to end within twenty minutes

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
  test.each(seeds)("seed %i", async (seed) => {
    const page = await open({ viewport: { width: 900, height: 700 } });
    await storm(page, { seed, events: kEvents });
    expect(await soundness(page)).toEqual(kSound);
    const end = await page.evaluate(() => {
      while (app.model.history.canUndo) app.undo();
      while (app.model.history.canRedo) app.redo();
      return app.diagram.validate();
    });
    expect(end).toBeNull();
    expect(await soundness(page)).toEqual(kSound);
    expect(page.errors).toEqual([]);
    await page.context().close();
  }, 300_000);
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
