// Insertion in the paper's three stages (section 3): location of the nearest site, test whether it
// covers the new one, conflict region and starring.
#include <algorithm>

#include "delaunay/delaunay_graph.h"
#include "number/invariant.h"
#include "predicate/compute_circle.h"

namespace apollonius::internal {

VertexId DelaunayGraph::findConflict(ConflictSearch& conflicts, const Site& q, VertexId start,
                                     Walk walk) const {
  // Often a conflict is found at once. Then the first two stages are superfluous: a covered site
  // has no conflict.
  if (!conflicts.findBeside(*this, q, start)) {
    const Located near = locate(q.x, q.y, start, walk);
    if (covers(site(near.nearest), q)) return near.nearest;  // Lemma 1
    conflicts.find(*this, q, near.nearest, near.sector);
  }
  if (!isProven_ && !conflicts.boundary().empty())
    requireConsistent(conflicts.isDisk(), "the conflict region is a disk");
  return kNoVertex;
}

DelaunayGraph::Insertion DelaunayGraph::prepareInsertion(VertexId v, VertexId start, Walk walk) {
  invariant(!isVisible(v), "a site enters a graph once");
  const Site& q = site(v);
  entry_ = Entry::kAlone;
  if (visibleCount_ == 0) return {kNoVertex, 0, 0, 0};
  if (visibleCount_ == 1) return prepareBesideOne(v);
  const VertexId cover = findConflict(conflicts_, q, visibleStart(start), walk);
  if (cover != kNoVertex) return {cover, 0, 0, 0};
  if (conflicts_.boundary().empty()) return prepareCoveringAll(v);

  entry_ = Entry::kInHole;
  const std::size_t removed = conflicts_.faces().size();
  const std::size_t created = conflicts_.boundary().size();
  reserveFaces(removed, created);
  const std::span<const HalfedgeId> boundary = conflicts_.boundary();
  for (std::size_t k = 0; k < created; ++k) fan_.setCorner(k, corner(graph_.origin(boundary[k])));
  fan_.compute(q, {newCircles_.data(), created});
  // At most as many as the region has cycles: f faces connected by e edges have e - f + 1 cycles,
  // and 3 f - 2 e sides.
  const std::size_t covered = removed + 2 > created ? (removed + 2 - created) / 2 : 0;
  return {kNoVertex, created, covered, std::max(created, removed)};
}

DelaunayGraph::Insertion DelaunayGraph::prepareBesideOne(VertexId v) {
  const VertexId first = recent_;
  if (covers(site(first), site(v))) return {first, 0, 0, 0};
  if (covers(site(v), site(first))) return prepareCoveringAll(v);
  entry_ = Entry::kBesideOne;
  reserveFaces(0, 2);
  newCircles_[0] = voronoiCircle(corner(first), corner(v), nullptr);
  newCircles_[1] = voronoiCircle(corner(v), corner(first), nullptr);
  return {kNoVertex, 0, 0, 0};
}

/// Prepares a site that covers every visible one: it remains alone.
DelaunayGraph::Insertion DelaunayGraph::prepareCoveringAll(VertexId v) {
  entry_ = Entry::kCoveringAll;
  covered_.clear();
  if (visibleCount_ == 1) {
    covered_.push_back(recent_);
  } else {
    graph_.listVertices(covered_);
  }
  for (std::size_t k = 0; !isProven_ && k < covered_.size(); ++k) {
    requireConsistent(covers(site(v), site(covered_[k])), "what has no boundary covers all");
  }
  return {kNoVertex, 0, covered_.size(), 2 * covered_.size()};
}

DelaunayGraph::Insertion DelaunayGraph::prepareReplacing(VertexId v, VertexId twin) {
  if (visibleCount_ == 1) return prepareCoveringAll(v);
  entry_ = Entry::kReplacing;
  covered_.assign(1, twin);
  std::size_t degree = 0;
  for ([[maybe_unused]] const HalfedgeId h : graph_.star(twin)) ++degree;
  return {kNoVertex, degree, 1, degree};
}

std::span<const VertexId> DelaunayGraph::insertPrepared(VertexId v) noexcept {
  std::span<const VertexId> covered;
  switch (entry_) {
    case Entry::kAlone:
      visibleCount_ = 1;
      break;
    case Entry::kBesideOne:
      graph_.makePair(recent_, v, newFaces(2));
      takeCircles(2);
      visibleCount_ = 2;
      break;
    case Entry::kInHole: {
      const std::size_t created = conflicts_.boundary().size();
      covered = graph_.starHole(v, conflicts_.faces(), conflicts_.boundary(), newFaces(created),
                                conflicts_.mayHaveSlits());
      takeCircles(created);
      visibleCount_ += 1 - covered.size();
      break;
    }
    case Entry::kCoveringAll:
      covered = covered_;
      graph_.clear();
      visibleCount_ = 1;
      break;
    case Entry::kReplacing:
      covered = covered_;
      graph_.replaceVertex(covered_[0], v);
      break;
  }
  recent_ = v;
  return covered;
}

}  // namespace apollonius::internal
