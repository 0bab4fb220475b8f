// A diagram's whole state in words that do not depend on its history: sites by value instead of by
// id, rows sorted.

/** The state that a failed call must not change, ids included. */
export function snapshot(diagram) {
  const ids = [...diagram.ids()];
  return JSON.stringify({
    ids,
    sites: ids.map((id) => diagram.site(id)),
    hidden: ids.map((id) => diagram.isHidden(id)),
    neighbors: ids.map((id) => [...diagram.neighbors(id)]),
    graph: graph(diagram),
    sizes: [diagram.size, diagram.visibleSize],
  });
}

/** The graph with each site named by its circle: equal for equal sets of sites. */
export function graph(diagram) {
  const { sites: corners } = diagram.vertices();
  const edges = diagram.edges();
  const name = (id) => {
    const { x, y, r } = diagram.site(id);
    return `${x},${y},${r}`;
  };
  const vertex = (row) =>
    row === -1 ? "unbounded" : smallestRotation([0, 1, 2].map((k) => name(corners[3 * row + k])));
  return {
    vertices: Array.from({ length: corners.length / 3 }, (_, row) => vertex(row)).sort(),
    edges: Array.from({ length: edges.sites.length / 2 }, (_, row) => {
      const [a, b] = [name(edges.sites[2 * row]), name(edges.sites[2 * row + 1])];
      const [from, to] = [vertex(edges.vertices[2 * row]), vertex(edges.vertices[2 * row + 1])];
      // the same edge, walked either way
      return [`${a} | ${b}: ${from} -> ${to}`, `${b} | ${a}: ${to} -> ${from}`].sort()[0];
    }).sort(),
  };
}

function smallestRotation([a, b, c]) {
  return [
    [a, b, c],
    [b, c, a],
    [c, a, b],
  ]
    .map((names) => names.join(" "))
    .sort()[0];
}
