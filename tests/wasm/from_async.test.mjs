// fromAsync of Diagram and SphericalDiagram: the diagram that `from` makes, while timers run;
// nothing when it is aborted.
import { ApolloniusError, Diagram } from "../../build/packed/consumer.mjs";
import { SphericalDiagram } from "../../build/packed/sphere.mjs";
import { graph } from "./support/graph.mjs";
import { randomCircles } from "./support/random.mjs";

const xyr = randomCircles(30_000, 71, 30);
const items = Array.from({ length: xyr.length / 3 }, (_, k) => ({
  x: xyr[3 * k],
  y: xyr[3 * k + 1],
  r: xyr[3 * k + 2],
}));
/** Are the snapshots the same? (`toEqual` takes seconds for megabytes.) */
const isSame = (one, other) => Buffer.compare(one.toBytes(), other.toBytes()) === 0;
const refused = async (promise) => {
  const error = await promise.then(
    () => undefined,
    (thrown) => thrown,
  );
  expect(error).toBeInstanceOf(ApolloniusError);
  return `${error.code}: ${error.message}`;
};

test("the same diagram as from, with the event loop's turns and progress between", async () => {
  let turns = 0;
  const timer = setInterval(() => ++turns, 0);
  const progress = [];
  const diagram = await Diagram.fromAsync(items, undefined, undefined, undefined, {
    onProgress: (done) => progress.push(done),
  });
  clearInterval(timer);
  expect(turns).toBeGreaterThan(2); // some tens of milliseconds, in slices of 8
  expect(progress.length).toBeGreaterThan(2);
  expect(progress).toEqual([...progress].sort((a, b) => a - b));
  expect(progress.at(-1)).toBe(1);
  expect(isSame(diagram, Diagram.from(items))).toBe(true);
  diagram.insert(1, 2, 3);
  expect(diagram.size).toBe(items.length + 1);
});

// A clock on which each look takes a millisecond: between two turns there are as many looks as a
// slice has milliseconds, and between two looks a portion of the work.
test("a slice is 8 ms long, and the clock is looked at after each few items", async () => {
  const { now } = performance;
  let looks = 0;
  let reads = 0;
  const inSlices = [];
  const inPortions = [];
  performance.now = () => {
    inPortions.push(reads);
    reads = 0;
    return ++looks;
  };
  try {
    let before = 1;
    const x = (item) => {
      ++reads;
      return item.x;
    };
    await Diagram.fromAsync(items, x, (item) => item.y, {
      onProgress: () => {
        inSlices.push(looks - before);
        before = looks + 1; // that of the next slice's beginning
      },
    });
  } finally {
    performance.now = now;
  }
  expect(Math.max(...inSlices)).toBe(9);
  expect(inSlices.length).toBeGreaterThan(items.length / 256 / 8);
  expect(Math.max(...inPortions)).toBe(256);
});

test("accessors, iterables, options and small sets", async () => {
  const built = async (...of) => graph(await Diagram.fromAsync(...of));
  const few = items.slice(0, 100);
  const expected = graph(Diagram.from(few));
  expect(await built(new Set(few))).toEqual(expected);
  expect(await built(few.map(({ x, y, r }) => [x, y, r]))).toEqual(expected);
  const accessors = ["x", "y", "r"].map((name) => (_, index, all) => all[index][name]);
  expect(await built(few, ...accessors, {})).toEqual(expected);
  const flat = few.flatMap(({ x, y, r }) => [x, y, r]);
  for (const numbers of [flat, Float64Array.from(flat)])
    expect(await built(numbers, {})).toEqual(expected);
  const points = graph(Diagram.from(few, { r: 3 }));
  const pairs = few.flatMap(({ x, y }) => [x, y]);
  expect(graph(new Diagram(pairs, { r: 3 }))).toEqual(points);
  expect(await built(few, { r: 3 })).toEqual(points);
  expect(await built(Float32Array.from(pairs), { r: 3 })).toEqual(
    graph(new Diagram(Float32Array.from(pairs), { r: 3 })),
  );
  for (const count of [0, 1, 2])
    expect(await built(few.slice(0, count))).toEqual(graph(Diagram.from(few.slice(0, count))));
});

test("options may come behind the items, or behind accessors for x and y", async () => {
  const few = items.slice(0, 100);
  const expected = graph(Diagram.from(few));
  const progress = [];
  const options = { onProgress: (done) => progress.push(done) };
  expect(graph(await Diagram.fromAsync(few, options))).toEqual(expected);
  expect(progress.at(-1)).toBe(1);
  for (const none of [{}, undefined])
    expect(graph(await Diagram.fromAsync(few, none))).toEqual(expected);
  const accessors = [(d) => d.x, (d) => d.y];
  const points = graph(Diagram.from(few, ...accessors));
  expect(graph(await Diagram.fromAsync(few, ...accessors, options))).toEqual(points);
  const reason = new Error("enough");
  const controller = new AbortController();
  const { signal } = controller;
  await expect(Diagram.fromAsync(items, { signal: AbortSignal.abort(reason) })).rejects.toBe(
    reason,
  );
  const onProgress = (done) => done >= 0.3 && controller.abort(reason);
  await expect(Diagram.fromAsync(items, { signal, onProgress })).rejects.toBe(reason);
});

test("with two accessors, points", async () => {
  const accessors = [(d) => d.x, (d) => d.y];
  const diagram = await Diagram.fromAsync(items, ...accessors);
  expect(isSame(diagram, Diagram.from(items, ...accessors))).toBe(true);
  expect(diagram.site(7)).toEqual({ ...items[7], r: 0 });
  const none = [undefined, {}];
  expect(graph(await Diagram.fromAsync(items.slice(0, 50), ...accessors, ...none))).toEqual(
    graph(Diagram.from(items.slice(0, 50), ...accessors)),
  );
});

test("aborted before and in the middle: the signal's reason", async () => {
  const reason = new Error("enough");
  await expect(
    Diagram.fromAsync(items, undefined, undefined, undefined, {
      signal: AbortSignal.abort(reason),
    }),
  ).rejects.toBe(reason);
  for (const at of [0, 0.05, 0.3, 0.9]) {
    const controller = new AbortController();
    await expect(
      Diagram.fromAsync(items, undefined, undefined, undefined, {
        signal: controller.signal,
        onProgress: (done) => done >= at && controller.abort(reason),
      }),
    ).rejects.toBe(reason);
  }
});

test("what accessors and onProgress throw", async () => {
  const error = new Error("own");
  const fail = () => {
    throw error;
  };
  await expect(Diagram.fromAsync(items, fail, fail)).rejects.toBe(error);
  await expect(
    Diagram.fromAsync(items, undefined, undefined, undefined, { onProgress: fail }),
  ).rejects.toBe(error);
});

test("what is refused, named", async () => {
  const options = (given) => Diagram.fromAsync(items, undefined, undefined, undefined, given);
  expect(await refused(Diagram.fromAsync(7))).toMatch("bad-length: items is 7");
  expect(await refused(Diagram.fromAsync(items, 7))).toMatch("bad-option: x is 7");
  expect(await refused(Diagram.fromAsync(items, { signal: 7 }))).toMatch("options.signal is 7");
  expect(await refused(Diagram.fromAsync(items, { sinal: 7 }))).toMatch("options.sinal is unknown");
  expect(await refused(Diagram.fromAsync(items, { r: "7" }))).toMatch("options.r is the string");
  expect(await refused(Diagram.fromAsync([0, 1, 2, 0, NaN, 2]))).toMatch("xyr[4] is NaN");
  // They come last.
  expect(await refused(Diagram.fromAsync(items, {}, () => 1))).toMatch("options are not last");
  expect(await refused(Diagram.fromAsync(items, {}, {}))).toMatch("options are not last");
  expect(await refused(options({ signal: 7 }))).toMatch("bad-option: options.signal is 7");
  expect(await refused(options({ signal: null }))).toMatch("options.signal is null");
  expect(await refused(options({ onProgress: 7 }))).toMatch("bad-option: options.onProgress is 7");
  expect(await refused(options({ progress: 7 }))).toMatch(
    "bad-option: options.progress is unknown",
  );
  expect(await refused(options({ location: "grid" }))).toMatch("bad-option: options.location");
  const last = [...items.slice(0, 20_000), { x: 1, y: NaN, r: 1 }];
  expect(await refused(Diagram.fromAsync(last))).toMatch("not-finite: y of item 20000 is NaN");
});

test("several at once", async () => {
  const parts = [0, 1, 2].map((k) => items.slice(10_000 * k, 10_000 * (k + 1)));
  const diagrams = await Promise.all(parts.map((part) => Diagram.fromAsync(part)));
  diagrams.forEach((diagram, k) => {
    expect(isSame(diagram, Diagram.from(parts[k]))).toBe(true);
  });
});

describe("on the sphere", () => {
  const places = items.map(({ x, y, r }) => ({
    lon: 180 * Math.sin(x),
    lat: 89 * Math.sin(y),
    r: r / 1e5,
  }));
  const radius = 6371;
  const aborted = (done, options) => {
    const controller = new AbortController();
    const reason = new Error("enough");
    const onProgress = (now) => now >= done && controller.abort(reason);
    const promise = SphericalDiagram.fromAsync(places, {
      ...options,
      signal: controller.signal,
      onProgress,
    });
    return expect(promise).rejects.toBe(reason);
  };

  test("the same diagram as from, with the event loop's turns and progress between", async () => {
    let turns = 0;
    const timer = setInterval(() => ++turns, 0);
    const progress = [];
    const onProgress = (done) => progress.push(done);
    const diagram = await SphericalDiagram.fromAsync(places, { radius, onProgress });
    clearInterval(timer);
    expect(turns).toBeGreaterThan(2);
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
    expect(diagram.radius).toBe(radius);
    expect(isSame(diagram, SphericalDiagram.from(places, { radius }))).toBe(true);
  });

  test("accessors, GeoJSON, options behind two of them, and small sets", async () => {
    const few = places.slice(0, 100);
    const expected = SphericalDiagram.from(few);
    const accessors = ["lon", "lat", "r"].map((name) => (_, index, all) => all[index][name]);
    const same = async (...given) =>
      expect(isSame(await SphericalDiagram.fromAsync(...given), expected)).toBe(true);
    await same(new Set(few));
    await same(few, ...accessors);
    await same(few, ...accessors, { radius: 1 });
    const points = SphericalDiagram.from(few, accessors[0], accessors[1]);
    const features = few.map(({ lon, lat }) => ({
      type: "Feature",
      properties: {},
      geometry: { type: "Point", coordinates: [lon, lat] },
    }));
    for (const given of [
      [few, accessors[0], accessors[1], {}],
      [{ type: "FeatureCollection", features }],
    ]) {
      expect(isSame(await SphericalDiagram.fromAsync(...given), points)).toBe(true);
    }
    for (const count of [0, 1, 2, 3]) {
      const sites = places.slice(0, count);
      const diagram = await SphericalDiagram.fromAsync(sites);
      expect(isSame(diagram, SphericalDiagram.from(sites))).toBe(true);
    }
  });

  test("aborted before and in the middle: the signal's reason", async () => {
    for (const done of [0, 0.05, 0.12, 0.3, 0.9]) await aborted(done, { radius });
    const reason = new Error("enough");
    const signal = AbortSignal.abort(reason);
    await expect(SphericalDiagram.fromAsync(places, { signal })).rejects.toBe(reason);
  });

  test("what is refused, named", async () => {
    const of = async (...given) => refused(SphericalDiagram.fromAsync(...given));
    expect(await of(7)).toMatch("bad-length: items is 7");
    expect(await of(places, 7)).toMatch("bad-option: lon is 7");
    expect(await of(places, { signal: 7 })).toMatch("bad-option: options.signal is 7");
    expect(await of(places, { location: "walk" })).toMatch("options.location is unknown");
    expect(await of(places, { radius: 0 })).toMatch("out-of-range: options.radius is 0");
    const last = [...places.slice(0, 20_000), { lon: 1, lat: 91, r: 1 }];
    expect(await of(last)).toMatch("out-of-range: lat of item 20000 is 91");
  });
});
