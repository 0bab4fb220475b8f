// Breaks a graph on purpose, for tests of the checks: the one friend that may write to its arrays.
#pragma once

#include "topology/graph.h"

namespace apollonius::internal {

class GraphBreaker {
 public:
  explicit GraphBreaker(Graph& graph) : graph_(graph) {}

  VertexId& origin(HalfedgeId h) { return graph_.halfedges_[index(h)].origin; }
  HalfedgeId& twin(HalfedgeId h) { return graph_.halfedges_[index(h)].twin; }
  HalfedgeId& outgoing(VertexId v) { return graph_.outgoing_[index(v)]; }
  HalfedgeId& firstFree() { return graph_.firstFree_; }
  std::size_t& freeFaces() { return graph_.freeFaces_; }

  void sew(HalfedgeId h, HalfedgeId g) { graph_.sew(h, g); }
  FaceId addFace(VertexId a, VertexId b, VertexId c) {
    const FaceId f = graph_.takeFace();
    graph_.setFace(f, a, b, c);
    return f;
  }
  void freeFace(FaceId f) { graph_.freeFace(f); }
  void truncateHalfedges() { graph_.halfedges_.pop_back(); }

 private:
  Graph& graph_;
};

}  // namespace apollonius::internal
