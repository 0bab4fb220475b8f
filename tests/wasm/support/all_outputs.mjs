// One history with all outputs of the package, as one hash: the same script in Node and in
// browsers.

/** Bytes of all kinds of values, one behind the other; numbers with all their bits. */
class Bytes {
  #parts = [];
  add(value) {
    if (typeof value === "string") return this.#push(new TextEncoder().encode(`${value}\0`));
    if (typeof value === "number") return this.#push(new Uint8Array(Float64Array.of(value).buffer));
    if (typeof value !== "object" || value === null) return this.add(String(value));
    if (ArrayBuffer.isView(value)) {
      this.add(value.length);
      return this.#push(new Uint8Array(value.buffer, value.byteOffset, value.byteLength).slice());
    }
    const entries = Object.entries(value);
    this.add(entries.length);
    for (const [key, inner] of entries) {
      this.add(key);
      this.add(inner);
    }
  }
  #push(bytes) {
    this.#parts.push(bytes);
  }
  async hash() {
    const whole = new Uint8Array(await new Blob(this.#parts).arrayBuffer());
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", whole));
    const digits = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0"));
    return `${whole.length} bytes ${digits.join("")}`;
  }
}

/** A 32-bit xorshift, as in random.mjs: a page cannot import that from here. */
function generator(seed) {
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

const families = {
  random: (u) => [1000 * u() - 500, 1000 * u() - 500, 30 * u()],
  grid: (u) => [Math.floor(20 * u()), Math.floor(20 * u()), Math.floor(2 * u())],
  tangent: (u) => [4 * Math.floor(8 * u()), 0.5 * Math.floor(9 * u()), 2],
  decimal: (u) => [
    Math.floor(100 * u()) * 0.1,
    Math.floor(100 * u()) * 0.1,
    Math.floor(5 * u()) * 0.1,
  ],
  tiny: (u) => [u() * 1e-30, u() * 1e-30, u() * 1e-31],
  huge: (u) => [u() * 1e60, u() * 1e60, u() * 1e58],
};

export async function hashOfAllOutputs({ Diagram, curvePoint, curveTangent }) {
  const bytes = new Bytes();
  for (const [name, circle] of Object.entries(families)) {
    const random = generator(4711);
    const below = (n) => Math.floor(random() * n);
    const circles = (n) => Array.from({ length: n }, () => circle(random)).flat();
    bytes.add(name);
    const diagram = new Diagram(circles(300));
    const everything = () => outputs(diagram, bytes, random, curvePoint, curveTangent);
    everything();
    for (let step = 0; step < 200; ++step) {
      const ids = diagram.ids();
      const id = ids[below(ids.length)];
      const [x, y, r] = circle(random);
      const kind = below(4);
      if (kind === 0) bytes.add(diagram.insert(x, y, r));
      if (kind === 1) bytes.add(diagram.remove(id));
      if (kind === 2) diagram.update(id, x, y, r);
      if (kind === 3)
        diagram.update(id, diagram.site(id).x, diagram.site(id).y, diagram.site(id).r * random());
    }
    bytes.add(diagram.insertMany(circles(60)));
    bytes.add(diagram.removeMany(diagram.ids().slice(0, 100)));
    const some = diagram.ids().slice(0, 50);
    diagram.updateMany(some, circles(some.length));
    everything();
    const snapshot = diagram.toBytes();
    bytes.add(snapshot);
    bytes.add(Diagram.fromBytes(snapshot).toBytes());
    bytes.add(String(diagram.validate()));
    bytes.add(await fitted(Diagram.fromBytes(snapshot)));
    diagram.dispose();
  }
  return bytes.hash();
}

/** The weights found, and areas with them; or the code of why there are none. */
async function fitted(diagram) {
  const { ids, xyr } = diagram.sites();
  const [xs, ys] = [0, 1].map((at) => xyr.filter((_, k) => k % 3 === at));
  const margin = Math.max(...xs) - Math.min(...xs);
  const voronoi = diagram.voronoi([
    Math.min(...xs) - margin,
    Math.min(...ys) - margin,
    Math.max(...xs) + margin,
    Math.max(...ys) + margin,
  ]);
  try {
    const targets = new Map(Array.from(ids, (id) => [id, 1 + (id % 3)]));
    return [await voronoi.fitAreasAsync(targets, { tolerance: 1e-13 }), voronoi.cellAreas()];
  } catch ({ code }) {
    return code;
  }
}

function outputs(diagram, bytes, random, curvePoint, curveTangent) {
  const ids = diagram.ids();
  const sites = Array.from(ids, (id) => diagram.site(id));
  const [xs, ys] = ["x", "y"].map((key) => sites.map((site) => site[key]));
  const bounds = [Math.min(...xs), Math.min(...ys), Math.max(...xs) * 0.9, Math.max(...ys) * 0.8];
  const [width, height] = [bounds[2] - bounds[0], bounds[3] - bounds[1]];
  const tolerance = 1e-3 * width;
  const somewhere = () => [
    bounds[0] + width * (2 * random() - 0.5),
    bounds[1] + height * (2 * random() - 0.5),
  ];

  bytes.add({
    ids,
    sites,
    sizes: [diagram.size, diagram.visibleSize, diagram.hiddenSize],
    vertices: diagram.vertices(),
    edges: diagram.edges(),
    hull: diagram.hull(),
    around: diagram.smallestEnclosingCircle(),
  });
  for (const id of ids.slice(0, 100))
    bytes.add([diagram.isHidden(id), diagram.coverOf(id), diagram.neighbors(id)]);
  const points = Float64Array.from(Array.from({ length: 100 }, somewhere).flat());
  const distances = new Float64Array(100);
  bytes.add([diagram.findMany(points, distances), distances]);
  bytes.add([diagram.findMany(points), diagram.findMany(points.subarray(0, 20))]);
  bytes.add(diagram.kNearestMany(points, 5, { distances: true }));
  const [x0, y0] = somewhere();
  bytes.add([diagram.within(x0, y0, Infinity), diagram.search(-Infinity, y0, x0, Infinity)]);
  for (let k = 0; k < 20; ++k) {
    const [x, y] = somewhere();
    bytes.add([
      diagram.find(x, y),
      diagram.nearest(x, y),
      diagram.farthest(x, y),
      diagram.kNearest(x, y, 5),
      diagram.within(x, y, width / 10),
      diagram.kNearest(x, y, 5, { maxDistance: width, filter: (id) => id % 2 === 0 }),
      diagram.pick(x, y),
      diagram.search(x, y, x + width / 10, y + width / 20),
    ]);
  }

  const voronoi = diagram.voronoi(bounds);
  bytes.add({
    cells: voronoi.cellAreas(),
    edges: voronoi.edgeCurves(),
    polygons: [...voronoi.cellPolygons({ tolerance })],
    flat: [...voronoi.cellPolygons({ tolerance, flat: true })],
    geo: voronoi.toGeoJSON({ tolerance }),
  });
  for (const id of ids.slice(0, 60)) {
    bytes.add([
      voronoi.cellPolygon(id),
      voronoi.cellParts(id),
      voronoi.cellPolygon(id, { flat: true }),
      voronoi.cellParts(id, { flat: true }),
      voronoi.cellArea(id),
      voronoi.cellCentroid(id),
      voronoi.cellPerimeter(id),
      voronoi.cellMeasures(id),
      voronoi.cellWithin(id, width / 20),
      voronoi.cellWithin(id, Infinity),
      voronoi.neighbors(id),
      voronoi.contains(id, ...somewhere()),
    ]);
    const cell = voronoi.cellCurves(id);
    bytes.add(cell);
    if (cell === null) continue;
    for (let k = 0; 7 * k < cell.curves.length; ++k) {
      for (const t of [0, 0.3, 1])
        bytes.add([curvePoint(cell.curves, k, t), curveTangent(cell.curves, k, t)]);
    }
  }
  for (const digits of [undefined, ...Array(16).keys()]) {
    bytes.add([voronoi.render(null, { digits }), voronoi.renderBounds(null, { digits })]);
  }
  bytes.add([
    diagram.render(null, { bounds }),
    diagram.renderSites(),
    diagram.renderHull(),
    voronoi.renderCell(ids[0]),
  ]);
}
