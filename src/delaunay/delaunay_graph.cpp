#include "delaunay/delaunay_graph.h"

#include <algorithm>
#include <limits>
#include <new>

#include "delaunay/proof.h"
#include "number/invariant.h"
#include "predicate/circle_batch.h"
#include "predicate/compute_circle.h"

namespace apollonius::internal {

bool DelaunayGraph::isFaceInConflictByCorners(FaceId f, const Site& q) const {
  const Corner i = corner(graph_.origin(halfedgeOf(f, 0))),
               j = corner(graph_.origin(halfedgeOf(f, 1))),
               k = corner(graph_.origin(halfedgeOf(f, 2)));
  if (cachedCircle(f).isMissing()) {
    computeCircle(f);
    return isFaceInConflict(f, q);
  }
  // The circle has been asked before.
  return kShadowCheck ? isVertexInConflict(circle(f), i, j, k, q) : isVertexInConflict(i, j, k, q);
}

void DelaunayGraph::reserve(std::size_t slots) {
  reserveSites(slots);
  graph_.reserveVertices(slots);  // last: its size tells whether there is room
}

void DelaunayGraph::reserveFaces(std::size_t removed, std::size_t created) {
  graph_.reserveFaces(removed, created);
  fan_.reserve(created);
  if (newCircles_.size() < created) {
    newFaces_.resize(created);
    newCircles_.resize(created);
  }
  const std::size_t slots = graph_.faceSlotsAfter(removed, created);
  if (circles_.size() < slots) {
    if (circles_.capacity() < slots) circles_.reserve(slots + slots / 2);
    circles_.resize(slots);
  }
}

void DelaunayGraph::reserveReturn(std::size_t facesAndSides) {
  conflicts_.reserve(std::max(circles_.capacity(), graph_.faceSlots() + facesAndSides));
  if (facesAndSides <= returnRoom_) return;
  facesAndSides = std::max(facesAndSides, 2 * returnRoom_);
  reserveFaces(facesAndSides, facesAndSides);
  conflicts_.reserveRegion(facesAndSides, facesAndSides);
  covered_.reserve(facesAndSides);
  returnRoom_ = facesAndSides;
}

void DelaunayGraph::reserveBulk(std::size_t sites) {
  const std::size_t faces = 2 * (visibleCount_ + sites);  // Euler: 2 (V + 1) - 4 with infinity
  graph_.reserveFacesInAll(faces);
  circles_.reserve(faces);
  conflicts_.reserve(faces);
}

void DelaunayGraph::replaceStar(VertexId v, std::span<const HalfedgeId> link,
                                std::span<const Graph::PatchFace> patch,
                                std::span<const VoronoiCircle> circles, std::size_t newSites,
                                bool mayReturn) {
  // Two sides of each other would be the sides of a whole sphere.
  const bool isSphere = patch.empty() && graph_.twin(link[0]) == link[1];
  requireConsistent(!isSphere, "the star of a site is not all there is");
  reserveFaces(link.size(), patch.size());
  if (mayReturn) reserveReturn(std::max(link.size(), patch.size()));
  // Some visible neighbour, should v be the vertex that walks start from.
  const VertexId a = patch.empty() ? graph_.origin(link[0]) : patch[0].corners[0];
  const VertexId b = patch.empty() ? graph_.target(link[0]) : patch[0].corners[1];
  const VertexId neighbour = a != kInfinity ? a : b;
  std::copy(circles.begin(), circles.end(), newCircles_.begin());
  graph_.replaceStar(v, link, patch, newFaces(patch.size()));
  takeCircles(patch.size());
  visibleCount_ += newSites;
  --visibleCount_;
  if (recent_ == v) recent_ = neighbour;
}

void DelaunayGraph::becomeSingle(VertexId v) noexcept {
  clear();
  visibleCount_ = v == kNoVertex ? 0 : 1;
  recent_ = v;
}

void DelaunayGraph::clear() noexcept {
  graph_.clear();
  visibleCount_ = 0;
  recent_ = kNoVertex;
  mayMissCircles_ = false;
  isProven_ = true;
  isBroken_ = false;
}

/// Within operations that would end as if memory had run out: nothing has been changed.
void DelaunayGraph::markCorrupt(const char* name) const {
  invariant(!isProven_, name);
  isBroken_ = true;
  throw std::bad_alloc();
}

void DelaunayGraph::computeCircle(FaceId f) const {
  const EdgeCorners corners = edge(halfedgeOf(f, 0));
  circles_[index(f)] = voronoiCircle(corners.i, corners.j, corners.k);
}

void DelaunayGraph::restoreGraph(const Graph& graph) noexcept {
  if (!graph.isEmpty()) graph_ = graph;
  circles_.assign(circles_.size(), kMissingCircle);
  mayMissCircles_ = true;
}

void DelaunayGraph::computeMissingCircles() const {
  if (!mayMissCircles_) return;
  CircleBatch batch([this](std::uint32_t f, const VoronoiCircle& circle) {
    if (circle.error < std::numeric_limits<float>::infinity()) {
      circles_[f] = circle;
    } else {
      computeCircle(FaceId{f});
    }
  });
  for (const FaceId f : graph_.faces()) {
    if (!cachedCircle(f).isMissing()) continue;
    const EdgeCorners corners = edge(halfedgeOf(f, 0));
    if (corners.i == nullptr || corners.j == nullptr || corners.k == nullptr) {
      computeCircle(f);
    } else {
      batch.add(static_cast<std::uint32_t>(f), {corners.i, corners.j, corners.k});
    }
  }
  batch.finish();
  mayMissCircles_ = false;
}

Proof DelaunayGraph::beginProof() { return {*this, circles_}; }

bool DelaunayGraph::endProof(const Proof& proof) {
  isProven_ = proof.contradiction() == nullptr;
  mayMissCircles_ = !isProven_;
  return isProven_;
}

}  // namespace apollonius::internal
