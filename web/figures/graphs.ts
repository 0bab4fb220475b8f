// Graphs that are compared: the edges of a diagram, named by its circles and not by their ids,
// which depend on the order in which circles came.
import type { Diagram } from "apollonius-diagram";

/** Each edge as a text, sorted. `name` tells a circle by its id. */
export function edgeNames(diagram: Diagram, name: (id: number) => string | number) {
  const { sites } = diagram.edges();
  const names: string[] = [];
  for (let k = 0; k < sites.length; k += 2) {
    const [a, b] = [String(name(sites[k])), String(name(sites[k + 1]))];
    names.push(a < b ? `${a} ${b}` : `${b} ${a}`);
  }
  return names.sort();
}

/** A circle as its coordinates say. */
export const byCircle = (diagram: Diagram) => (id: number) => {
  const { x, y, r } = diagram.site(id);
  return `${x},${y},${r}`;
};

/** The edges that only one of two sorted lists has. */
export function differing(a: readonly string[], b: readonly string[]) {
  const counts = new Map<string, number>();
  for (const edge of a) counts.set(edge, (counts.get(edge) ?? 0) + 1);
  for (const edge of b) counts.set(edge, (counts.get(edge) ?? 0) - 1);
  return [...counts.values()].reduce((sum, count) => sum + Math.abs(count), 0);
}
