// The neighbours of infinity, which are the vertices of the hull.
#pragma once

#include "topology/graph.h"

namespace apollonius::internal {

/// Visits the half-edges from vertices to infinity, counter-clockwise around the hull: all of them,
/// so that a vertex can occur several times. Cost: O(their number).
template <class Visit>
void visitHull(const Graph& graph, Visit&& visit) {
  if (graph.isEmpty()) return;
  const HalfedgeId begin = graph.twin(graph.outgoing(kInfinity));
  HalfedgeId h = begin;
  do {
    visit(h);
    h = graph.twin(next(h));  // face (i, infinity, k): k follows i
  } while (h != begin);
}

}  // namespace apollonius::internal
