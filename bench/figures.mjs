// The figures of a benchmark that documents quote: medians in microseconds per circle or query, and
// ratios of them.

/** @param {{ machine: any, records: any[] }} result of a whole run */
export function figuresOf({ machine, records }) {
  const us = (part, n, op, contender, family = "random5") =>
    records.find(
      (record) =>
        record.part === part &&
        record.family === family &&
        record.n === n &&
        record.op === op &&
        record.contender === contender,
    )?.us;
  const million = (op, ...who) =>
    Object.fromEntries(who.map((contender) => [contender, us("scaling", 1e6, op, contender)]));
  const built = (n) =>
    Object.fromEntries(
      ["wasm", "delaunator", "flatbush"].map((who) => [who, us("scaling", n, "build", who)]),
    );
  const toRandom = (family) =>
    us("families", 1e5, "build", "wasm", family) / us("families", 1e5, "build", "wasm");
  const memory = records.find(({ op }) => op === "memory");
  const node = machine.node.slice(1).split(".")[0];
  return {
    machine: `${machine.cores} cores of ${machine.cpu}, Node ${node}`,
    build: million("build", "wasm", "native", "cgal", "delaunator"),
    find: million("find", "wasm", "native", "cgal", "flatbush"),
    findMany: million("findMany", "wasm", "native"),
    remove: million("remove", "wasm", "native", "cgal"),
    buildOf: { 1000: built(1e3), 10000: built(1e4), 100000: built(1e5) },
    toRandom: Object.fromEntries(
      ["lattice", "collinear", "decimal"].map((family) => [family, toRandom(family)]),
    ),
    fromBytes: us("snapshots", 1e6, "fromBytes", "wasm"),
    bytesPerSite: Math.round(memory.bytesPerSite),
  };
}
