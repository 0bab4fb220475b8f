// fromBytesAsync of both surfaces: the diagram that `fromBytes` makes, in slices; nothing when it
// is aborted, or when the bytes are none.
import { Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { randomCircles } from "./support/random.mjs";
import { expectRejection } from "./support/refusal.mjs";
import { signed } from "./support/signed.mjs";

const xyr = randomCircles(30_000, 81, 30);
const lonLatR = xyr.map((number, k) =>
  k % 3 === 0 ? 180 * Math.sin(number) : k % 3 === 1 ? 89 * Math.sin(number) : number / 1e3,
);
/** Removed sites leave free ids, and some sites are hidden. */
const withHistory = (diagram) => {
  diagram.removeMany(Uint32Array.from({ length: 999 }, (_, k) => 7 * k + 3));
  return diagram;
};
const plane = withHistory(new Diagram(xyr));
const sphere = withHistory(new SphericalDiagram(lonLatR, { radius: 6371 }));
const isSame = (one, other) => Buffer.compare(one.toBytes(), other.toBytes()) === 0;

const kinds = [
  ["Diagram", Diagram, plane, {}],
  ["Diagram, trusted", Diagram, plane, { trusted: true }],
  ["SphericalDiagram", SphericalDiagram, sphere, {}],
];

describe.each(kinds)("%s", (_, Class, diagram, options) => {
  const bytes = diagram.toBytes();

  test("what fromBytes gives, of all kinds of bytes", async () => {
    for (const given of [bytes, bytes.buffer, Buffer.from(bytes)]) {
      const restored = await Class.fromBytesAsync(given, options);
      expect(isSame(restored, Class.fromBytes(bytes, options))).toBe(true);
      expect([...restored.neighbors(5)]).toEqual([...diagram.neighbors(5)]);
      expect(restored.hiddenSize).toBe(diagram.hiddenSize);
      const id = restored.insert(1, 2, 3);
      expect(restored.has(id)).toBe(true);
    }
    const empty = new Class();
    expect((await Class.fromBytesAsync(empty.toBytes(), options)).size).toBe(0);
    const one = new Class([10, 20, 1]);
    expect((await Class.fromBytesAsync(one.toBytes(), options)).find(0, 0)).toBe(0);
  });

  test("bytes are taken at the call", async () => {
    const changing = bytes.slice();
    const promise = Class.fromBytesAsync(changing, options);
    changing.fill(0);
    expect(isSame(await promise, diagram)).toBe(true);
  });

  test("progress rises to 1", async () => {
    const progress = [];
    const onProgress = (done) => progress.push(done);
    await Class.fromBytesAsync(bytes, { ...options, onProgress });
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
    expect(progress[0]).toBeGreaterThanOrEqual(0);
    expect(progress.at(-1)).toBe(1);
  });

  test("aborted, the signal's reason; what onProgress throws", async () => {
    const reason = new Error("enough");
    const signal = AbortSignal.abort(reason);
    await expect(Class.fromBytesAsync(bytes, { ...options, signal })).rejects.toBe(reason);
    for (const at of [0, 0.3, 0.9]) {
      const controller = new AbortController();
      const onProgress = (done) => done >= at && controller.abort(reason);
      const promise = Class.fromBytesAsync(bytes, {
        ...options,
        signal: controller.signal,
        onProgress,
      });
      await expect(promise).rejects.toBe(reason);
    }
    const fail = () => {
      throw reason;
    };
    await expect(Class.fromBytesAsync(bytes, { ...options, onProgress: fail })).rejects.toBe(
      reason,
    );
  });

  test("what is no snapshot is refused", async () => {
    const wrong = (given, more) => () => Class.fromBytesAsync(given, { ...options, ...more });
    await expectRejection(wrong(new Uint8Array(56)), "corrupt-snapshot", "no snapshot");
    await expectRejection(wrong(bytes.subarray(8)), "corrupt-snapshot", "no snapshot");
    await expectRejection(wrong([1, 2]), "bad-length", "expected a Uint8Array or an ArrayBuffer");
    await expectRejection(wrong(bytes, { signal: 1 }), "bad-option", "options.signal is 1");
    await expectRejection(wrong(bytes, { sinal: 1 }), "bad-option", "options.sinal is unknown");
    for (let at = 0; at < bytes.length; at += 99_991) {
      const flipped = bytes.slice();
      flipped[at] ^= 1;
      await expectRejection(wrong(flipped), "corrupt-snapshot", "no snapshot");
    }
  });
});

// A clock on which each look takes a millisecond: a slice has as many portions as it has looks.
test("the verification is done in portions, with a turn of the event loop after some", async () => {
  const { now } = performance;
  let looks = 0;
  performance.now = () => ++looks;
  let turns = 0;
  try {
    const onProgress = () => ++turns;
    await Diagram.fromBytesAsync(plane.toBytes(), { onProgress });
  } finally {
    performance.now = now;
  }
  // Faces and half-edges, 256 at a time
  const portions = (8 * (plane.visibleSize - 2)) / 256;
  expect(turns).toBeGreaterThan(portions / 10);
});

test("a forged snapshot with a right checksum is refused in the middle of its proof", async () => {
  const bytes = new Diagram(randomCircles(2000, 82, 0)).toBytes();
  // Two sites change places: the graph is no longer theirs.
  const [one, other] = [0, 1500].map((slot) => 32 + 24 * slot);
  const site = bytes.slice(one, one + 24);
  bytes.copyWithin(one, other, other + 24);
  bytes.set(site, other);
  signed(bytes);
  await expectRejection(() => Diagram.fromBytesAsync(bytes), "corrupt-snapshot", "no snapshot");
  expect((await Diagram.fromBytesAsync(bytes, { trusted: true })).size).toBe(2000);
});
