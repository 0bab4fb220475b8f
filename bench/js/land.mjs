// The outline of the world's land (Natural Earth 1:50 million, through world-atlas) on an
// equal-area map, and other windows of odd shapes.
import { createRequire } from "node:module";

// Loaded only when needed: bench/run.mjs is read before `npm ci` may have installed it.
const require = createRequire(import.meta.url);

const kEarthRadius = 6371; // km

/** Lambert's cylindrical projection: km. */
export const equalArea = (longitude, latitude) => [
  (kEarthRadius * longitude * Math.PI) / 180,
  kEarthRadius * Math.sin((latitude * Math.PI) / 180),
];

/** The outline of the land, as rings of points in km. */
export function landRings() {
  const { feature } = require("topojson-client");
  const topology = require("world-atlas/land-50m.json");
  const { features } = feature(topology, topology.objects.land);
  return features
    .flatMap(({ geometry }) => geometry.coordinates.flat())
    .map((ring) => ring.map(([longitude, latitude]) => equalArea(longitude, latitude)));
}

/** Returns the rings of the land, moved into the box of some sites. */
export function landRingsIn([xmin, ymin, xmax, ymax]) {
  const [halfWidth, halfHeight] = equalArea(180, 90);
  const moved = ([x, y]) => [
    xmin + ((xmax - xmin) * (x / halfWidth + 1)) / 2,
    ymin + ((ymax - ymin) * (y / halfHeight + 1)) / 2,
  ];
  return landRings().map((ring) => ring.map(moved));
}

/** Points on an ellipse whose radius goes up and down. */
function wavyRing([x, y], [rx, ry], points, waves, depth) {
  return Array.from({ length: points }, (_, k) => {
    const angle = (2 * Math.PI * k) / points;
    const r = 1 - depth * (1 + Math.sin(waves * angle)) * 0.5;
    return [x + rx * r * Math.cos(angle), y + ry * r * Math.sin(angle)];
  });
}

const middleOf = ([xmin, ymin, xmax, ymax]) => [(xmin + xmax) / 2, (ymin + ymax) / 2];
const halfOf = ([xmin, ymin, xmax, ymax]) => [(xmax - xmin) / 2, (ymax - ymin) / 2];

/** A wavy shape with three holes in a box. */
export function holedRings(box) {
  const [x, y] = middleOf(box);
  const [rx, ry] = halfOf(box);
  const holes = [
    [-0.35, -0.2, 0.16],
    [0.3, 0.3, 0.2],
    [0.35, -0.35, 0.1],
  ];
  return [
    wavyRing([x, y], [rx, ry], 400, 7, 0.2),
    ...holes.map(([dx, dy, r]) =>
      wavyRing([x + dx * rx, y + dy * ry], [r * rx, r * ry], 60, 3, 0.2),
    ),
  ];
}

/** One ring of a thousand segments across a box. */
export const thousandSegments = (box) => [wavyRing(middleOf(box), halfOf(box), 1000, 250, 0.6)];

/** A smooth star of that many points in a box: five arms with small waves. */
export function starRing(box, points) {
  const [x, y] = middleOf(box);
  const [rx, ry] = halfOf(box);
  return Array.from({ length: points }, (_, k) => {
    const angle = (2 * Math.PI * k) / points;
    const r = (1 + 0.3 * Math.sin(5 * angle) + 0.1 * Math.sin(41 * angle)) / 1.4;
    return [x + rx * r * Math.cos(angle), y + ry * r * Math.sin(angle)];
  });
}

/** Windows of that many points in a box, by name. */
export const sizedRings = {
  disc: (box, points) => [wavyRing(middleOf(box), halfOf(box), points, 0, 0)],
  ring: (box, points) => {
    const half = halfOf(box);
    const inner = half.map((r) => 0.9 * r);
    return [half, inner].map((radii) => wavyRing(middleOf(box), radii, points / 2, 0, 0));
  },
  star: (box, points) => [starRing(box, points)],
  jagged: (box, points) => [wavyRing(middleOf(box), halfOf(box), points, points / 4, 0.6)],
};
