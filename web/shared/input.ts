// Pointers and keys.

/** Where an event is in an element, in CSS pixels. */
export function placeIn(element: Element, { clientX, clientY }: MouseEvent): [number, number] {
  const { left, top } = element.getBoundingClientRect();
  return [clientX - left, clientY - top];
}

export type Direction = readonly [dx: number, dy: number];

const kArrows = new Map<string, Direction>([
  ["ArrowLeft", [-1, 0]],
  ["ArrowRight", [1, 0]],
  ["ArrowUp", [0, -1]],
  ["ArrowDown", [0, 1]],
]);

/** Where an arrow key points, y downwards. */
export const arrowOf = (key: string) => kArrows.get(key);
