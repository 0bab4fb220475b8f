// flatbush as a contender: a static R-tree of the centres; the nearest one through `neighbors`.
import Flatbush from "flatbush";
import { forMilliseconds, readCentres, sampled, sampledQueries } from "./sampling.mjs";

let current = { set: "" };

function load({ set }) {
  if (set !== current.set) current = { set, centres: readCentres(set), tree: undefined };
}

function builtTree() {
  const { centres } = current;
  const tree = new Flatbush(centres.length / 2);
  for (let k = 0; k < centres.length; k += 2)
    tree.add(centres[k], centres[k + 1], centres[k], centres[k + 1]);
  tree.finish();
  return tree;
}

function build(request) {
  load(request);
  return sampled(request, current.centres.length / 2, () => {
    current.tree = builtTree();
  });
}

function find(request) {
  load(request);
  current.tree ??= builtTree();
  const { tree } = current;
  return sampledQueries(
    request,
    (points) => (k) => tree.neighbors(points[2 * k], points[2 * k + 1], 1)[0],
  );
}

export const operations = { build, find, findNear: find };

export function warmUp() {
  current = { set: "", centres: Float64Array.from({ length: 4000 }, Math.random) };
  forMilliseconds(700, () => {
    current.tree = builtTree();
    for (let k = 0; k < 1000; ++k) current.tree.neighbors(Math.random(), Math.random(), 1);
  });
}
