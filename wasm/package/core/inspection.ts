// How diagrams appear to tools that know nothing of them: object comparison, structured cloning,
// consoles.
import { ApolloniusError, type ErrorCode } from "../errors.js";
import type { ListedSite, Sites } from "./types.js";

/** The name of the method by which Node, Deno and Bun describe an object. */
export const kInspect: unique symbol = /* @__PURE__ */ Symbol.for("nodejs.util.inspect.custom");

// A symbol cannot be cloned; engines put its description into the error that the attempt throws.
const kNoClone = /* @__PURE__ */ Symbol("A Diagram, which toBytes() and fromBytes() copy,");

/** A diagram, of the plane or of the sphere. */
interface Inspected {
  readonly size: number;
  readonly hiddenSize: number;
  sites(): unknown;
}

/** A view of a diagram. */
interface InspectedView {
  readonly diagram: Inspected;
  readonly [Symbol.toStringTag]: string;
}

// An own property of the object: `assert.deepStrictEqual` and `structuredClone` ignore all others,
// and without it they would take every diagram for {}.
const kContent: PropertyDescriptor = {
  enumerable: true,
  get(this: Inspected) {
    return { clone: kNoClone, sites: unlessEnded(() => this.sites()) };
  },
};

/** Gives a new diagram a property in which unequal diagrams differ and that cannot be cloned. */
export function showContent(diagram: Inspected): void {
  Object.defineProperty(diagram, "content", kContent);
}

/** Gives the sites one by one, as they were when the first one was asked for. */
export function* listed(ask: () => Sites): Generator<ListedSite, void> {
  const { ids, xyr, hidden } = ask();
  for (let k = 0; k < ids.length; ++k) {
    const [x, y, r] = [xyr[3 * k]!, xyr[3 * k + 1]!, xyr[3 * k + 2]!];
    yield { id: ids[k]!, x, y, r, hidden: hidden[k] === 1 };
  }
}

/** Describes a diagram in a few words; never throws for a disposed or broken one. */
export function summary(diagram: Inspected, name: string): string {
  const numbers = () => `size: ${diagram.size}, hidden: ${diagram.hiddenSize}`;
  return `${name} { ${unlessEnded(numbers)} }`;
}

/**
 * Gives a new view the words in which consoles show it, as an own property. A method with a
 * computed name would make bundlers keep its class even where it is unused.
 */
export function showInWords(view: InspectedView, window = ""): void {
  const { diagram } = view;
  const cells = () => `${window}cells: ${diagram.size - diagram.hiddenSize}`;
  const words = () => `${view[Symbol.toStringTag]} { ${unlessEnded(cells)} }`;
  Object.defineProperty(view, kInspect, { value: words });
}

/** Returns the answer of `ask`, or "disposed" or "broken" if it throws that. */
function unlessEnded<Answer>(ask: () => Answer): Answer | ErrorCode {
  try {
    return ask();
  } catch (error) {
    if (error instanceof ApolloniusError && /disposed|broken/.test(error.code)) return error.code;
    throw error;
  }
}
