// Where events come from.

/** Whether an event comes from within such an element. */
export const isIn = (target: EventTarget | null, selector: string) =>
  target instanceof Element && target.closest(selector) !== null;

const kNoText = new Set(["checkbox", "radio", "button", "submit", "file"]);

/** Whether keys write there: what they mean is the field's. */
export function isTextField(target: EventTarget | null) {
  if (target instanceof HTMLInputElement) return !kNoText.has(target.type);
  return isIn(target, "select, textarea");
}
