// The pairs of segments that may meet: those in one cell of a grid. Where these are too many, a
// sweep takes segments out, so that those that stay do not meet in more than common ends; then only
// pairs with one that is out are visited.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/window/segment_grid.h"

namespace apollonius::internal {

/// Points by their numbers, from left to right.
[[nodiscard]] FlatArray<std::uint32_t> orderedFromLeft(std::span<const Point> points);

class SegmentPairs {
 public:
  /// Fewer pairs in one cell than this for each segment are visited all.
  static constexpr double kFewLooks = 64;

  /// REQUIRES: `box` holds all points and has an area; equal points have equal numbers. All live as
  /// long. Cost: O(n log n + cells of the grid that segments meet).
  SegmentPairs(const FlatArray<Point>& points, std::span<const Segment> segments,
               const Rectangle& box, double fewLooks = kFewLooks);

  /// visit(k, m), with m < k, once for each pair.
  template <class Visit>
  void visit(Visit visit) {
    visitAll([](void* to, std::uint32_t k, std::uint32_t m) { (*static_cast<Visit*>(to))(k, m); },
             &visit);
  }

  /// How many pairs have been looked at.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  [[nodiscard]] bool isSwept() const { return !isOut_.empty(); }
  /// One for all kinds of visits, which are `call(to, k, m)`.
  void visitAll(void (*call)(void* to, std::uint32_t k, std::uint32_t m), void* to);
  void sweep();

  const FlatArray<Point>& points_;  // which a visit can make longer
  std::span<const Segment> segments_;
  SegmentGrid grid_;
  FlatArray<char> isOut_;  // by segment; empty: all pairs are visited
  std::size_t looks_ = 0;
};

}  // namespace apollonius::internal
