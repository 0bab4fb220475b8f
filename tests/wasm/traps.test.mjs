// A call that ends in its middle (a trap, an exhausted stack) breaks the diagram that it was about
// and no other.
import { fileURLToPath } from "node:url";
import { capture } from "../../tools/toolchain/process.mjs";
import { calls } from "./support/calls.mjs";

const run = (program) =>
  JSON.parse(
    capture(process.execPath, [fileURLToPath(new URL(`support/${program}`, import.meta.url))], {
      env: { NODE_OPTIONS: "" },
    }),
  );

describe("traps", () => {
  let found;
  beforeAll(() => {
    found = run("trapping.mjs");
  });

  test.each(calls.map(([name]) => name))("%s", (name) => {
    const isMaking = /\.(constructor|from|fromBytes)$/.test(name);
    // nothing of theirs is done in WebAssembly
    const without = ["Diagram.voronoi", "Voronoi.renderBounds"].includes(name);
    expect(found.perCall[name].length).toBeGreaterThanOrEqual(without ? 0 : 3);
    for (const one of found.perCall[name]) {
      expect(one).toMatchObject({
        code: "broken",
        cause: one.kind === "end of stack" ? "RangeError" : "RuntimeError",
        harm: "",
        disposed: "disposed",
        destructed: 0,
      });
      if (!isMaking) expect(one.after.filter((code) => code !== "none")).toEqual(["broken"]);
    }
  });

  test("in the middle of malloc, while the memory grows", () => {
    expect(found.inGrowth.length).toBe(15);
    for (const one of found.inGrowth) expect(one).toMatchObject({ code: "broken", harm: "" });
  });

  test("what a context throws is no trap", () => {
    expect(found.inContext).toMatch(/RuntimeError: unreachable/);
    expect(found.afterContext).toBeNull();
  });

  test("in a later portion of a drawing, and in a call of the context", () => {
    expect(found.nested).toEqual({
      inPortion: "broken",
      next: "broken",
      inNested: "none",
      inner: "broken",
      outer: null,
      harm: "",
    });
  });

  test("views of diagrams that were made before a trap still compute", () => {
    expect(found.ofOldInstance).toBe("none");
  });

  test("a console that throws when a broken invariant is reported is as a trap", () => {
    expect(found).toMatchObject({ reported: "broken", afterReport: "" });
  });

  test("again and again, with large diagrams", () => {
    expect(found.failures.sort()).toEqual(["", "broken"]);
  });
});

test("calls at the very end of JavaScript's stack", () => {
  const { ends, wrong } = run("end_of_stack.mjs");
  expect(wrong).toEqual([]);
  expect(ends.none).toBeGreaterThan(0);
  expect(ends.RangeError).toBeGreaterThan(0);
});
