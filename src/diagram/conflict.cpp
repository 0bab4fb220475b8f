#include "diagram/conflict.h"

#include "diagram/delaunay_graph.h"
#include "diagram/invariant.h"
#include "predicate/predicates.h"

namespace apollonius {

void ConflictSearch::find(const DelaunayGraph& diagram, const Site& q, VertexId near, HalfedgeId sector) {
  // Wiped before, not after: a call that ran out of memory leaves marks behind.
  for (const FaceId f : touched_) marks_[index(f)] = Mark::kUnknown;
  touched_.clear();
  faces_.clear();
  rim_.clear();
  stack_.clear();
  diagram_ = &diagram;
  q_ = &q;
  if (marks_.size() < diagram.graph().faceSlots()) marks_.resize(diagram.graph().faceSlots(), Mark::kUnknown);
  if (sector == kNoHalfedge || !startInSector(sector)) startAround(near);
  expand();
}

/// Enters a face if it is in conflict; then the region is to be expanded from its sides.
bool ConflictSearch::startAt(FaceId f) {
  if (!isInConflict(f)) return false;
  enter(f);
  for (unsigned c = 3; c-- > 0;) stack_.push_back(halfedgeOf(f, c));
  return true;
}

/// Neither end of the edge is in conflict: is its interior? Then that is all of the region.
bool ConflictSearch::startWithin(HalfedgeId h) {
  const HalfedgeId twin = diagram_->graph().twin(h);
  if (!isInteriorInConflict(diagram_->edge(h), diagram_->circle(faceOf(h)), diagram_->circle(faceOf(twin)), *q_)) return false;
  rim_.push_back(h);
  rim_.push_back(twin);
  return true;
}

/// The edge across which the ray from the nearest site through q's centre leaves the cell is in conflict (paper, section 3.4).
bool ConflictSearch::startInSector(HalfedgeId sector) {
  return startAt(faceOf(sector)) || startAt(faceOf(diagram_->graph().twin(sector))) || startWithin(sector);
}

/// Some edge of the nearest site's cell is in conflict (paper, Lemma 2).
void ConflictSearch::startAround(VertexId near) {
  const Graph& graph = diagram_->graph();
  const HalfedgeId begin = graph.outgoing(near);
  HalfedgeId h = begin;
  do {
    if (startAt(faceOf(h))) return;
    h = graph.rotateCcw(h);
  } while (h != begin);
  do {
    if (startWithin(h)) return;
    h = graph.rotateCcw(h);
  } while (h != begin);
  invariant(false, "a site that is not covered is in conflict with an edge of its nearest site (Lemma 2)");
}

/// The paper's depth-first search with a stack of half-edges instead of recursion. The half-edges on the stack and on the rim,
/// in order, always bound the region found so far; popping them counter-clockwise yields the rim counter-clockwise.
void ConflictSearch::expand() {
  const Graph& graph = diagram_->graph();
  while (!stack_.empty()) {
    const HalfedgeId h = stack_.back();
    stack_.pop_back();
    const HalfedgeId across = graph.twin(h);
    const FaceId beyond = faceOf(across);
    if (!isInConflict(beyond) || !isEntirelyInConflict(h)) {
      rim_.push_back(h);  // q's cell ends on this edge; if both its ends are in conflict, its twin gets here too
      continue;
    }
    // An edge between two faces of the region closes a cycle around a site that q covers: no rim (its twin is dropped too).
    if (marks_[index(beyond)] == Mark::kInRegion) continue;
    enter(beyond);
    stack_.push_back(previous(across));
    stack_.push_back(next(across));
  }
}

void ConflictSearch::enter(FaceId f) {
  marks_[index(f)] = Mark::kInRegion;
  faces_.push_back(f);
}

bool ConflictSearch::isInConflict(FaceId f) {
  Mark& mark = marks_[index(f)];
  if (mark == Mark::kUnknown) {
    touched_.push_back(f);
    mark = diagram_->isFaceInConflict(f, *q_) ? Mark::kConflict : Mark::kClear;
  }
  return mark != Mark::kClear;
}

bool ConflictSearch::isEntirelyInConflict(HalfedgeId h) const {
  return isEntireEdgeInConflict(diagram_->edge(h), diagram_->circle(faceOf(h)), diagram_->circle(faceOf(diagram_->graph().twin(h))),
                                *q_);
}

}  // namespace apollonius
