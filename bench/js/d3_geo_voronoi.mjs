// d3-geo-voronoi as a contender: points on the sphere.
import { geoVoronoi } from "d3-geo-voronoi";
import { forMilliseconds } from "./sampling.mjs";
import { sphereOperations } from "./sphere.mjs";

const pairs = (numbers) =>
  Array.from({ length: numbers.length / 3 }, (_, k) => [numbers[3 * k], numbers[3 * k + 1]]);

export const operations = sphereOperations({
  make: (lonLatR) => geoVoronoi(pairs(lonLatR)),
  end: () => {},
  find: (voronoi, lon, lat) => voronoi.find(lon, lat),
  polygons: (voronoi) => voronoi.polygons(),
});

export function warmUp() {
  const points = () => Array.from({ length: 500 }, () => [360 * Math.random(), 90 * Math.random()]);
  forMilliseconds(700, () => {
    const voronoi = geoVoronoi(points());
    for (let k = 0; k < 100; ++k) voronoi.find(360 * Math.random(), 90 * Math.random());
    voronoi.polygons();
  });
}
