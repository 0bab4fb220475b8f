// One history with all outputs of the package, as one hash: the same script in Node and in
// browsers. Every call of every class is in it (determinism.test.mjs).

/** Bytes of all kinds of values, one behind the other; numbers with all their bits. */
class Bytes {
  #bytes = new Uint8Array(2 ** 20);
  #length = 0;
  #number = new Float64Array(1);
  #bytesOfNumber = new Uint8Array(this.#number.buffer);
  add(value) {
    if (typeof value === "string") return this.#push(new TextEncoder().encode(`${value}\0`));
    if (typeof value === "number") {
      this.#number[0] = value;
      return this.#push(this.#bytesOfNumber);
    }
    if (typeof value !== "object" || value === null) return this.add(String(value));
    if (ArrayBuffer.isView(value)) {
      this.add(value.length);
      return this.#push(new Uint8Array(value.buffer, value.byteOffset, value.byteLength));
    }
    const entries = Object.entries(value);
    this.add(entries.length);
    for (const [key, inner] of entries) {
      this.add(key);
      this.add(inner);
    }
  }
  #push(bytes) {
    const length = this.#length + bytes.length;
    if (length > this.#bytes.length) {
      const larger = new Uint8Array(2 * length);
      larger.set(this.#bytes);
      this.#bytes = larger;
    }
    this.#bytes.set(bytes, this.#length);
    this.#length = length;
  }
  async hash() {
    const whole = this.#bytes.subarray(0, this.#length);
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

export async function hashOfAllOutputs(code) {
  const { Diagram, curvePoint, curveTangent, validate } = code;
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
    bytes.add(String(validate(diagram)));
    bytes.add(await fitted(Diagram.fromBytes(snapshot)));
    if (name === "random" || name === "grid") await addWindows(code, diagram, bytes, random);
    diagram.clear();
    bytes.add([String(diagram), diagram.size]);
    diagram.dispose();
  }
  await addSphere(code, bytes);
  bytes.add(
    code.enclose([
      { x: 1, y: 2, r: 3 },
      { x: 40, y: -7, r: 1 },
      { x: 9, y: 30, r: 2 },
    ]),
  );
  addTreemap(code, bytes);
  return bytes.hash();
}

/** The answer of a call, or its error's code. */
function answered(call) {
  try {
    return call();
  } catch ({ code }) {
    return code;
  }
}

/** Adds calls for which one scene of a kind is enough: shapes, and values in all windows. */
async function addWindows({ levels }, diagram, bytes, random) {
  const [xs, ys] = ["x", "y"].map((key) => Array.from(diagram, (site) => site[key]));
  const [xmin, xmax, ymin, ymax] = [xs, ys].flatMap((all) => [Math.min(...all), Math.max(...all)]);
  const at = (u, v) => [xmin + u * (xmax - xmin), ymin + v * (ymax - ymin)];
  const points = Array.from({ length: 400 }, () => at(random(), random())).flat();
  const values = Float64Array.from({ length: Math.max(...diagram.ids()) + 1 }, () => random());
  bytes.add([diagram.toJSON(), levels(diagram), diagram.triangulation(), diagram.has(3)]);
  bytes.add([diagram.pickMany(points), diagram.withinMany(points, 2, { distances: true })]);
  const ring = (...places) => places.map(([u, v]) => at(u, v));
  const outer = ring([0.1, 0.05], [0.9, 0.1], [0.7, 0.5], [0.95, 0.9], [0.2, 0.8]);
  const hole = ring([0.4, 0.3], [0.45, 0.6], [0.6, 0.4]);
  const bend = (x) => (x * x) / (8 * (xmax - xmin));
  const project = ([x, y]) => [x, y + bend(x)];
  project.invert = ([x, y]) => [x, y - bend(x)];
  const reach = (xmax - xmin) / 40;
  for (const view of [
    diagram.voronoi([...at(-0.1, -0.1), ...at(1.1, 1.2)]),
    diagram.voronoi([outer, hole]),
    diagram.voronoi([outer, hole], { maxDistance: reach }),
    diagram.voronoi([outer, hole], { project }),
  ]) {
    const ids = diagram.ids().subarray(0, 40);
    bytes.add([
      view.toGeoJSON(),
      view.toGeoJSON({ group: (id) => id % 7 }),
      view.edgeCurves(),
      view.edges({ clearance: true }),
      view.vertices(),
      view.cellCentroids(),
      view.cellPerimeters(),
      view.cellAreas(),
      Array.from({ length: 10 }, (_, k) =>
        answered(() => view.naturalWeights(points[2 * k], points[2 * k + 1], { r: k })),
      ),
      view.interpolate(values, points),
      await view.interpolateAsync(values, points, { r: 1 }),
      answered(() => view.largestEmptyCircle()),
      answered(() => view.largestEmptyCircle({ inside: true })),
      answered(() => view.emptyCircles(7)),
      answered(() => view.emptyCircles(7, { inside: true })),
      answered(() => view.cellCircles()),
      await view.cellCirclesAsync(),
      Array.from(ids, (id) => answered(() => view.cellCircle(id, { aspect: 3 }))),
      Array.from(ids, (id) => view.renderCell(id)),
      view.renderCells(null, { digits: 3 }),
      view.window.area,
      view.window.centroid,
    ]);
    view.dispose();
  }
  const copy = diagram.constructor.fromBytes(diagram.toBytes());
  const targets = new Map(Array.from(copy.ids(), (id) => [id, 1 + (id % 3)]));
  bytes.add(answered(() => copy.voronoi([outer]).fitAreas(targets)));
  copy.dispose();
}

async function addSphere({ SphericalDiagram, validate }, bytes) {
  const random = generator(1234);
  const somewhere = () => [360 * random() - 180, 170 * random() - 85];
  const sites = (n) => Array.from({ length: n }, () => [...somewhere(), 300 * random()]).flat();
  const globe = new SphericalDiagram(sites(150), { radius: 6371 });
  globe.insert(12, 34, 5);
  globe.insertMany([0, 90, 0, 180, 0, 7, 12, 34, 5]);
  globe.update(3, 11, 33, 2);
  globe.updateMany([4, 5], [10, 20, 3, -10, 20, 3]);
  globe.remove(9);
  globe.removeMany([7, 8]);
  const ids = globe.ids();
  const points = Array.from({ length: 200 }, somewhere).flat();
  const values = Float64Array.from({ length: Math.max(...ids) + 1 }, () => random());
  bytes.add([
    [globe.radius, globe.size, globe.visibleSize, globe.hiddenSize, String(globe), globe.has(3)],
    [globe.sites(), globe.toJSON(), globe.vertices(), globe.edges(), validate(globe)],
    [globe.edges({ clearance: true }), globe.triangulation()],
    [globe.nearestMany(points), globe.pickMany(points)],
    [globe.kNearestMany(points, 4, { distances: true }), globe.withinMany(points, 900)],
    [globe.voronoi().largestEmptyCircle(), globe.voronoi().emptyCircles(12)],
    [globe.voronoi().interpolate(values, points), globe.voronoi().cellMesh()],
    await globe.voronoi().interpolateAsync(values, points, { r: 1 }),
    await globe.voronoi().cellCirclesAsync(),
    globe.toBytes(),
  ]);
  for (let k = 0; k < 30; ++k) {
    const place = somewhere();
    bytes.add([
      [globe.find(...place), globe.nearest(...place), globe.farthest(...place)],
      [globe.kNearest(...place, 5), globe.within(...place, 2000), globe.pick(...place)],
      globe.voronoi().naturalWeights(...place, { r: 10 * k }),
    ]);
  }
  for (const maxDistance of [Infinity, 400, (id) => 10 * id]) {
    const view = globe.voronoi({ maxDistance });
    bytes.add([view.cellAreas(), view.cellCentroids(), view.cellPerimeters()]);
    bytes.add([view.toGeoJSON(), [...view.cellPolygons()]]);
    bytes.add([view.toGeoJSON({ antimeridian: "keep", tolerance: 6 }), String(view)]);
    bytes.add([view.vertices(), view.edges()]);
    for (const id of ids.subarray(0, 40))
      bytes.add([
        [globe.site(id), globe.isHidden(id), globe.coverOf(id), globe.neighbors(id)],
        [view.cellArea(id), view.cellPerimeter(id), view.cellMeasures(id)],
        [view.cellCentroid(id), view.cellPolygon(id), view.cellGeometry(id)],
        [view.cellCircle(id)],
        [view.contains(id, ...somewhere()), view.neighbors(id)],
      ]);
  }
  for (const few of [
    [5, 6, 0.7],
    [5, 6, 0.7, -100, 60, 0.3],
  ])
    bytes.add(new SphericalDiagram(few).voronoi().emptyCircles(5));
  globe.clear();
  globe.dispose();
}

function addTreemap({ treemap }, bytes) {
  const group = (data, children) => ({
    data,
    value: children.reduce((sum, { value }) => sum + value, 0),
    children,
  });
  const leaves = (length) =>
    Array.from({ length }, (_, data) => ({ data, value: 1 + ((data * 7 + length) % 11) }));
  const root = group(
    "all",
    [3, 5, 8, 2].map((length) => group(length, leaves(length))),
  );
  for (const shape of [[0, 0, 300, 200], { x: 5, y: 5, r: 90 }]) {
    const laid = treemap().shape(shape).padding(2)(structuredClone(root));
    const visit = (node) => {
      const { area, centroid, polygon, circle, fit } = node;
      bytes.add([area, centroid, polygon, circle, fit]);
      bytes.add([node.label(), node.label({ aspect: 3 })]);
      bytes.add([node.render(), node.render(null, { tolerance: 1 })]);
      for (const child of node.children ?? []) visit(child);
    };
    visit(laid);
  }
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
    edges: diagram.edges({ clearance: true }),
    hull: diagram.hull(),
    around: diagram.smallestEnclosingCircle(),
  });
  for (const id of ids.slice(0, 100))
    bytes.add([diagram.isHidden(id), diagram.coverOf(id), diagram.neighbors(id)]);
  const points = Float64Array.from(Array.from({ length: 100 }, somewhere).flat());
  bytes.add(diagram.nearestMany(points));
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
    mesh: voronoi.cellMesh({ tolerance }),
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
      voronoi.cellGeometry(id),
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
