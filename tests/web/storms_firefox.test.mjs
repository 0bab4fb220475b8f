// A storm in Firefox (see storms.test.mjs), in a file of its own: it takes as long as three others.
import { expect, test } from "@jest/globals";
import { closePage, describeInFirefox } from "./support/browser.mjs";
import { kSound, kStorm, soundness, storm } from "./support/storm.mjs";

describeInFirefox("storms in Firefox", (open) => {
  test("seed 4", async () => {
    const page = await open(kStorm.window);
    await storm(page, { seed: 4, events: kStorm.events });
    expect(await soundness(page)).toEqual(kSound);
    expect(page.errors).toEqual([]);
    await closePage(page);
  }, 900_000);
});
