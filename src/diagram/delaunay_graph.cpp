#include "diagram/delaunay_graph.h"

#include <algorithm>

namespace apollonius {

bool DelaunayGraph::isFaceInConflictByCorners(FaceId f, const Site& q) const {
  const Corner i = corner(graph_.origin(halfedgeOf(f, 0))), j = corner(graph_.origin(halfedgeOf(f, 1))), k = corner(graph_.origin(halfedgeOf(f, 2)));
  // The circle has been asked before.
  return kShadowCheck ? isVertexInConflict(circle(f), i, j, k, q) : isVertexInConflict(i, j, k, q);
}

void DelaunayGraph::reserve(std::size_t slots) {
  reserveSites(slots);
  graph_.reserveVertices(slots);  // last: who looks at its size finds room for all
}

void DelaunayGraph::reserveFaces(std::size_t removed, std::size_t created) {
  graph_.reserveFaces(removed, created);
  fan_.reserve(created);
  if (newCircles_.size() < created) {
    newFaces_.resize(created);
    newCircles_.resize(created);
  }
  const std::size_t slots = graph_.faceSlots() + (created > removed ? created - removed : 0);
  if (circles_.size() < slots) {
    if (circles_.capacity() < slots) circles_.reserve(slots + slots / 2);
    circles_.resize(slots);
  }
}

void DelaunayGraph::reserveBulk(std::size_t sites) {
  const std::size_t faces = 2 * (visibleCount_ + sites);  // Euler: 2 (V + 1) - 4 with infinity
  graph_.reserveFacesInAll(faces);
  circles_.reserve(faces);
  conflicts_.reserve(faces);
}

void DelaunayGraph::clear() noexcept {
  graph_.clear();
  visibleCount_ = 0;
  recent_ = kNoVertex;
}

}  // namespace apollonius
