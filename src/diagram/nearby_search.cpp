// Growing over the graph. Claim: in the order of (distance to p, ties to the larger site), each
// visible site s but the first one has a Delaunay neighbour before it. So the next visible site is
// always among the neighbours of those reported so far.
//   Proof. Ties first: perturb the weights as the canonical rule does (docs/PREDICATES.md,
//   "Degenerate position"), larger sites by infinitely larger amounts. The graph is that of the
//   perturbed sites, the order is that of their distances, no two distances to p are equal, and two
//   cells that meet in a point share an edge. Now walk from p straight to the centre of s. At a
//   point x of the way d(x, s) = d(p, s) - |x - p|, and d(x, u) >= d(p, u) - |x - p| for any other
//   site u (triangle inequality). The way ends in the cell of s, because d(c_s, u) <= d(c_s, s) =
//   -r_s would mean that u covers s; and it does not start there, because s is not the first. Where
//   it enters that cell for the last time, it comes from the cell of a neighbour u with d(x, u) =
//   d(x, s), hence d(p, u) <= d(p, s), and not equal: u is before s.
//
// Hidden sites: a site that covers s, |c - c_s| <= r - r_s, is nowhere farther than s (triangle
// inequality again) and is larger, or it is identical and has a lesser id. So s comes after its
// parent in the forest, and joins the queue when the parent is reported.
#include "diagram/nearby_search.h"

#include <algorithm>

namespace apollonius::internal {

bool SlotSet::write(Slot slot) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = (slot * 0x9E3779B1u) >> 7 & mask;
  for (; slots_[at] != kNoSlot; at = (at + 1) & mask) {
    if (slots_[at] == slot) {
      --size_;
      return false;
    }
  }
  slots_[at] = slot;
  return true;
}

void SlotSet::grow() {
  FlatArray<Slot> old(2 * slots_.size(), kNoSlot);
  old.swap(slots_);
  for (const Slot slot : old) {
    if (slot != kNoSlot) static_cast<void>(write(slot));
  }
}

NearbySearch::NearbySearch(const DiagramCore& diagram, double x, double y, double maxDistance)
    : diagram_(diagram) {
  start(x, y, maxDistance);
}

Slot NearbySearch::start(double x, double y, double maxDistance, Slot hint) {
  x_ = x;
  y_ = y;
  maxDistance_ = maxDistance;
  last_ = kNoSlot;
  heap_.clear();
  seen_.clear();
  if (diagram_.visibleCount() == 0) return kNoSlot;
  const Slot first = diagram_.nearest(x, y, hint);
  seen_.insert(first);
  consider(first);
  return first;
}

bool NearbySearch::isAfter(const Entry& a, const Entry& b) const {
  const double difference = a.distance - b.distance, bound = a.bound + b.bound;
  if (difference > bound || difference < -bound) return difference > 0;
  const Site &sa = diagram_.site(a.slot), &sb = diagram_.site(b.slot);
  if (isNearer(x_, y_, sa, sb)) return true;
  return !isNearer(x_, y_, sb, sa) &&
         diagram_.ids().idOf(a.slot) > diagram_.ids().idOf(b.slot);  // identical
}

void NearbySearch::consider(Slot slot) {
  const Site& site = diagram_.site(slot);
  if (isBeyond(x_, y_, site, maxDistance_)) return;
  const ApproxDistance distance(x_, y_, site);
  heap_.push_back({distance.value, distance.bound, slot});
  std::push_heap(heap_.begin(), heap_.end(),
                 [this](const Entry& a, const Entry& b) { return isAfter(a, b); });
}

void NearbySearch::follow(Slot slot) {
  const HiddenForest& hidden = diagram_.hidden();
  for (Slot child = hidden.firstChild(slot); child != HiddenForest::kNone;
       child = hidden.nextSibling(child))
    consider(child);
  const Graph& graph = diagram_.delaunay().graph();
  const VertexId v = vertexOf(slot);
  if (!graph.hasVertex(v)) return;  // hidden, or the only visible one
  candidates_.clear();
  for (const HalfedgeId h : graph.star(v)) {
    const VertexId neighbor = graph.target(h);
    if (neighbor != kInfinity && seen_.insert(slotOf(neighbor)))
      candidates_.push_back(slotOf(neighbor));
  }
  // A loop of its own: sites are fetched from memory side by side.
  for (const Slot candidate : candidates_) consider(candidate);
}

Slot NearbySearch::next() {
  if (last_ != kNoSlot) follow(last_);
  last_ = kNoSlot;
  if (heap_.empty()) return kNoSlot;
  std::pop_heap(heap_.begin(), heap_.end(),
                [this](const Entry& a, const Entry& b) { return isAfter(a, b); });
  last_ = heap_.back().slot;
  heap_.pop_back();
  return last_;
}

}  // namespace apollonius::internal
