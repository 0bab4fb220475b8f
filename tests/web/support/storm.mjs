// Random events by real mouse and keyboard, weighted as visitors use them; the same ones for the
// same seed. Pages are Playwright's or Puppeteer's.
import { isThorough } from "../../support/effort.mjs";
import { press } from "./keys.mjs";

/** The window is small, as drawing costs most of the time. */
export const kStorm = { events: isThorough ? 5000 : 300, window: { width: 720, height: 540 } };

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

/**
 * Sends events one after another without waiting for each: most wait for the next frame. But of
 * movements in one frame the browser would show the page the last one only.
 */
class Sender {
  /** @type {Promise<void>[]} */ #sent = [];
  #isFrameTaken = false;

  /** @param {() => Promise<void>} send */
  now(send) {
    this.#isFrameTaken = false; // movements before it are shown at once
    this.#sent.push(send());
  }

  /** @param {() => Promise<void>} send */
  async inNextFrame(send) {
    if (this.#isFrameTaken) await this.arrived();
    this.#isFrameTaken = true;
    this.#sent.push(send());
  }

  async arrived() {
    await Promise.all(this.#sent.splice(0));
    this.#isFrameTaken = false;
  }
}

/** @param {{ seed: number, events: number }} options */
export async function storm(page, { seed, events }) {
  // Not imported earlier, as the server of the page builds it.
  const { generator } = await import("../../../build/web/shared/random_sets.js");
  const random = generator(seed);
  const below = (n) => Math.floor(n * random());
  const { width, height } = await page.evaluate(() => app.view);
  const sender = new Sender();
  /** The page itself is asked to do something, which comes another way than events. */
  const call = async (run, given) => {
    await sender.arrived();
    await page.evaluate(run, given);
  };
  let isDown = false;
  await page.evaluate(() => document.getElementById("overlay").focus());
  for (let k = 0; k < events; k++) {
    const kind = random();
    if (kind < 0.55) {
      const [x, y] = [below(width), 60 + below(height - 150)];
      await sender.inNextFrame(() => page.mouse.move(x, y));
    } else if (kind < 0.75) {
      sender.now(() => (isDown ? page.mouse.up() : page.mouse.down()));
      isDown = !isDown;
    } else if (kind < 0.93) {
      const keys = kKeys[below(kKeys.length)];
      sender.now(() => press(page, keys));
    } else if (kind < 0.96) {
      const deltaY = below(240) - 120;
      await sender.inNextFrame(() => wheel(page, deltaY));
    } else if (kind < 0.97)
      await call((key) => app.navigation.load(key), kSets[below(kSets.length)]);
    else if (kind < 0.98) await call(() => app.edits.clear());
    else await call(() => app.camera.fit());
    // Few circles stay sound trivially, many are slow to check.
    if (k % 500 === 499) await call(() => app.navigation.load("opening"));
  }
  await sender.arrived();
  if (isDown) await page.mouse.up();
}

/** Playwright's takes numbers, Puppeteer's an object. */
const wheel = (page, deltaY) =>
  page.mouse.wheel.length > 1 ? page.mouse.wheel(0, deltaY) : page.mouse.wheel({ deltaY });

/** Says what is wrong with the diagram, with the page's copy of it, and with the selection. */
export const soundness = (page) =>
  page.evaluate(() => {
    const broken = app.parts.validate(app.diagram);
    const mirror = Array.from(app.diagram.ids()).filter((id) => {
      const a = app.diagram.site(id);
      const b = app.sites.site(id);
      return a.x !== b.x || a.y !== b.y || a.r !== b.r;
    });
    const gone = app.selection.ids.filter((id) => !app.diagram.has(id));
    return { broken, mirror, gone };
  });

export const kSound = { broken: null, mirror: [], gone: [] };
