// The sites around a point in the order of their distance: kNearest and within.
//
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
// inequality again) and is larger, unless the two are identical. So s comes after its parent in the
// forest, and joins the queue when the parent is reported.
#include "diagram/queries.h"

#include <algorithm>
#include <vector>

#include "memory/flat_array.h"
#include "predicate/distance.h"

namespace apollonius::internal {

namespace {

/// A set of slots that costs what is put into it, however large the diagram is: open addressing, at
/// most half full.
class SlotSet {
 public:
  /// Puts it in; was it not there yet?
  bool insert(Slot slot) {
    if (2 * ++size_ > slots_.size()) grow();
    return place(slot);
  }

 private:
  [[nodiscard]] bool place(Slot slot) {
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

  void grow() {
    FlatArray<Slot> old(2 * slots_.size(), kNoSlot);
    old.swap(slots_);
    for (const Slot slot : old) {
      if (slot != kNoSlot) static_cast<void>(place(slot));
    }
  }

  FlatArray<Slot> slots_ = FlatArray<Slot>(256, kNoSlot);
  std::size_t size_ = 0;
};

/// The sites that may come next, the nearest on top.
class Queue {
 public:
  Queue(const DiagramCore& diagram, double x, double y) : diagram_(diagram), x_(x), y_(y) {}

  [[nodiscard]] bool empty() const { return heap_.empty(); }

  void push(Slot slot) {
    const ApproxDistance distance(x_, y_, diagram_.site(slot));
    heap_.push_back({distance.value, distance.bound, slot});
    std::push_heap(heap_.begin(), heap_.end(),
                   [this](const Entry& a, const Entry& b) { return isAfter(a, b); });
  }

  Slot pop() {
    std::pop_heap(heap_.begin(), heap_.end(),
                  [this](const Entry& a, const Entry& b) { return isAfter(a, b); });
    const Slot slot = heap_.back().slot;
    heap_.pop_back();
    return slot;
  }

 private:
  struct Entry {
    double distance;
    double bound;  // of its error
    Slot slot;
  };

  [[nodiscard]] bool isAfter(const Entry& a, const Entry& b) const {
    const double difference = a.distance - b.distance, bound = a.bound + b.bound;
    if (difference > bound || difference < -bound) return difference > 0;
    const Site &sa = diagram_.site(a.slot), &sb = diagram_.site(b.slot);
    if (isNearer(x_, y_, sa, sb)) return true;
    return !isNearer(x_, y_, sb, sa) &&
           diagram_.ids().idOf(a.slot) >
               diagram_.ids().idOf(b.slot);  // identical: any order will do
  }

  const DiagramCore& diagram_;
  double x_, y_;
  FlatArray<Entry> heap_;
};

}  // namespace

void listNearby(const DiagramCore& diagram, double x, double y, std::size_t most,
                const double* farthest, std::vector<SiteId>& sites) {
  sites.clear();
  if (diagram.visibleCount() == 0 || most == 0) return;
  // The distance to a site with its centre at p is minus its weight.
  const Site limit{x, y, farthest != nullptr ? -*farthest : 0};
  Queue queue(diagram, x, y);
  const auto consider = [&](Slot slot) {
    if (farthest == nullptr || compareDistance(x, y, diagram.site(slot), limit) != Sign::kPositive)
      queue.push(slot);
  };
  SlotSet seen;  // of visible sites: a hidden one has one parent
  FlatArray<Slot> candidates;
  const Slot first = diagram.nearest(x, y);
  seen.insert(first);
  consider(first);
  const Graph& graph = diagram.delaunay().graph();
  while (!queue.empty()) {
    const Slot slot = queue.pop();
    sites.push_back(diagram.ids().idOf(slot));
    if (sites.size() == most) return;
    for (Slot child = diagram.hidden().firstChild(slot); child != HiddenForest::kNone;
         child = diagram.hidden().nextSibling(child))
      consider(child);
    const VertexId v = vertexOf(slot);
    if (!graph.hasVertex(v)) continue;  // hidden, or the only visible one
    candidates.clear();
    for (const HalfedgeId h : graph.star(v)) {
      const VertexId neighbor = graph.target(h);
      if (neighbor != kInfinity && seen.insert(slotOf(neighbor)))
        candidates.push_back(slotOf(neighbor));
    }
    // A loop of its own: sites are fetched from memory side by side.
    for (const Slot candidate : candidates) consider(candidate);
  }
}

}  // namespace apollonius::internal
