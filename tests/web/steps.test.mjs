// Figures that are told in steps follow the reader's paragraph; and the figures of the pages on
// insertion, deletion and exactness confirm the pages' claims.
import { describe, expect, test } from "@jest/globals";
import { closePage, describeInBrowser, frames } from "./support/browser.mjs";

const kPhone = { viewport: { width: 390, height: 780 } };

/** Scrolls to a figure, and waits until it runs. */
async function started(page, name) {
  await page.locator(`#${name} .stage`).scrollIntoViewIfNeeded();
  await page.locator(`#${name}[data-state=running]`).waitFor({ state: "attached" });
}

/** The marked paragraph and the figure's step. */
const stepOf = (page, name) =>
  page.evaluate(
    (figure) => [
      Number(document.querySelector(".steps [aria-current]").dataset.step),
      figures.get(figure).state.step,
    ],
    name,
  );

describeInBrowser("steps", (open) => {
  describe.each([
    ["desktop", {}],
    ["phone", kPhone],
  ])("%s", (_, kind) => {
    test.each(["insertion", "deletion"])("the figure of %s follows the paragraphs", async (key) => {
      const name = `${key}_steps`;
      const page = await open({ path: `${key}/`, ready: "figures", ...kind });
      await started(page, name);
      for (const step of [1, 2, 3, 4, 2, 0]) {
        await page.evaluate((k) => {
          const paragraph = document.querySelector(`[data-step="${k}"]`);
          paragraph.scrollIntoView({ block: "center", behavior: "instant" });
          // On a phone the paragraph that is read is below the figure.
          if (innerWidth < 1000) scrollBy({ top: -0.22 * innerHeight, behavior: "instant" });
        }, step);
        await page.waitForFunction(
          ([figure, k]) => figures.get(figure).state.step === k,
          [name, step],
        );
        expect(await stepOf(page, name)).toEqual([step, step]);
        // The picture stays in view, below the bar.
        const [bar, stage] = await page.evaluate(() =>
          [".bar", ".steps .stage"].map((s) => document.querySelector(s).getBoundingClientRect()),
        );
        if (step < 4) expect(stage.top).toBeGreaterThanOrEqual(bar.bottom - 1);
      }
      expect(page.errors).toEqual([]);
      await closePage(page);
    });
  });

  test("a step that is chosen marks its paragraph", async () => {
    const page = await open({ path: "insertion/", ready: "figures" });
    await started(page, "insertion_steps");
    const choice = page.locator("#insertion_steps").getByLabel("Star");
    await choice.scrollIntoViewIfNeeded();
    await frames(page, 3); // in which the figure follows the scrolling
    await choice.check();
    expect(await stepOf(page, "insertion_steps")).toEqual([4, 4]);
    await closePage(page);
  });

  test("a circle to be removed is chosen with the keyboard", async () => {
    const page = await open({ path: "deletion/", ready: "figures" });
    await started(page, "deletion_steps");
    const chosen = () => page.evaluate(() => figures.get("deletion_steps").state.chosen);
    const before = await chosen();
    await page.locator("#deletion_steps .stage").focus();
    for (let k = 0; k < 4; k++) await page.keyboard.press("Shift+ArrowRight");
    await page.keyboard.press("Enter");
    expect(await chosen()).not.toBe(before);
    await closePage(page);
  });

  test("there and back, the diagram is that which is built afresh", async () => {
    const page = await open({ path: "deletion/", ready: "figures" });
    await started(page, "undo");
    for (const place of ["200", "0"]) await page.getByLabel("Operations done").fill(place);
    const { compared, different, done } = await page.evaluate(() => figures.get("undo").state);
    expect([done, different]).toEqual([0, 0]);
    expect(compared).toBeGreaterThan(300);
    await closePage(page);
  });

  test("orders do not matter; the library's answer changes once, doubles' often", async () => {
    const page = await open({ path: "exactness/", ready: "figures" });
    await started(page, "two_orders");
    const other = page.getByRole("button", { name: "Other orders" });
    for (let k = 0; k < 12; k++) await other.click();
    const { tried, different } = await page.evaluate(() => figures.get("two_orders").state);
    expect([tried, different]).toEqual([13, 0]);
    await started(page, "tear");
    const { near, far } = await page.evaluate(() => figures.get("tear").state.answers);
    const changes = (answers, key) =>
      answers.filter((answer, k) => k > 0 && answer[key] !== answers[k - 1][key]).length;
    const contradictions = (answers) => answers.filter(({ first, second }) => first !== second);
    expect(changes(near, "exact")).toBe(1);
    expect(changes(near, "second")).toBeGreaterThan(1);
    expect(contradictions(near).length).toBeGreaterThan(0);
    expect(contradictions(far)).toEqual([]);
    expect(page.errors).toEqual([]);
    await closePage(page);
  });
});
