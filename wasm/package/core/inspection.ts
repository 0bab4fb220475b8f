// What a diagram says to those who know nothing of diagrams: comparisons of objects, structured
// cloning, consoles.
import { ApolloniusError, type ErrorCode } from "../errors.js";
import type { ListedSite, Sites } from "./types.js";

/** The name of the method by which Node, Deno and Bun describe an object. */
export const kInspect: unique symbol = /* @__PURE__ */ Symbol.for("nodejs.util.inspect.custom");

// Cannot be cloned; engines put its description into the error that the attempt throws.
const kNoClone = /* @__PURE__ */ Symbol("A Diagram, which toBytes() and fromBytes() copy,");

/** A diagram, of the plane or of the sphere. */
interface Inspected {
  readonly size: number;
  readonly hiddenSize: number;
  sites(): unknown;
}

/** A view of one. */
interface InspectedView {
  readonly diagram: Inspected;
  readonly [Symbol.toStringTag]: string;
}

// A property of the object's own: of nothing else do `assert.deepStrictEqual` and `structuredClone`
// take notice, for which all diagrams would be {}.
const kContent: PropertyDescriptor = {
  enumerable: true,
  get(this: Inspected) {
    return { clone: kNoClone, sites: unlessEnded(() => this.sites()) };
  },
};

/** Gives a new diagram a property by which different ones differ, and which nobody can clone. */
export function showContent(diagram: Inspected): void {
  Object.defineProperty(diagram, "content", kContent);
}

/** The sites one by one, as they are when the first is asked for. */
export function* listed(ask: () => Sites): Generator<ListedSite, void> {
  const { ids, xyr, hidden } = ask();
  for (let k = 0; k < ids.length; ++k) {
    const [x, y, r] = [xyr[3 * k]!, xyr[3 * k + 1]!, xyr[3 * k + 2]!];
    yield { id: ids[k]!, x, y, r, hidden: hidden[k] === 1 };
  }
}

/** A diagram in a few words; never throws. */
export function summary(diagram: Inspected, name: string): string {
  const numbers = () => `size: ${diagram.size}, hidden: ${diagram.hiddenSize}`;
  return `${name} { ${unlessEnded(numbers)} }`;
}

/**
 * Gives a new view the words in which consoles show it. A property of its own, as bundlers keep a
 * class whose methods have computed names, whether it is used or not.
 */
export function showInWords(view: InspectedView, window = ""): void {
  const { diagram } = view;
  const cells = () => `${window}cells: ${diagram.size - diagram.hiddenSize}`;
  const words = () => `${view[Symbol.toStringTag]} { ${unlessEnded(cells)} }`;
  Object.defineProperty(view, kInspect, { value: words });
}

/** What `ask` gives, or "disposed" or "broken". */
function unlessEnded<Answer>(ask: () => Answer): Answer | ErrorCode {
  try {
    return ask();
  } catch (error) {
    if (error instanceof ApolloniusError && /disposed|broken/.test(error.code)) return error.code;
    throw error;
  }
}
