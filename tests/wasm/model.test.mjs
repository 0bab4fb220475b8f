// Random histories against a model that knows only the set of circles.
import fc from "fast-check";
import { Diagram } from "../../build/packed/consumer.mjs";
import { isThorough } from "../support/effort.mjs";
import { graph } from "./support/graph.mjs";

/**
 * Small integers: nearly every predicate is zero somewhere, and the model's tests of covering are
 * exact.
 */
const gridCircle = fc.tuple(
  fc.integer({ min: -4, max: 4 }),
  fc.integer({ min: -4, max: 4 }),
  fc.integer({ min: 0, max: 3 }),
);
const anyNumber = fc
  .double({ min: -1e6, max: 1e6, noNaN: true })
  .map((value) => (Math.abs(value) < 1e-100 ? 0 : value));
const anyCircle = fc.tuple(
  anyNumber,
  anyNumber,
  fc.double({ min: 0, max: 3e5, noNaN: true }).map((r) => (r < 1e-100 ? 0 : r)),
);

/**
 * Operations name sites by a fraction of the present ids, so that shrinking keeps them meaningful.
 */
function operations(circle, maxLength) {
  const pick = fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true });
  return fc.array(
    fc.oneof(
      { weight: 25, arbitrary: fc.record({ insert: circle }) },
      { weight: 10, arbitrary: fc.record({ insertMany: fc.array(circle, { maxLength: 8 }) }) },
      { weight: 15, arbitrary: fc.record({ remove: pick }) },
      { weight: 5, arbitrary: fc.record({ removeMany: fc.array(pick, { maxLength: 5 }) }) },
      { weight: 15, arbitrary: fc.record({ update: pick, to: circle }) },
      {
        weight: 5,
        arbitrary: fc.record({
          updateMany: fc.uniqueArray(pick, { maxLength: 4 }),
          to: fc.array(circle, { minLength: 4, maxLength: 4 }),
        }),
      },
      { weight: 5, arbitrary: fc.record({ restore: fc.constant(true) }) },
      { weight: 1, arbitrary: fc.record({ clear: fc.constant(true) }) },
    ),
    { maxLength },
  );
}

/** Carries an operation out on both; `model` maps ids to circles. */
function apply(operation, diagram, model) {
  const ids = [...model.keys()];
  const idOf = (fraction) => ids[Math.floor(fraction * ids.length)];
  if (operation.insert) {
    const id = diagram.insert(...operation.insert);
    expect(model.has(id)).toBe(false);
    model.set(id, operation.insert);
  } else if (operation.insertMany) {
    const added = diagram.insertMany(operation.insertMany.flat());
    expect(added.length).toBe(operation.insertMany.length);
    added.forEach((id, k) => {
      expect(model.has(id)).toBe(false);
      model.set(id, operation.insertMany[k]);
    });
  } else if (operation.remove !== undefined) {
    const id = idOf(operation.remove) ?? 77;
    expect(diagram.remove(id)).toBe(model.delete(id));
  } else if (operation.removeMany) {
    const chosen = operation.removeMany.map((fraction) => idOf(fraction) ?? 77);
    const count = chosen.filter((id) => model.delete(id)).length;
    expect(diagram.removeMany(chosen)).toBe(count);
  } else if (operation.update !== undefined && ids.length > 0) {
    const id = idOf(operation.update);
    diagram.update(id, ...operation.to);
    model.set(id, operation.to);
  } else if (operation.updateMany && ids.length > 0) {
    const chosen = [...new Set(operation.updateMany.map(idOf))];
    const circles = operation.to.slice(0, chosen.length);
    diagram.updateMany(chosen, circles.flat());
    chosen.forEach((id, k) => model.set(id, circles[k]));
  } else if (operation.clear) {
    diagram.clear();
    model.clear();
  }
}

/** Whether circle b holds circle a; exact for small integers. */
function covers([bx, by, br], [ax, ay, ar]) {
  return br >= ar && (ax - bx) ** 2 + (ay - by) ** 2 <= (br - ar) ** 2;
}

function checkSites(diagram, model) {
  const ids = [...model.keys()].sort((a, b) => a - b);
  expect([...diagram.ids()]).toEqual(ids);
  expect(diagram.size).toBe(ids.length);
  expect(diagram.visibleSize + diagram.hiddenSize).toBe(ids.length);
  for (const id of ids) {
    const { x, y, r } = diagram.site(id);
    expect([x, y, r]).toEqual(model.get(id));
  }
}

function checkHiddenExactly(diagram, model) {
  for (const [id, circle] of model) {
    const others = [...model].filter(
      ([other, otherCircle]) => other !== id && covers(otherCircle, circle),
    );
    const properly = others.filter(([, other]) => String(other) !== String(circle));
    if (properly.length > 0) expect(diagram.isHidden(id)).toBe(true);
    else if (others.length === 0) expect(diagram.isHidden(id)).toBe(false);
    else
      expect(
        [id, ...others.map(([other]) => other)].filter((same) => !diagram.isHidden(same)).length,
      ).toBe(1);
    const cover = diagram.coverOf(id);
    if (diagram.isHidden(id)) {
      expect(diagram.isHidden(cover)).toBe(false);
      expect(covers(model.get(cover), circle)).toBe(true);
    } else {
      expect(cover).toBe(-1);
    }
  }
}

function checkNearest(diagram, model, scale) {
  const distance = ([x, y, r], px, py) => Math.hypot(px - x, py - y) - r;
  for (let k = 0; k < 12; ++k) {
    const [px, py] = [(Math.cos(k * 2.4) * scale * k) / 8, (Math.sin(k * 2.4) * scale * k) / 8];
    const answer = diagram.nearest(px, py);
    if (model.size === 0) {
      expect(answer).toBeNull();
      continue;
    }
    const smallest = Math.min(...[...model.values()].map((circle) => distance(circle, px, py)));
    expect(Math.abs(distance(model.get(answer.id), px, py) - smallest)).toBeLessThanOrEqual(
      1e-12 * scale,
    );
    expect(Math.abs(answer.distance - smallest)).toBeLessThanOrEqual(1e-12 * scale);
    expect(diagram.isHidden(answer.id)).toBe(false);
  }
}

function property(circle, { scale, maxLength, isExact }) {
  return fc.property(
    operations(circle, maxLength),
    fc.constantFrom("hierarchy", "walk"),
    (history, location) => {
      let diagram = new Diagram(undefined, { location });
      const model = new Map();
      try {
        for (const operation of history) {
          if (operation.restore) {
            // Not validated, which would ask for all that restoring leaves for later: the next
            // operation is to meet it as it is.
            const original = diagram;
            diagram = Diagram.fromBytes(original.toBytes(), { location });
            original.dispose();
          } else {
            apply(operation, diagram, model);
            expect(diagram.validate()).toBeNull();
          }
        }
        checkSites(diagram, model);
        if (isExact) checkHiddenExactly(diagram, model);
        checkNearest(diagram, model, scale);
        const fresh = new Diagram([...model.values()].flat());
        expect(graph(diagram)).toEqual(graph(fresh));
        fresh.dispose();
      } finally {
        diagram.dispose();
      }
    },
  );
}

test("circles on a small grid", () => {
  fc.assert(property(gridCircle, { scale: 10, maxLength: 40, isExact: true }), {
    numRuns: isThorough ? 1000 : 300,
  });
});

test("circles of any numbers", () => {
  fc.assert(property(anyCircle, { scale: 1e6, maxLength: 40, isExact: false }), {
    numRuns: isThorough ? 500 : 150,
  });
});
