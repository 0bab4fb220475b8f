// Random events, as an impatient visitor makes them: nothing may break, whatever comes in whatever
// order. Afterwards the exact check finds nothing, and all can be undone. `npm run check -- page`
// runs more and longer ones.
import { expect, test } from "@jest/globals";
import { closePage, describeInBrowser } from "./support/browser.mjs";
import { isThorough } from "../support/effort.mjs";
import { kSound, kStorm, soundness, storm } from "./support/storm.mjs";

const seeds = isThorough ? [1, 2, 3] : [1];

describeInBrowser("storms", (open) => {
  /** All that is wrong after a storm, and after the way back to its beginning and here again. */
  async function weather(seed) {
    const page = await open({ viewport: kStorm.window, isAlone: true });
    await storm(page, { seed, events: kStorm.events });
    const after = await soundness(page);
    await page.evaluate(() => {
      while (app.model.history.canUndo) app.edits.undo();
      while (app.model.history.canRedo) app.edits.redo();
    });
    const again = await soundness(page);
    await closePage(page);
    return { seed, after, again, errors: page.errors };
  }

  // Side by side, as events mostly wait for the next frame.
  test(`seeds ${seeds}`, async () => {
    const sound = (seed) => ({ seed, after: kSound, again: kSound, errors: [] });
    expect(await Promise.all(seeds.map(weather))).toEqual(seeds.map(sound));
  });
});
