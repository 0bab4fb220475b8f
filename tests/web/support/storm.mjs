// Random events by real mouse and keyboard, weighted as visitors use them; the same ones for the
// same seed. Pages are Playwright's or Puppeteer's.
import { generator } from "../../../web/sets/random_sets.js";
import { press } from "./keys.mjs";

const kKeys = [
  ..."vdhx0nip+-".split(""),
  "ArrowLeft",
  "ArrowRight",
  "ArrowUp",
  "ArrowDown",
  "Delete",
  "Escape",
  "Enter",
  "Control+z",
  "Control+z",
  "Control+y",
  "Control+d",
  "Control+ArrowRight",
  "Shift+ArrowUp",
];
const kSets = ["opening", "nesting", "two", "gasket", "cocircular", "empty"];

/** @param {{ seed: number, events: number }} options */
export async function storm(page, { seed, events }) {
  const random = generator(seed);
  const below = (n) => Math.floor(n * random());
  const { width, height } = await page.evaluate(() => app.view);
  const place = () => [below(width), 60 + below(height - 150)];
  let isDown = false;
  await page.evaluate(() => document.getElementById("overlay").focus());
  for (let k = 0; k < events; k++) {
    const kind = random();
    if (kind < 0.55) await page.mouse.move(...place());
    else if (kind < 0.75) {
      await (isDown ? page.mouse.up() : page.mouse.down());
      isDown = !isDown;
    } else if (kind < 0.93) await press(page, kKeys[below(kKeys.length)]);
    else if (kind < 0.96) await wheel(page, below(240) - 120);
    else if (kind < 0.97) {
      const key = kSets[below(kSets.length)];
      await page.evaluate((key) => app.navigation.load(key), key);
    } else if (kind < 0.98) await page.evaluate(() => app.clear());
    else if (kind < 0.99) await page.evaluate(() => app.fit());
    else await page.evaluate((weight) => app.weights.go(weight), below(2));
    // Few circles stay sound trivially, many are slow to check.
    if (k % 500 === 499) await page.evaluate(() => app.navigation.load("opening"));
  }
  if (isDown) await page.mouse.up();
  await page.evaluate(() => app.weights.go(1, { isAtOnce: true }));
}

/** Playwright's takes numbers, Puppeteer's an object. */
const wheel = (page, deltaY) =>
  page.mouse.wheel.length > 1 ? page.mouse.wheel(0, deltaY) : page.mouse.wheel({ deltaY });
