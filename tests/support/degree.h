// How many faces a vertex has, which is what inserting it has made and removing it takes away.
#pragma once

#include <cstddef>

#include "diagram/diagram_core.h"

namespace apollonius::test {

using namespace internal;

/// 0 outside of the graph.
inline std::size_t degree(const Graph& graph, VertexId v) {
  if (!graph.hasVertex(v)) return 0;
  std::size_t n = 0;
  HalfedgeId h = graph.outgoing(v);
  do {
    ++n;
    h = graph.rotateCcw(h);
  } while (h != graph.outgoing(v));
  return n;
}

/// Degree of a site; 0 for a hidden one.
inline std::size_t degree(const DiagramCore& core, SiteId id) {
  return degree(core.delaunay().graph(), vertexOf(core.ids().slotOf(id)));
}

}  // namespace apollonius::test
