/**
 * Presses "Control+z" and the like, which Puppeteer does not know, on pages of either kind. The
 * events are sent in this order without waiting for one another.
 */
export async function press({ keyboard }, keys) {
  const parts = keys.length > 1 ? keys.split("+") : [keys];
  const events = parts.map((key) => keyboard.down(key));
  for (const key of parts.reverse()) events.push(keyboard.up(key));
  await Promise.all(events);
}
