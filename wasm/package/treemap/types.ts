// Types that the entry `apollonius-diagram/treemap` takes and gives.
import type { DrawOptions, PathContext } from "../core/path.js";
import type { AsyncOptions, Bounds, Position, Site } from "../core/types.js";
import type { Disc, Region } from "../shapes/region.js";
import type { CellCircle, CellCircleOptions } from "../shapes/types.js";

export type { Disc };

/**
 * The root's cell: bounds, a window of any shape, as `diagram.voronoi` has it, or a disc.
 */
export type TreemapShape = Bounds | Region | Disc;

/** The properties of nodes that a treemap reads: of d3-hierarchy's nodes and of plain trees. */
export interface TreemapNode<Datum = unknown> {
  /** The datum that the node stands for. */
  readonly data: Datum;
  /** Its share among its siblings, as `root.sum(…)` or `root.count()` makes it; 0 for no cell. */
  readonly value?: number | undefined;
  /** Id, in a tree made by `stratify`. */
  readonly id?: string | undefined;
  /** How many levels it is below the root. */
  readonly depth?: number | undefined;
  /** How many levels are below it. */
  readonly height?: number | undefined;
  /** Missing for leaves. */
  readonly children?: readonly TreemapNode<Datum>[] | undefined;
  /** null or missing for the root. */
  readonly parent?: TreemapNode<Datum> | null | undefined;
}

/** How the children of a node were fitted into its cell. */
export interface TreemapFit {
  /** Steps in all: each costs about as much as building the diagram of the children. */
  iterations: number;
  /** The largest deviation of a child's area from its target, as a share of that. */
  error: number;
  /**
   * Whether `error` is within what was asked for. If it is not, the weights are right up to their
   * last places, as for `fitAreas`.
   */
  converged: boolean;
}

/** The cell that a treemap gives to each node. */
export interface TreemapCell {
  /** Area of the curved cell, in the shape's unit squared; 0 without a value. */
  area: number;
  /** Centroid of the curved cell; null without a value. */
  centroid: Position | null;
  /**
   * The cell as one closed ring, counter-clockwise (y upwards): its own area is `area` but for
   * rounding, and it is within a 2^13th of the shape's diagonal, or a 2^8th of the cell's width if
   * that is less, of the curved one. Holes and further parts are joined by doubled segments, as
   * in `cellPolygon`. null without a value.
   */
  polygon: Position[] | null;
  /**
   * Its circle in the diagram of its siblings, in the shape's coordinates; null for the root, only
   * children, and without a value.
   */
  circle: Site | null;
  /**
   * How its children were fitted; null for leaves, only children's parents, and without a value.
   */
  fit: TreemapFit | null;
  /**
   * The largest circle inside the curved cell, for its name, or with `aspect` the largest ellipse,
   * as `cellCircle` has it: r is at least 0.999 of the largest possible. null without a value.
   * Some milliseconds, and nothing when the same aspect is asked for again. Throws "not-finite",
   * "out-of-range" (aspect), "bad-option", "no-convergence".
   */
  label(options?: CellCircleOptions): CellCircle | null;
  /**
   * Draws the curved cell as closed figures, the tolerance in the shape's unit; without a value
   * nothing, and as a path null. Takes time in proportion to the curves drawn. Throws "bad-option"
   * (a context that cannot draw), "not-finite", "out-of-range" (tolerance, digits).
   */
  render(context: PathContext, options?: DrawOptions): void;
  render(context?: null, options?: DrawOptions): string | null;
  render(context?: PathContext | null, options?: DrawOptions): string | null | void;
}

/**
 * A node with its cell, whose children and parent have theirs: what a layout returns. (Of a list of
 * nodes, each.)
 */
export type WithCells<Node> = Node extends readonly (infer Child)[]
  ? WithCells<Child>[]
  : Node extends object
    ? TreemapCell &
        // The children of d3's nodes are of the type of the node, with all that it has.
        (Node & TreemapCell extends {
          readonly children?: readonly TreemapCell[] | undefined;
          readonly parent?: TreemapCell | null | undefined;
        }
          ? Node
          : {
              [Key in keyof Node]: Key extends "children" | "parent"
                ? WithCells<Node[Key]>
                : Node[Key];
            })
    : Node;

/** Options of a layout. */
export interface TreemapOptions<Node = TreemapNode> {
  /**
   * A root that a treemap has laid out, for animations: sites begin where they are there, with
   * their weights, and at most move a quarter of the way to their centroids. Where values change by
   * a few percent, two to four steps do. Children are matched by their keys within parents that
   * match; the layout throws "bad-option" if two siblings have the same one. The tree may be the
   * same one, with other values: then each node is matched with itself. Default: null.
   */
  previous?: (Node & TreemapCell) | null | undefined;
}

/** Options of a layout in slices. */
export interface AsyncTreemapOptions<Node = TreemapNode>
  extends TreemapOptions<Node>,
    AsyncOptions {}

/**
 * A layout for trees of d3-hierarchy, or plain ones, in the manner of d3: call it with a root. Each
 * method sets one thing, checks it at once, and returns the layout, or without an argument says
 * what is set. `Node` is the type of the nodes that functions get: `treemap<Datum,
 * HierarchyNode<Datum>>()` gives them all that d3's nodes have.
 *
 * The children of a node fill its cell with cells of their own, which are curved and whose areas
 * are in proportion to the values: each child's *target* is the area of its parent's window times
 * its share of the sum of its siblings' values. `area` is within 1e-6 of that, relative to it.
 * Without padding a parent's window has the area of its cell, so that each cell has its share of
 * the whole shape, and this holds to 1e-6, too, on any level: each level gets its part of the
 * tolerance, and windows are polygons of exactly the cells' areas. Values of siblings may differ by
 * a factor of 1e6. Beyond that, or where sites stay at places without room for their cells,
 * `fit.converged` can be false, or "no-convergence" is thrown.
 *
 * Layouts are all or nothing: nodes change at the end. The same tree, settings and seed give the
 * same bits. Errors: "bad-target" (a value that is negative or no number), "not-finite",
 * "out-of-range" (what functions return), "bad-option", "no-convergence", "out-of-memory".
 * Cost: for each node's n children, with some 8 rounds of 2 steps, that of 20 diagrams of n sites.
 */
export interface Treemap<Datum = unknown, Node extends TreemapNode<Datum> = TreemapNode<Datum>> {
  /** Gives each node of a tree its cell; returns the root. */
  <Root extends Node>(root: Root, options?: TreemapOptions<Node>): WithCells<Root>;

  /**
   * Lays out in slices of some milliseconds, between which the event loop has a turn. Rejects as
   * the call throws, and with the reason of `signal` once that aborts; nodes are as they were then.
   */
  async<Root extends Node>(
    root: Root,
    options?: AsyncTreemapOptions<Node>,
  ): Promise<WithCells<Root>>;

  /**
   * The root's cell: [0, 0, width, height]. Gives null where `shape` has been set to something
   * else. Default: [1, 1]. Throws "bad-bounds".
   */
  size(): [width: number, height: number] | null;
  size(size: readonly [width: number, height: number]): this;

  /**
   * The root's cell: bounds, a region, or a disc. It is read when it is set. Default: [0, 0, 1, 1].
   * Throws "bad-bounds", and "not-finite", "out-of-range" (a disc); "not-loaded" where a region is
   * set before `load`, if that is needed.
   */
  shape(): TreemapShape;
  shape(shape: TreemapShape): this;

  /**
   * Reads the own value of a datum; a node's is that and its children's, which the layout puts into
   * `node.value`, as `root.sum` does. Of inner nodes undefined is 0. Default: null, `node.value` is
   * taken as it is.
   */
  value(): ((datum: Datum) => number | undefined) | null;
  value(value: ((datum: Datum) => number | undefined) | null): this;

  /**
   * The width of a strip inside the border of a node's cell that its children leave free: a number,
   * or a function of the node. Corners of the rest are sharp. Where a cell is too narrow, half the
   * width is taken, or a quarter, and so on. Default: 0.
   */
  padding(): number | ((node: Node) => number);
  padding(padding: number | ((node: Node) => number)): this;

  /**
   * "move" (default): sites move to the centroids of their cells, round after round, which makes
   * cells round. "stay": they are where they began, which is faster.
   */
  sites(): "move" | "stay";
  sites(sites: "move" | "stay"): this;

  /** Most rounds of moves, up to 1000; fewer where sites have come to rest. Default: 8. */
  rounds(): number;
  rounds(rounds: number): this;

  /**
   * Where a node's site begins, in the shape's coordinates. One that is outside its parent's
   * window, or where a sibling's is, begins at a free place nearby. Default: null, places are
   * spread over the window by value, in the order of the children.
   */
  position(): ((node: Node) => Position) | null;
  position(position: ((node: Node) => Position) | null): this;

  /** Any number; another one gives another layout, if no positions are given. Default: 0. */
  seed(): number;
  seed(seed: number): this;

  /**
   * Gives the key by which a node is matched with that of `previous`. Default: `node.id`, or else
   * `data.id` or `data.name`, or else, of the pairs [key, value] in trees of d3.group and
   * d3.rollup, the key, or else `data` itself. Where siblings without names come and go at once,
   * only a key can tell which is which: without one the layout throws "bad-option".
   */
  key(): ((node: Node, index: number) => unknown) | null;
  key(key: ((node: Node, index: number) => unknown) | null): this;
}
