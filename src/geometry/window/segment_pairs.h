// The pairs of segments that may meet: those in one cell of a grid. If these are too many, a sweep
// takes segments out, so that the remaining ones meet at most in common ends; then only pairs with
// a segment that is out are visited.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/window/segment_grid.h"
#include "geometry/window/segment_sweep.h"

namespace apollonius::internal {

/// The numbers of the points, from left to right.
[[nodiscard]] FlatArray<std::uint32_t> orderedFromLeft(std::span<const Point> points);

class SegmentPairs {
 public:
  /// Up to this many pairs for each segment, all pairs are visited.
  static constexpr double kFewLooks = 64;

  /// REQUIRES: `box` holds all points and has an area; equal points have equal numbers, and no
  /// segment is a point. All live as long. Cost: O(n log n + cells of the grid that segments meet).
  SegmentPairs(const FlatArray<Point>& points, std::span<const Segment> segments,
               const Rectangle& box, double fewLooks = kFewLooks);

  /// Calls visit(k, m), with m < k, once for each pair.
  template <class Visit>
  void visit(Visit visit) {
    visitAll([](void* to, std::uint32_t k, std::uint32_t m) { (*static_cast<Visit*>(to))(k, m); },
             &visit);
  }

  /// Calls visit(k, m) for all pairs or, if they are too many, for one pair with each segment that
  /// the sweep takes out. If no pair that is visited meets, no pair does.
  template <class Visit>
  void visitWitnesses(Visit visit) {
    if (outFor_.empty()) return this->visit(visit);
    for (std::uint32_t k = 0; k < outFor_.size(); ++k) {
      if (isOut(k)) visit(k, outFor_[k]);
    }
  }

  /// Number of pairs examined.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  [[nodiscard]] bool isOut(std::uint32_t segment) const { return outFor_[segment] != kStays; }
  /// Type-erased, so that this code exists once.
  void visitAll(void (*call)(void* to, std::uint32_t k, std::uint32_t m), void* to);
  void sweep();

  const FlatArray<Point>& points_;  // visits can append to it
  std::span<const Segment> segments_;
  SegmentGrid grid_;
  FlatArray<std::uint32_t> outFor_;  // by segment: SegmentSweep::takeOut(); empty without a sweep
  bool isEachPairVisited_ = true;
  std::size_t looks_ = 0;
};

}  // namespace apollonius::internal
