// Numbers that say no more than is seen.

/** To this many decimal places; negative: to tens, hundreds, … */
export function roundedTo(value: number, digits: number) {
  if (digits >= 0) return Number(value.toFixed(Math.min(digits, 100)));
  const step = 10 ** -digits;
  return Math.round(value / step) * step;
}
