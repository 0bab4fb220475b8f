// A sweep over segments from left to right: finds the segment below the left end of each, and a set
// of segments without which the others do not meet. For segments that a grid (segment_grid.h) does
// not keep apart: sides of nested squares, which have whole rows of cells in common; islands close
// together, and one far away.
//
// A line sweeps the plane from left to right (Shamos and Hoey, Geometric intersection problems,
// 1976), upwards where points are above each other, as if it were turned a little. Segments that it
// meets are kept in their order along it, in a splay tree (Sleator and Tarjan, Self-adjusting
// binary search trees, 1985), which is half the code of std::set. Wherever two become neighbours,
// they are tested. If they meet, one of them is taken out, and the new neighbours are tested. So no
// two neighbours ever meet.
//
// Then no two segments that stay meet at all. Suppose that some that are kept at the same time do,
// and let p be the first point where that happens. Before p they do not meet, so their order is
// right up to there; those that come to p from the left are neighbours of each other.
//   - If two or more come to p, and not all end there, then there are two neighbours among them of
//     which one goes on: they meet in p, and one of them has been taken out. A contradiction.
//   - So either all that come to p end there; or just one comes to p and goes on, and another one
//     begins there; or two begin at p and overlap. Segments that end at p are removed before any
//     that begins there is placed. If one goes through p and stays, then none that begins there
//     stays: each becomes its neighbour in turn, as those before have been taken out, and they
//     meet. Two that overlap have no order, and the second is taken out. A contradiction again.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "base/flat_array.h"
#include "geometry/window/segment_grid.h"
#include "number/sign.h"
#include "predicate/point.h"

namespace apollonius::internal {

inline constexpr std::uint32_t kNoneBelow = 0xFFFFFFFFu;
inline constexpr std::uint32_t kStays = 0xFFFFFFFFu;

/// Do two segments meet in more than a common end? (Not if both their ends are common.) Exact.
/// REQUIRES: equal points have equal numbers.
[[nodiscard]] bool doMeet(std::span<const Point> points, const Segment& s, const Segment& t);

class SegmentSweep {
 public:
  /// REQUIRES: points ascend from left to right, and so does each segment, of two points; no points
  /// are equal. All live as long.
  SegmentSweep(std::span<const Point> points, std::span<const Segment> segments)
      : points_(points), segments_(segments) {}

  /// Takes segments out until the others do not meet: of two that meet, the shorter one. Returns
  /// for each the segment that it meets, or that has the same ends; kStays for those that stay.
  /// Cost: O(n log n).
  FlatArray<std::uint32_t> takeOut() {
    isTesting_ = true;
    run();
    return std::move(outFor_);
  }
  /// Returns for each segment the one below its left end, or just to the right of that; or
  /// kNoneBelow. REQUIRES: no two meet. Cost: O(n log n), but O(1) for a segment that begins where
  /// just one ends.
  FlatArray<std::uint32_t> listBelow() {
    run();
    return std::move(below_);
  }

  /// Number of pairs compared or tested.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  /// A place in the order. When its segment ends, another one that begins there can take it over.
  struct Place {
    std::uint32_t segment;
    std::array<std::uint32_t, 2> next;      // below and above
    std::array<std::uint32_t, 2> children;  // likewise
  };

  void run();
  [[nodiscard]] bool isOut(std::uint32_t segment) const { return outFor_[segment] != kStays; }
  [[nodiscard]] Sign sideOf(std::uint32_t s, std::uint32_t t);
  [[nodiscard]] double lengthOf(std::uint32_t segment) const;
  void splay(std::uint32_t segment);
  void join(std::uint32_t low, std::uint32_t high);
  void insert(std::uint32_t segment);
  void erase(std::uint32_t place);
  void part(std::uint32_t low, std::uint32_t high);

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  bool isTesting_ = false;
  FlatArray<Place> places_;           // and a spare one, whose `next` are the ends of the order
  std::uint32_t root_ = 0;            // root of the tree; the spare place if it is empty
  FlatArray<std::uint32_t> placeOf_;  // by segment
  FlatArray<std::uint32_t> outFor_;
  FlatArray<std::uint32_t> below_;
  std::size_t looks_ = 0;
};

}  // namespace apollonius::internal
