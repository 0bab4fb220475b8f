// An Apollonian gasket: circles that touch three others each, by Descartes' theorem. A circle is
// its curvature k and k times its centre; where four touch each other, the sum of two that fill the
// same gap between the other three is twice the sum of these three, for all these numbers.
import type { Triple } from "../model/circle.js";

type Curved = { k: number; x: number; y: number };

/** x, y, r of the circles within one of radius `size`, which itself is left out. */
export function gasket(size: number, smallest: number): Triple[] {
  // Three equal circles that touch each other and the circle around them.
  const r = size / (1 + 2 / Math.sqrt(3));
  const distance = size - r;
  const first: Curved[] = [0, 1, 2].map((n) => {
    const angle = Math.PI / 2 + (2 * Math.PI * n) / 3;
    return { k: 1 / r, x: (distance * Math.cos(angle)) / r, y: (distance * Math.sin(angle)) / r };
  });
  const around: Curved = { k: -1 / size, x: 0, y: 0 };
  const circles = [...first];

  /** Fills the gap between a, b and c on the side where d is not. */
  function fill(a: Curved, b: Curved, c: Curved, d: Curved) {
    const other = (name: keyof Curved) => 2 * (a[name] + b[name] + c[name]) - d[name];
    const circle = { k: other("k"), x: other("x"), y: other("y") };
    if (1 / circle.k < smallest) return;
    circles.push(circle);
    fill(a, b, circle, c);
    fill(a, c, circle, b);
    fill(b, c, circle, a);
  }
  fill(first[0], first[1], first[2], around);
  first.forEach((circle, n) => fill(first[(n + 1) % 3], first[(n + 2) % 3], around, circle));
  return circles.map(({ k, x, y }): Triple => [x / k, y / k, 1 / k]);
}
