// d3-voronoi-treemap as a contender: straight edges; sites move. It is given the weights as they
// are (by default it raises those below a hundredth of the largest), and otherwise its defaults.
import { voronoiTreemap } from "d3-voronoi-treemap";
import { kHeight, kWidth, treemapOperations } from "./treemaps.mjs";

function layOut(root) {
  let state = 1;
  voronoiTreemap()
    .clip([
      [0, 0],
      [0, kHeight],
      [kWidth, kHeight],
      [kWidth, 0],
    ])
    .minWeightRatio(1e-9)
    .prng(() => {
      state = (state * 48271) % 2147483647;
      return state / 2147483647;
    })(root);
}

function areaOf({ polygon }) {
  const twice = polygon.reduce((sum, [x, y], k) => {
    const [nextX, nextY] = polygon[(k + 1) % polygon.length];
    return sum + x * nextY - y * nextX;
  }, 0);
  return Math.abs(twice / 2);
}

export const operations = treemapOperations({ treemapMove: layOut }, areaOf);
