// Where events come from.

/** Whether an event comes from within such an element. */
export const isIn = (target: EventTarget | null, selector: string) =>
  target instanceof Element && target.closest(selector) !== null;
