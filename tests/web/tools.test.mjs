// The registry of tools: each tool has its button, its key and its part of the help.
import { expect, test } from "@jest/globals";
import { describeInBrowser, forEachPage } from "./support/browser.mjs";

describeInBrowser("tools", (open) => {
  let page;
  let tools;
  forEachPage(open, async (opened) => {
    page = opened;
    tools = await page.evaluate(() =>
      app.parts.kTools.map(({ id, key, label, help }) => ({ id, key, label, help })),
    );
  });

  const pressed = () =>
    page.$$eval("#tools [aria-pressed=true]", (buttons) => buttons.map(({ id }) => id));

  test("each has a button, in this order, with its name and key", async () => {
    const buttons = await page.$$eval("#tools [aria-pressed]", (found) =>
      found.map((button) => ({
        id: button.id.replace("tool-", ""),
        label: button.querySelector("span").textContent,
        key: button.getAttribute("aria-keyshortcuts").toLowerCase(),
        hint: button.querySelector("kbd").textContent.toLowerCase(),
        isDrawn: button.querySelector("svg").children.length > 0,
      })),
    );
    expect(buttons).toEqual(
      tools.map(({ id, label, key }) => ({ id, label, key, hint: key, isDrawn: true })),
    );
    expect(tools.map(({ id }) => id)).toEqual(["select", "draw", "pan", "delete"]);
  });

  test("its key and its button choose it; no two share a key, or one in use", async () => {
    for (const act of [
      ({ key }) => page.keyboard.press(key),
      ({ id }) => page.click(`#tool-${id}`),
    ]) {
      for (const tool of tools) {
        await act(tool);
        expect(await page.evaluate(() => app.tool)).toBe(tool.id);
        expect(await pressed()).toEqual([`tool-${tool.id}`]);
      }
    }
    const keys = tools.map(({ key }) => key);
    expect(new Set([...keys, ..."0inp+-=_[]"]).size).toBe(keys.length + 10);
    expect(keys.every((key) => /^[a-z]$/.test(key))).toBe(true);
  });

  test("the help has what they say of their gestures", async () => {
    for (const kind of ["fine", "coarse"]) {
      const said = tools.flatMap(({ help }) => help?.[kind] ?? []).join(" ");
      expect(said.length).toBeGreaterThan(100);
      expect(await page.textContent(`#help-${kind}`)).toBe(said.replaceAll("*", ""));
      const bold = await page.$$eval(`#help-${kind} b`, (parts) =>
        parts.map((part) => part.textContent),
      );
      expect(bold).toEqual([...said.matchAll(/\*(.*?)\*/g)].map(([, part]) => part));
    }
  });
});
