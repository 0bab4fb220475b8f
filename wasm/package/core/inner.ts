// The contents of diagrams of both classes, and how functions in other files reach them.
import { ApolloniusError } from "../errors.js";
import { described } from "./arguments.js";
import type { Ballast } from "./native/lifetime.js";
import type { AnyNative, NativeDiagram } from "./native/module.js";
import { plane, type Space } from "./space.js";

/** The number of callers' functions, as filters, that run now: none may change the diagram. */
export interface Filters {
  running: number;
}

/** The diagram in the module, and everything else that its calls need. */
export interface Inner<Native extends AnyNative = AnyNative> {
  readonly native: Native;
  readonly space: Space;
  readonly filters: Filters;
  readonly ballast: Ballast;
}

/** Returns the inside of a diagram: null after dispose(), undefined if it is no diagram. */
type Access = (diagram: unknown) => Inner | null | undefined;

let access: Access;

/** Sets the accessor. DynamicDiagram calls it once: only that class can read its private field. */
export function provideInner(accessor: Access): void {
  access = accessor;
}

/**
 * Returns the inside of the object that a method is called on. Throws "bad-option" if that is no
 * diagram, "disposed" after dispose(), and "busy" if the call `changes` the diagram while a
 * function that the diagram called, as a filter, is running.
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

/** Does innerOf() for the plane; throws "bad-option" also for a diagram of the sphere. */
export function planarOf(diagram: unknown, changes = false): Inner<NativeDiagram> {
  const inner = innerOf(diagram, changes);
  if (inner.space !== plane) throw wrongReceiver(diagram);
  return inner as Inner<NativeDiagram>;
}

/** Returns the diagram in the module of a diagram of the plane. */
export function nativeOf(diagram: unknown, changes = false): NativeDiagram {
  return planarOf(diagram, changes).native;
}

/**
 * Returns the error of a method that was detached from its object, or called on a foreign object,
 * or on a diagram of another copy of the package.
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
