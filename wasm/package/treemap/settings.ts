// Settings of a treemap, and the values of a tree, read before anything is laid out.
import { checkNumber, described, numberError, taken } from "../core/arguments.js";
import type { Position } from "../core/types.js";
import { ApolloniusError } from "../errors.js";
import type { Shape } from "./cells.js";
import type { TreemapCell, TreemapNode } from "./types.js";

/** A node of any data, and what a treemap has given it, if it has. */
export type Input = TreemapNode & Partial<TreemapCell>;

/** As the methods of a layout set it. */
export interface Settings {
  shape: Shape;
  value: ((datum: unknown) => number | undefined) | null;
  padding: number | ((node: Input) => number);
  sites: "move" | "stay";
  rounds: number;
  position: ((node: Input) => Position) | null;
  seed: number;
  key: ((node: Input, index: number) => unknown) | null;
}

const kNone: readonly Input[] = [];
export const childrenOf = (node: Input): readonly Input[] =>
  (node.children as readonly Input[] | undefined) ?? kNone;

/** All nodes, parents before their children, siblings in their order. */
export function nodesOf(root: Input): Input[] {
  if (typeof root !== "object" || root === null || !("data" in root))
    throw new ApolloniusError(
      "bad-option",
      `root is ${described(root)}, expected a node as d3-hierarchy makes it`,
    );
  const nodes = [root];
  for (let k = 0; k < nodes.length; ++k) nodes.push(...childrenOf(nodes[k]!));
  return nodes;
}

/** For messages: its usual key, if that is not only an object. */
export function nameOf(node: Input): string {
  const key = usualKey(node);
  return typeof key === "object" || key === undefined ? "a node" : `node ${described(key)}`;
}

/**
 * Identifies a node among its siblings, if nobody says something else: its name, which is the first
 * of a pair from the Map of d3.group or d3.rollup, or its datum itself. In a tree that d3-hierarchy
 * makes of a Map, the datum of a parent is such a pair, too: [key, Map].
 */
export function usualKey({ id, data, parent }: Input): unknown {
  const { id: ownId, name } = (data ?? {}) as { id?: unknown; name?: unknown };
  const isPair = Array.isArray(parent?.data) && parent.data[1] instanceof Map;
  return id ?? ownId ?? name ?? (isPair ? (data as unknown[])[0] : data);
}

function checkedValue(node: Input, value: unknown): number {
  if (typeof value === "number" && value >= 0 && value < Infinity) return value;
  const why =
    value === undefined
      ? "root.sum(…) makes values, or treemap().value(…)"
      : "negative or no number";
  throw new ApolloniusError(
    "bad-target",
    `the value of ${nameOf(node)} is ${described(value)}, expected a number from 0 on: ${why}`,
  );
}

/**
 * The values of nodes, in the order of `nodesOf`: their own, or sums of what is read from the data.
 */
export function valuesOf(nodes: readonly Input[], settings: Settings): Map<Input, number> {
  const read = settings.value;
  if (read === null) return new Map(nodes.map((node) => [node, checkedValue(node, node.value)]));
  const values = new Map<Input, number>();
  for (const node of [...nodes].reverse()) {
    const children = childrenOf(node);
    const own = read(node.data);
    const start = own === undefined && children.length > 0 ? 0 : checkedValue(node, own);
    values.set(
      node,
      children.reduce((sum, child) => sum + values.get(child)!, start),
    );
  }
  return new Map(nodes.map((node) => [node, values.get(node)!]));
}

/** A width that padding can have. */
export function checkedPadding(name: string, width: unknown): number {
  checkNumber(name, width);
  const known = taken(width as number);
  if (known >= 0) return known;
  throw new ApolloniusError("out-of-range", `${name} is ${described(width)}, expected 0 or more`);
}

/** The width of a node's padding. */
export function paddingOf(node: Input, { padding }: Settings): number {
  if (typeof padding !== "function") return padding;
  return checkedPadding(`padding of ${nameOf(node)}`, padding(node));
}

/** A given place of a node. */
export function positionOf(node: Input, position: (node: Input) => Position): Position {
  const place = position(node);
  const [x, y] = Array.isArray(place) ? (place as unknown[]) : [];
  const error =
    numberError(`x of the position of ${nameOf(node)}`, x) ??
    numberError(`y of the position of ${nameOf(node)}`, y);
  if (error) throw error;
  return [taken(x as number), taken(y as number)];
}
