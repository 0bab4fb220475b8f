// Insertion in the paper's three stages (section 3): nearest site, is the new one covered by it,
// conflict region and starring.
#include <algorithm>

#include "delaunay/delaunay_graph.h"
#include "number/invariant.h"
#include "predicate/compute_circle.h"

namespace apollonius::internal {

DelaunayGraph::Insertion DelaunayGraph::insert(VertexId v, VertexId start, Walk walk,
                                               InsertionObserver* observer) {
  invariant(!isVisible(v), "a site enters a graph once");
  const Site& q = site(v);
  if (visibleCount_ == 0) {
    visibleCount_ = 1;
    recent_ = v;
    return {kNoVertex, {}};
  }
  if (visibleCount_ == 1) return insertBesideOne(v, observer);
  start = visibleStart(start);
  // Often a conflict is found at once, which makes the first two stages superfluous: a covered site
  // has none.
  if (!conflicts_.findBeside(*this, q, start)) {
    const Located near = locate(q.x, q.y, start, walk);
    if (covers(site(near.nearest), q)) return {near.nearest, {}};  // Lemma 1
    conflicts_.find(*this, q, near.nearest, near.sector);
  }
  if (conflicts_.boundary().empty()) return coverAll(v, observer);
  if (!isProven_) requireConsistent(conflicts_.isDisk(), "the conflict region is a disk");

  const std::size_t removed = conflicts_.faces().size();
  const std::size_t created = conflicts_.boundary().size();
  reserveFaces(removed, created);
  const std::span<const HalfedgeId> boundary = conflicts_.boundary();
  for (std::size_t k = 0; k < created; ++k) fan_.setCorner(k, corner(graph_.origin(boundary[k])));
  fan_.compute(q, {newCircles_.data(), created});
  // As many as the region has cycles: f faces that hang together by e edges have e - f + 1, and 3 f
  // - 2 e sides.
  const std::size_t covered = removed + 2 > created ? (removed + 2 - created) / 2 : 0;
  if (observer != nullptr && observer->makeRoom(created, covered))
    reserveReturn(std::max(created, removed));
  const std::span<const VertexId> lost = graph_.starHole(
      v, conflicts_.faces(), conflicts_.boundary(), newFaces(created), conflicts_.mayHaveSlits());
  takeCircles(created);
  visibleCount_ += 1 - lost.size();
  recent_ = v;
  return {kNoVertex, lost};
}

DelaunayGraph::Insertion DelaunayGraph::insertBesideOne(VertexId v, InsertionObserver* observer) {
  const VertexId first = recent_;
  if (covers(site(first), site(v))) return {first, {}};
  if (covers(site(v), site(first))) return coverAll(v, observer);
  reserveFaces(0, 2);
  newCircles_[0] = voronoiCircle(corner(first), corner(v), nullptr);
  newCircles_[1] = voronoiCircle(corner(v), corner(first), nullptr);
  graph_.makePair(first, v, newFaces(2));
  takeCircles(2);
  visibleCount_ = 2;
  recent_ = v;
  return {kNoVertex, {}};
}

/// The new site covers every visible one: it remains alone.
DelaunayGraph::Insertion DelaunayGraph::coverAll(VertexId v, InsertionObserver* observer) {
  covered_.clear();
  if (visibleCount_ == 1) {
    covered_.push_back(recent_);
  } else {
    graph_.listVertices(covered_);
  }
  for (std::size_t k = 0; !isProven_ && k < covered_.size(); ++k) {
    requireConsistent(covers(site(v), site(covered_[k])), "what has no boundary covers all");
  }
  if (observer != nullptr && observer->makeRoom(0, covered_.size()))
    reserveReturn(2 * covered_.size());
  graph_.clear();
  visibleCount_ = 1;
  recent_ = v;
  return {kNoVertex, covered_};
}

}  // namespace apollonius::internal
