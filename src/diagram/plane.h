// The plane as a search around a point sees it (diagram/nearby_search.h).
#pragma once

#include "diagram/diagram_core.h"
#include "diagram/nearby_search.h"
#include "predicate/distance.h"
#include "predicate/point.h"

namespace apollonius::internal {

/// Ties as in DiagramCore::nearest(), identical circles ascending by id.
class Plane {
 public:
  using Point = internal::Point;
  using Site = Slot;
  static constexpr Slot kNone = kNoSlot;

  struct Entry {
    double distance;
    double bound;  // the error is not larger
    Slot site;
  };

  explicit Plane(const DiagramCore& diagram) : diagram_(&diagram) {}

  /// `hint`: a visible site close to the point, or kNoSlot.
  [[nodiscard]] Slot nearest(const Point& p, Slot hint = kNoSlot) const {
    return diagram_->visibleCount() == 0 ? kNoSlot : diagram_->nearest(p.x, p.y, hint);
  }
  [[nodiscard]] Entry entry(const Point& p, Slot slot) const {
    const ApproxDistance distance(p.x, p.y, diagram_->site(slot));
    return {distance.value, distance.bound, slot};
  }
  [[nodiscard]] bool isBeyond(const Point& p, const Entry& entry, double limit) const {
    return internal::isBeyond(p.x, p.y, diagram_->site(entry.site), limit);
  }
  [[nodiscard]] bool isAfter(const Point& p, const Entry& a, const Entry& b) const {
    const double difference = a.distance - b.distance, bound = a.bound + b.bound;
    if (difference > bound || difference < -bound) return difference > 0;
    const internal::Site &sa = diagram_->site(a.site), &sb = diagram_->site(b.site);
    if (isNearer(p.x, p.y, sa, sb)) return true;
    return !isNearer(p.x, p.y, sb, sa) && idOf(a.site) > idOf(b.site);  // identical
  }
  template <class Visit>
  void visitBelow(Slot slot, Visit visit) const {
    const HiddenForest& hidden = diagram_->hidden();
    for (Slot child = hidden.firstChild(slot); child != HiddenForest::kNone;
         child = hidden.nextSibling(child))
      visit(child);
  }
  template <class Visit>
  void visitNeighbors(Slot slot, Visit visit) const {
    const Graph& graph = diagram_->delaunay().graph();
    if (!graph.hasVertex(vertexOf(slot))) return;  // hidden, or the only visible one
    for (const HalfedgeId h : graph.star(vertexOf(slot))) {
      if (graph.target(h) != kInfinity) visit(slotOf(graph.target(h)));
    }
  }
  [[nodiscard]] double distance(const Point& p, Slot slot) const {
    return roundedDistance(p.x, p.y, diagram_->site(slot));
  }
  [[nodiscard]] bool contains(const Point& p, Slot slot) const {
    return !internal::isBeyond(p.x, p.y, diagram_->site(slot), 0);
  }
  [[nodiscard]] double weight(Slot slot) const { return diagram_->site(slot).r; }
  [[nodiscard]] SiteId idOf(Slot slot) const { return diagram_->ids().idOf(slot); }

 private:
  const DiagramCore* diagram_;
};

extern template class NearbySearch<Plane>;  // queries.cpp

}  // namespace apollonius::internal
