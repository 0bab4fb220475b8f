#include "delaunay/conflict.h"

#include <algorithm>

#include "base/radix_sort.h"
#include "delaunay/delaunay_graph.h"
#include "predicate/predicates.h"
#include "predicate/stage_counts.h"

namespace apollonius::internal {

void ConflictSearch::begin(const DelaunayGraph& delaunay, const Site& q) {
  // Wiped before, not after: a call that ran out of memory leaves marks behind.
  for (const FaceId f : faces_) marks_[index(f) / kWord] = 0;
  faces_.clear();
  boundary_.clear();
  stack_.clear();
  delaunay_ = &delaunay;
  q_ = &q;
  mayHaveSlits_ = false;
  const std::size_t words = (delaunay.graph().faceSlots() + kWord - 1) / kWord;
  if (marks_.size() < words) marks_.resize(words, 0);
}

void ConflictSearch::find(const DelaunayGraph& delaunay, const Site& q, VertexId near,
                          HalfedgeId sector) {
  begin(delaunay, q);
  if (sector == kNoHalfedge || !startInSector(sector)) startAround(near);
  expand();
}

bool ConflictSearch::findBeside(const DelaunayGraph& delaunay, const Site& q, VertexId close) {
  constexpr int kFewFaces = 8;
  begin(delaunay, q);
  const Graph& graph = delaunay.graph();
  int faces = 0;
  for (const HalfedgeId h : graph.star(close)) {
    if (++faces > kFewFaces) break;
    // Use the filter only: it means strictly nearer, while the exact rule counts the site of a
    // circle given twice as in conflict.
    const MaybeSign filtered = circleFilter(delaunay.circle(faceOf(h)), q);
    stages::counts().vertexAtOnce += filtered.known;
    if (filtered.known && filtered.sign == Sign::kPositive) {
      startAtConflict(faceOf(h));
      expand();
      return true;
    }
  }
  return false;
}

/// Enters a face if it is in conflict; then the region is to be expanded from its sides.
bool ConflictSearch::startAt(FaceId f) {
  if (!delaunay_->isFaceInConflict(f, *q_)) return false;
  startAtConflict(f);
  return true;
}

void ConflictSearch::startAtConflict(FaceId f) {
  enter(f);
  for (unsigned c = 3; c-- > 0;) stack_.push_back(halfedgeOf(f, c));
}

/// Neither end of the edge is in conflict: is its interior? Then that is all of the region.
bool ConflictSearch::startWithin(HalfedgeId h) {
  const HalfedgeId twin = delaunay_->graph().twin(h);
  if (!isInteriorInConflict(delaunay_->edge(h), delaunay_->circle(faceOf(h)),
                            delaunay_->circle(faceOf(twin)), *q_))
    return false;
  boundary_.push_back(h);
  boundary_.push_back(twin);
  mayHaveSlits_ = true;
  return true;
}

/// The edge across which the ray from the nearest site through q's centre leaves the cell is in
/// conflict (paper, section 3.4).
bool ConflictSearch::startInSector(HalfedgeId sector) {
  return startAt(faceOf(sector)) || startAt(faceOf(delaunay_->graph().twin(sector))) ||
         startWithin(sector);
}

/// Some edge of the nearest site's cell is in conflict (paper, Lemma 2).
void ConflictSearch::startAround(VertexId near) {
  const Graph& graph = delaunay_->graph();
  for (const HalfedgeId h : graph.star(near)) {
    if (startAt(faceOf(h))) return;
  }
  for (const HalfedgeId h : graph.star(near)) {
    if (startWithin(h)) return;
  }
  delaunay_->requireConsistent(
      false,
      "a site that is not covered is in conflict with an edge of its nearest site (Lemma 2)");
}

/// Both ends of the edge are in conflict.
inline bool ConflictSearch::isEntirelyInConflict(HalfedgeId h, HalfedgeId twin,
                                                 const Site& q) const {
  const Graph& graph = delaunay_->graph();
  const VertexId i = graph.origin(h), j = graph.origin(twin);
  const VoronoiCircle &atK = delaunay_->cachedCircle(faceOf(h)),
                      &atL = delaunay_->cachedCircle(faceOf(twin));
  if (i != kInfinity && j != kInfinity &&
      isSurelyInConflictBetweenEnds(delaunay_->site(i), delaunay_->site(j), atK, atL, q)) {
    ++stages::counts().edgeAtOnce;
    shadowCheck({Sign::kPositive, true}, [&] {
      return isEntireEdgeInConflict(delaunay_->edge(h), q) ? Sign::kPositive : Sign::kNegative;
    });
    return true;
  }
  return isEntireEdgeInConflict(delaunay_->edge(h), atK, atL, q);
}

/// The paper's depth-first search with a stack of half-edges instead of recursion. The half-edges
/// on the stack and on the boundary, in order, always bound the region found so far; popping them
/// counter-clockwise yields the boundary counter-clockwise.
///
/// Insertions spend much of their time here. So there is one check of room per face (f connected
/// faces have at most f + 2 sides, on the stack and on the boundary together), and q and the arrays
/// are local variables: the compiler cannot know that writes do not change the members.
void ConflictSearch::expand() {
  if (faces_.empty()) return;
  const Graph& graph = delaunay_->graph();
  const Site q = *q_;
  constexpr std::size_t kUsual = 16;  // faces
  makeRoom(kUsual);
  HalfedgeId *stack = stack_.data(), *boundary = boundary_.data();
  std::size_t onStack = stack_.size(), sides = 0;
  while (onStack > 0) {
    const HalfedgeId h = stack[--onStack];
    const HalfedgeId across = graph.twin(h);
    const FaceId beyond = faceOf(across);
    const bool wasInRegion = isInRegion(beyond);
    if (!wasInRegion && !delaunay_->isFaceInConflict(beyond, q)) {
      boundary[sides++] = h;  // q's cell ends on this edge
      continue;
    }
    if (!isEntirelyInConflict(h, across, q)) {
      boundary[sides++] = h;  // it does so too; as both ends are in conflict, the twin gets here
      mayHaveSlits_ = true;
      continue;
    }
    // An edge between two faces of the region closes a cycle around a site that q covers: no
    // boundary (its twin is dropped too).
    if (wasInRegion) continue;
    if (faces_.size() == faces_.capacity()) {
      stack_.setSize(onStack);
      boundary_.setSize(sides);
      makeRoom(2 * faces_.capacity());
      stack = stack_.data();
      boundary = boundary_.data();
    }
    enter(beyond);
    stack[onStack++] = previous(across);
    stack[onStack++] = next(across);
  }
  stack_.clear();
  boundary_.setSize(sides);
}

/// For this many faces, and what goes with them: a face that enters takes one half-edge from the
/// stack and puts two there; the first puts three.
void ConflictSearch::makeRoom(std::size_t faces) {
  faces_.reserve(faces);
  stack_.reserve(faces_.capacity() + 3);
  boundary_.reserve(faces_.capacity() + 3);
}

inline void ConflictSearch::enter(FaceId f) {
  faces_.push_back(f);  // first: a mark that is not listed would stay
  marks_[index(f) / kWord] |= mark(f);
}

bool ConflictSearch::isDisk() const {
  if (faces_.empty()) return true;  // an edge that is opened
  const Graph& graph = delaunay_->graph();
  FlatArray<Keyed> boundary(boundary_.size()), corners(boundary_.size());
  for (std::uint32_t k = 0; k < boundary.size(); ++k) {
    boundary[k] = {static_cast<std::uint32_t>(boundary_[k]), k};
    corners[k] = {static_cast<std::uint32_t>(graph.origin(boundary_[k])), k};
  }
  sortByKey(boundary);
  sortByKey(corners);
  const auto isAmong = [](const FlatArray<Keyed>& entries, auto id) {
    const auto key = static_cast<std::uint32_t>(id);
    const auto isBefore = [](const Keyed& entry, std::uint32_t other) { return entry.key < other; };
    const Keyed* const at = std::lower_bound(entries.begin(), entries.end(), key, isBefore);
    return at != entries.end() && at->key == key;
  };
  for (std::size_t k = 0; k < boundary_.size(); ++k) {
    const HalfedgeId h = boundary_[k], twin = graph.twin(h);
    if (isInRegion(faceOf(twin)) && !isAmong(boundary, twin)) return false;
    // The side that follows, around h's target.
    HalfedgeId side = next(h);
    while (!isAmong(boundary, side)) {
      const HalfedgeId across = graph.twin(side);
      if (!isInRegion(faceOf(across)) || next(across) == next(h)) return false;
      side = next(across);
    }
    if (side != boundary_[k + 1 < boundary_.size() ? k + 1 : 0]) return false;
  }
  for (const FaceId f : faces_) {
    for (unsigned c = 0; c < 3; ++c) {
      const VertexId v = graph.origin(halfedgeOf(f, c));
      if (!isAmong(corners, v) && (v == kInfinity || !covers(*q_, delaunay_->site(v))))
        return false;
    }
  }
  return true;
}

}  // namespace apollonius::internal
