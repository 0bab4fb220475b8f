// What the objects of both classes of diagrams hold, and how functions in other files reach it.
import { ApolloniusError } from "../errors.js";
import { described } from "./arguments.js";
import type { Ballast } from "./native/lifetime.js";
import type { AnyNative, NativeDiagram } from "./native/module.js";
import { plane, type Space } from "./space.js";

/** How many filters and other functions of callers are running: none may change the diagram. */
export interface Filters {
  running: number;
}

/** The diagram in the module, and what calls of it need besides. */
export interface Inner<Native extends AnyNative = AnyNative> {
  readonly native: Native;
  readonly space: Space;
  readonly filters: Filters;
  readonly ballast: Ballast;
}

/** null after dispose(), undefined if it is no diagram. */
type Access = (diagram: unknown) => Inner | null | undefined;

let access: Access;

/** Called once, by DynamicDiagram, whose private field only that class can read. */
export function provideInner(accessor: Access): void {
  access = accessor;
}

/**
 * The inside of the object that a method is called on. Throws "bad-option" if that is no diagram,
 * "disposed" after dispose(), and "busy" if the call `changes` the diagram while a function that it
 * asks runs.
 */
export function innerOf(diagram: unknown, changes = false): Inner {
  const inner = access(diagram);
  if (inner === undefined) throw wrongReceiver(diagram);
  if (inner === null) throw new ApolloniusError("disposed", "the diagram has been disposed of");
  if (changes && inner.filters.running > 0)
    throw new ApolloniusError(
      "busy",
      "a filter may not change the diagram that asks it, nor may maxDistance",
    );
  return inner;
}

/** As innerOf; throws "bad-option" also for a diagram of the sphere. */
export function planarOf(diagram: unknown, changes = false): Inner<NativeDiagram> {
  const inner = innerOf(diagram, changes);
  if (inner.space !== plane) throw wrongReceiver(diagram);
  return inner as Inner<NativeDiagram>;
}

/** The diagram in the module, of the plane. */
export function nativeOf(diagram: unknown, changes = false): NativeDiagram {
  return planarOf(diagram, changes).native;
}

/**
 * The error of a method that was taken off its object, or called on another, or on one of another
 * copy of the package.
 */
export function wrongReceiver(receiver: unknown): ApolloniusError {
  const isForeign = !access(receiver) && /Diagram]$/.test(Object.prototype.toString.call(receiver));
  return new ApolloniusError(
    "bad-option",
    `a method was called on ${described(receiver)}, expected a diagram or a Voronoi` +
      (isForeign
        ? ", no proxy, and not of another copy of the package (import and require make two): use " +
          "fromBytes(other.toBytes())"
        : ": call it as diagram.find(x, y) or diagram.voronoi(bounds).cellArea(id)"),
  );
}
