/** Presses "Control+z" and the like, which Puppeteer does not know, on pages of either kind. */
export async function press(page, keys) {
  const parts = keys.length > 1 ? keys.split("+") : [keys];
  for (const key of parts.slice(0, -1)) await page.keyboard.down(key);
  await page.keyboard.press(parts.at(-1));
  for (const key of parts.slice(0, -1).reverse()) await page.keyboard.up(key);
}
