// toBytes and fromBytes through the package: the same diagram again, whatever its history; in other
// threads; and damaged bytes do no harm.
import { copyFileSync, readFileSync } from "node:fs";
import path from "node:path";
import { runInNewContext } from "node:vm";
import fc from "fast-check";
import { Diagram } from "../../build/packed/consumer.mjs";
import { validate } from "../../build/packed/diagnostics.mjs";
import { root } from "../../tools/toolchain/folders.mjs";
import { capture } from "../../tools/toolchain/process.mjs";
import { snapshot } from "./support/graph.mjs";
import { packed } from "./support/install_packed.mjs";
import { runInNode } from "./support/node.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRefusal } from "./support/refusal.mjs";
import { signed } from "./support/signed.mjs";

const recorded = new Uint8Array(readFileSync(path.join(root, "tests/data/snapshots/version2.bin")));

function built() {
  const diagram = new Diagram(randomCircles(40, 31));
  diagram.insert(0, 0, 300); // hides some
  diagram.removeMany([7, 3, 20]);
  return diagram;
}

/** All rows of all arrays, in their order. */
function rows(diagram) {
  const { xy, clearance, sites } = diagram.vertices();
  const edges = diagram.edges();
  return [...xy, ...clearance, ...sites, ...edges.sites, ...edges.vertices].join();
}

test("a restored diagram is the same", () => {
  const diagram = built();
  const bytes = diagram.toBytes();
  expect(bytes).toBeInstanceOf(Uint8Array);
  expect(bytes.buffer.byteLength).toBe(bytes.length);
  const restored = Diagram.fromBytes(bytes);
  expect(validate(restored)).toBeNull();
  expect(snapshot(restored)).toBe(snapshot(diagram));
  expect(rows(restored)).toBe(rows(diagram));
  expect(restored.toBytes()).toEqual(bytes);
  for (let k = 0; k < 5; ++k)
    // free ids first, in the same order
    expect(restored.insert(9 * k, 5, k)).toBe(diagram.insert(9 * k, 5, k));
  expect(snapshot(restored)).toBe(snapshot(diagram));
});

test("bytes that were written natively are read, and written again", () => {
  const restored = Diagram.fromBytes(recorded);
  expect(validate(restored)).toBeNull();
  expect(restored.size).toBe(36);
  expect(restored.toBytes()).toEqual(recorded);
});

test("few sites, and none", () => {
  for (const xyr of [[], [1, 2, 3], [1, 2, 3, 1, 2, 1], [0, 0, 1, 9, 0, 1]]) {
    const diagram = new Diagram(xyr);
    const restored = Diagram.fromBytes(diagram.toBytes());
    expect(snapshot(restored)).toBe(snapshot(diagram));
    expect(restored.find(1, 1)).toBe(diagram.find(1, 1));
  }
});

test("after any history", () => {
  const number = fc.integer({ min: -6, max: 6 });
  const step = fc.record({
    remove: fc.integer({ min: -8, max: 12 }),
    x: number,
    y: number,
    r: fc.integer({ min: 0, max: 9 }),
  });
  const play = (diagram, steps) =>
    steps.map(({ remove, x, y, r }) =>
      remove >= 0 ? diagram.remove(remove) : diagram.insert(x, y, r),
    );
  fc.assert(
    fc.property(
      fc.array(step, { maxLength: 60 }),
      fc.array(step, { maxLength: 20 }),
      (before, after) => {
        const diagram = new Diagram();
        play(diagram, before);
        const restored = Diagram.fromBytes(diagram.toBytes());
        expect(validate(restored)).toBeNull();
        expect(rows(restored)).toBe(rows(diagram));
        expect(play(restored, after)).toEqual(play(diagram, after));
        expect(validate(restored)).toBeNull();
        expect(restored.ids()).toEqual(diagram.ids());
        diagram.dispose();
        restored.dispose();
      },
    ),
    { numRuns: 300 },
  );
});

// --- Where bytes come from -----------------------------------------------------------------------

test("bytes may be a view, at odd offsets, shared, of another realm, or all of a buffer", () => {
  const shared = new Uint8Array(new SharedArrayBuffer(recorded.length + 3), 3);
  shared.set(recorded);
  const odd = new Uint8Array(recorded.length + 9).subarray(5, recorded.length + 5);
  odd.set(recorded);
  for (const bytes of [
    shared,
    odd,
    runInNewContext("Uint8Array.from(values)", { values: [...recorded] }),
    Buffer.from(recorded),
    recorded.buffer,
    runInNewContext("Uint8Array.from(values).buffer", { values: [...recorded] }),
  ]) {
    expect(Diagram.fromBytes(bytes).toBytes()).toEqual(recorded);
  }
});

test.each([
  ["nothing", undefined, "bytes is undefined"],
  ["null", null, "bytes is null"],
  ["a string", "Apol", 'bytes is the string "Apol"'],
  ["an array of numbers", [...recorded], "bytes is an array"],
  ["shared memory itself", new SharedArrayBuffer(8), "expected a Uint8Array or an ArrayBuffer"],
  ["other elements", new Uint8ClampedArray(recorded), "bytes is Uint8ClampedArray("],
  ["a view for all", new DataView(recorded.buffer), "bytes is an object"],
])("%s is refused", (_, bytes, message) => {
  expectRefusal(() => Diagram.fromBytes(bytes), "bad-length", message);
});

test("a detached buffer is refused", () => {
  const bytes = recorded.slice();
  structuredClone(bytes, { transfer: [bytes.buffer] });
  expectRefusal(() => Diagram.fromBytes(bytes), "bad-length", "detached");
  expectRefusal(() => Diagram.fromBytes(bytes.buffer), "bad-length", "bytes is an object");
});

// --- Damage --------------------------------------------------------------------------------------

const corrupt = (bytes) =>
  expectRefusal(() => Diagram.fromBytes(bytes), "corrupt-snapshot", "bytes are no snapshot");

test("every truncation is noticed", () => {
  for (let length = 0; length < recorded.length; ++length) corrupt(recorded.subarray(0, length));
});

test("every flipped byte is noticed", () => {
  const bytes = recorded.slice();
  for (let k = 0; k < bytes.length; ++k) {
    for (const change of [1 << (k % 8), 0xff]) {
      bytes[k] ^= change;
      corrupt(bytes);
      bytes[k] ^= change;
    }
  }
});

const originals = [
  recorded,
  ...[
    [0, 0, 1, 5, 0, 2, 0, 4, 1, 5, 0, 1],
    [-10, 0, 8, 10, 0, 8, 0, 0, 1, 0, 5, 1, 0, -6, 0.5, -10, 0, 3],
    Array.from({ length: 16 }, (_, k) => [k % 4, k >> 2, 0]).flat(),
  ].map((circles) => new Diagram(circles).toBytes()),
];

const changes = fc.array(
  fc.record({
    at: fc.nat(),
    from: fc.nat(),
    word: fc.oneof(fc.nat({ max: 40 }), fc.integer()),
    kind: fc.constantFrom("byte", "word", "number", "site"),
  }),
  { minLength: 1, maxLength: 3 },
);

/** A snapshot with some of its parts changed, and a checksum that says it was never otherwise. */
function forged(original, changes) {
  const bytes = original.slice(),
    view = new DataView(bytes.buffer),
    slots = view.getUint32(12, true);
  for (const { at, from, word, kind } of changes) {
    if (kind === "byte") bytes[at % (bytes.length - 8)] = word;
    else if (kind === "word") view.setInt32(4 * (at % (bytes.length / 4 - 2)), word, true);
    else if (kind === "number") {
      view.setFloat64(
        32 + 8 * (at % (3 * slots)),
        view.getFloat64(32 + 8 * (from % (3 * slots)), true),
        true,
      );
    } else {
      const one = 32 + 24 * (at % slots),
        other = 32 + 24 * (from % slots),
        site = bytes.slice(one, one + 24);
      bytes.copyWithin(one, other, other + 24);
      bytes.set(site, other);
    }
  }
  return signed(bytes);
}

function restoredOrNull(bytes, options) {
  try {
    return Diagram.fromBytes(bytes, options);
  } catch (error) {
    expect(error.code).toBe("corrupt-snapshot");
    return null;
  }
}

/** Makes each call in turn; an error must be an ApolloniusError with one of the codes. */
function callAll(diagram, codes) {
  const attempt = (call) => {
    try {
      return call();
    } catch (error) {
      expect([error.name, error.code]).toEqual([
        "ApolloniusError",
        expect.stringMatching(`^(${codes})$`),
      ]);
    }
  };
  const ids = attempt(() => diagram.ids()) ?? [];
  const voronoi = diagram.voronoi([-20, -20, 20, 20]);
  for (const call of [
    () => diagram.find(1, 2),
    () => diagram.findMany([3, 4, -100, 7]),
    () => diagram.kNearest(0, 0, 4),
    () => diagram.within(1, 1, 5),
    () => diagram.vertices(),
    () => diagram.edges(),
    () => diagram.toBytes(),
    () => validate(diagram),
    () => diagram.hull(),
    () => diagram.render(),
    () => diagram.renderHull(),
    () => voronoi.render(),
    () => voronoi.edgeCurves(),
    () => voronoi.cellAreas(),
    () => voronoi.toGeoJSON(),
  ])
    attempt(call);
  for (const id of ids) {
    attempt(() => [
      diagram.neighbors(id),
      diagram.coverOf(id),
      voronoi.cellParts(id),
      voronoi.cellGeometry(id),
    ]);
    attempt(() => voronoi.cellMeasures(id));
  }
  for (const id of ids) attempt(() => diagram.update(id, id % 7, id % 3, id % 2));
  attempt(() => diagram.insertMany([1, 2, 3, 4, 5, 0]));
  attempt(() =>
    diagram.updateMany(
      ids.slice(0, 3),
      [...ids.slice(0, 3)].flatMap((id) => [id, -id, 1]),
    ),
  );
  for (const id of ids) attempt(() => [diagram.find(id, -id), diagram.remove(id)]);
}

test("forged bytes with a right checksum are refused, or are the diagram of their sites", () => {
  expect(signed(recorded.slice())).toEqual(recorded);
  fc.assert(
    fc.property(fc.constantFrom(...originals), changes, (original, some) => {
      const restored = restoredOrNull(forged(original, some));
      if (restored === null) return;
      expect(validate(restored)).toBeNull();
      const fresh = new Diagram(
        [...restored.ids()].flatMap((id) => Object.values(restored.site(id)).slice(0, 3)),
      );
      expect(restored.visibleSize).toBe(fresh.visibleSize);
      callAll(restored, "none");
      restored.dispose();
      fresh.dispose();
    }),
    { numRuns: 2000 },
  );
});

test("wrong trusted bytes do no harm to anything else", () => {
  const other = built(),
    before = snapshot(other);
  let accepted = 0;
  fc.assert(
    fc.property(fc.constantFrom(...originals), changes, (original, some) => {
      const restored = restoredOrNull(forged(original, some), { trusted: true });
      if (restored === null) return;
      ++accepted;
      callAll(restored, "corrupt-snapshot|unknown-site");
      restored.dispose();
    }),
    { numRuns: 2000 },
  );
  expect(accepted).toBeGreaterThan(500);
  expect(snapshot(other)).toBe(before);
  expect(validate(other)).toBeNull();
});

test.each([
  "hang",
  "find_out_of_bounds",
  "validate_clean_find_wrong",
  "area_of_no_cell",
])("tests/data/snapshots/forged_%s.bin", (name) => {
  const bytes = new Uint8Array(
    readFileSync(path.join(root, `tests/data/snapshots/forged_${name}.bin`)),
  );
  expect(signed(bytes.slice())).toEqual(bytes);
  corrupt(bytes);
  callAll(Diagram.fromBytes(bytes, { trusted: true }), "corrupt-snapshot|unknown-site");
});

test("trusted bytes of one's own give the same diagram", () => {
  const diagram = built(),
    bytes = diagram.toBytes();
  for (const trusted of [true, false, undefined]) {
    const restored = Diagram.fromBytes(bytes, { trusted });
    expect(restored.toBytes()).toEqual(bytes);
    expect(snapshot(restored)).toBe(snapshot(diagram));
    expect(validate(restored)).toBeNull();
  }
  for (const trusted of [null, 1, "yes", {}]) {
    expectRefusal(() => Diagram.fromBytes(bytes, { trusted }), "bad-option", "options.trusted");
  }
});

test("a refused snapshot leaves no diagram behind", () => {
  const bytes = new Diagram(randomCircles(20_000, 32)).toBytes();
  bytes[bytes.length - 1] ^= 1;
  for (let k = 0; k < 300; ++k) corrupt(bytes); // 300 diagrams would be 1.5 GB
  expect(validate(Diagram.fromBytes(recorded))).toBeNull();
});

// toBytes: tests/diagram/out_of_memory_test.cpp.
test("lack of memory is said, and changes nothing", () => {
  const output = runInNode(`
    import { Diagram } from "apollonius-diagram";
    import { validate } from "apollonius-diagram/diagnostics";
    const circles = (n) => Float64Array.from(
      { length: 3 * n }, (_, k) => (k * 0.6180339887498949 % 1) * (k % 3 === 2 ? 1 : 1000));
    const diagram = new Diagram(circles(60_000));
    validate(diagram); // which then has room
    const large = diagram.toBytes(), small = new Diagram(circles(3000)).toBytes();
    WebAssembly.Memory.prototype.grow = () => { throw new RangeError("no more memory"); };
    const kept = [];
    const codeOf = (call) => {
      try {
        for (let k = 0; k < 10_000; ++k) kept.push(call());
      } catch (error) {
        return error.code;
      }
    };
    const codes = [codeOf(() => Diagram.fromBytes(large)), codeOf(() => Diagram.fromBytes(small))];
    kept.forEach((one) => one.dispose());
    const same = Buffer.compare(diagram.toBytes(), large);
    console.log(JSON.stringify({ codes, broken: validate(diagram), same }));`);
  expect(JSON.parse(output)).toEqual({
    codes: ["out-of-memory", "out-of-memory"],
    broken: null,
    same: 0,
  });
});

// --- Threads -------------------------------------------------------------------------------------

test("a snapshot moves to a worker thread", () => {
  expect(
    runInNode(`
    import { Worker } from "node:worker_threads";
    import { Diagram } from "apollonius-diagram";
    const diagram = new Diagram([0, 0, 1, 9, 0, 2, 5, 5, 1]);
    diagram.remove(0);
    const worker = new Worker(\`
      import { parentPort } from "node:worker_threads";
      import { Diagram } from "apollonius-diagram";
      parentPort.once("message", (bytes) => {
        parentPort.postMessage([...Diagram.fromBytes(bytes).findMany([8, 0, 5, 6])]);
      });\`, { eval: true });
    const bytes = diagram.toBytes();
    worker.postMessage(bytes, [bytes.buffer]);
    worker.once("message", (ids) => {
      console.log(ids.join(), bytes.length);
      worker.terminate();
    });`),
  ).toBe("1,2 0");
});

test("web/examples/threads.mjs: several threads find what one does", () => {
  copyFileSync(path.join(root, "web/examples/threads.mjs"), path.join(packed, "threads.mjs"));
  expect(capture(process.execPath, ["threads.mjs"], { cwd: packed })).toMatch(
    /^\d+ threads found .* 100000 circles for 1000000 points; 0 differ/,
  );
});
