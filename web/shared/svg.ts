// Texts and numbers in SVG.

export const escaped = (text: string) =>
  text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** With as few digits as it takes, and no more than these after the point. */
export const rounded = (value: number, digits: number) => Number(value.toFixed(digits));
