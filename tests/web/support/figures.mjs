// The ways in which readers use the figures of the site, with either driver: pages are Playwright's
// (Chromium) or Puppeteer's (Firefox), which differ here only in touches. Each question to Firefox
// can take 40 ms, so there are few of them.
import { kHangs } from "./browser.mjs";
import { press } from "./keys.mjs";

/** Puts a finger down at the first point, moves it to the others, and lifts it. */
export async function touchInChromium(page, [from, ...others]) {
  const devtools = await page.context().newCDPSession(page);
  const send = (type, ...touchPoints) =>
    devtools.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("touchStart", from);
  for (const point of others) await send("touchMove", point);
  await send("touchEnd");
  await devtools.detach();
}

/**
 * As touchInChromium. Its events come from the browser, as a mouse's do, but Firefox does not
 * scroll by them: only Chromium shows that a page does not scroll when a figure is touched.
 */
export async function touchInFirefox(page, [from, ...others]) {
  const finger = await page.touchscreen.touchStart(from.x, from.y);
  for (const { x, y } of others) await finger.move(x, y);
  await finger.end();
}

const times = (page, count, keys) =>
  Promise.all(Array.from({ length: count }, () => press(page, keys)));

const click = (page, { x, y }) => page.mouse.click(x, y);

/** The ways to use a figure by mouse and keyboard: the part of the figure, and the action. */
const kUses = [
  {
    name: "drag",
    part: ".handle",
    async act({ mouse }, { x, y }) {
      await mouse.move(x, y);
      await mouse.down();
      await mouse.move(x + 25, y + 15, { steps: 4 });
      await mouse.up();
    },
  },
  {
    name: "arrow on a handle",
    part: ".handle",
    isFocused: true,
    act: (page) => times(page, 3, "Shift+ArrowLeft"),
  },
  {
    name: "arrow at the pointer",
    part: ".stage[tabindex]",
    isFocused: true,
    async act(page) {
      await times(page, 3, "Shift+ArrowRight");
      await press(page, "Enter");
    },
  },
  {
    name: "arrow on a slider",
    part: ".slider input",
    isFocused: true,
    act: (page, { isLow }) => times(page, 4, isLow ? "ArrowRight" : "ArrowLeft"), // has room there
  },
  { name: "choice", part: ".choice input:not(:checked)", act: click },
  { name: "switch", part: ".switch input", act: click },
  { name: "button", part: ".controls button:not(.reset):not(:disabled)", act: click },
];

export const figuresOf = (page) =>
  page.$$eval("[data-figure]", (figures) => figures.map(({ dataset }) => dataset.figure));

/** Scrolls to a figure; when it runs, resolves to which of these parts it has. */
export const reach = (page, name, parts = []) =>
  page.$eval(
    `[data-figure=${name}]`,
    async (figure, { parts, limit }) => {
      const until = Date.now() + limit; // a busy machine shows no frames
      while (!figure.dataset.state && Date.now() < until) {
        figure.scrollIntoView({ block: "center" }); // figures above that start now may move it
        await new Promise((resolve) => setTimeout(resolve, 20));
      }
      const { figure: name, state } = figure.dataset;
      if (state !== "running")
        throw new Error(`${name} does not run: ${state ?? "it was not started"}`);
      figure.scrollIntoView({ block: "center" });
      return parts.filter((part) => figure.querySelector(part));
    },
    { parts, limit: kHangs },
  );

/**
 * Restarts a figure and waits until it rests; keeps its text and pixels, for comparison. Resolves
 * to the position of the part that is used.
 */
const prepare = (page, name, { part, isFocused = false }) =>
  page.$eval(
    `[data-figure=${name}]`,
    async (figure, { part, isFocused }) => {
      const nextFrame = () => new Promise(requestAnimationFrame);
      const canvas = figure.querySelector("canvas");
      const context = canvas.getContext("2d");
      const seen = () => {
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        const words = new Uint32Array(data.buffer);
        let hash = 0;
        for (let k = 0; k < words.length; k++) hash = Math.imul(hash ^ words[k], 0x01000193);
        return `${hash} ${figure.querySelector(".said").textContent}`;
      };
      figure.querySelector(".reset").click();
      await nextFrame();
      const used = figure.querySelector(part);
      if (isFocused) used.focus();
      const isInside = ({ top, bottom }) => top > 100 && bottom < innerHeight;
      if (!isInside(used.getBoundingClientRect())) used.scrollIntoView({ block: "center" });
      let kept = seen();
      for (let k = 0, last = ""; k < 30 && kept !== last; k++) {
        await nextFrame();
        await nextFrame();
        last = kept;
        kept = seen();
      }
      window.hasChanged = async () => {
        for (let k = 0; k < 60; k++) {
          if (seen() !== kept) return true;
          await nextFrame();
        }
        return false;
      };
      const { x, y, width, height } = used.getBoundingClientRect();
      const isLow = 2 * used.value < +used.min + +used.max;
      return { x: x + width / 2, y: y + height / 2, isLow };
    },
    { part, isFocused },
  );

async function expectChange(page, name, use, act) {
  await act(page, await prepare(page, name, use));
  if (!(await page.evaluate(() => window.hasChanged())))
    throw new Error(`${name}: ${use.name}: nothing changes`);
}

/** Every figure of the page answers the mouse and the keyboard, in each way that it has. */
export async function tryByMouseAndKeyboard(page) {
  for (const name of await figuresOf(page)) {
    const parts = await reach(
      page,
      name,
      kUses.map(({ part }) => part),
    );
    const uses = kUses.filter(({ part }) => parts.includes(part));
    // A button is pressed where a figure has nothing else.
    for (const use of uses)
      if (use.name !== "button" || uses.length === 1) await expectChange(page, name, use, use.act);
  }
}

/** Every figure that has something to touch answers a finger. */
export async function tryByFinger(page, touch) {
  for (const name of await figuresOf(page)) {
    const [part] = await reach(page, name, [".handle", ".stage[tabindex]"]);
    if (!part) continue;
    const [dx, dy] = part === ".handle" ? [24, 14] : [40, 0];
    await expectChange(page, name, { name: "a finger", part }, (page, { x, y }) =>
      touch(
        page,
        [0, 1, 2, 3, 4].map((k) => ({ x: x + (k * dx) / 4, y: y + (k * dy) / 4 })),
      ),
    );
  }
}
