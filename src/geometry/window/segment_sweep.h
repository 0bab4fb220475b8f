// Segments from left to right: which of them is below the left end of each, and without which of
// them the others do not meet. For segments that a grid (segment_grid.h) does not keep apart: sides
// of nested squares, which have whole rows of cells in common; islands close together, and one far
// away.
//
// A line sweeps the plane from left to right (Shamos and Hoey, Geometric intersection problems,
// 1976), upwards where points are above each other, as if it were turned a little. Segments that it
// meets are kept in their order along it. Wherever two become neighbours, they are tested. If they
// meet, one of them is taken out, and the new neighbours are tested. So no two neighbours ever
// meet.
//
// Then no two segments that stay meet at all. Suppose that some that are kept at the same time do,
// and let p be the first point where that happens. Before p they do not meet, so their order is
// right up to there; those that come to p from the left are neighbours of each other.
//   - If two or more come to p, and not all end there, then two neighbours do of which one goes on:
//     they meet in p, and one of them has been taken out. A contradiction.
//   - So either all that come to p end there, or just one does, which goes on, and another begins
//     at p; or two begin at p and overlap. What ends at p has left before any that begins there is
//     placed. Where one goes through p, the first that begins at p becomes its neighbour, and one
//     of the two is taken out. Two that overlap have no order, and the second is taken out. A
//     contradiction again.
#pragma once

#include <cstdint>
#include <set>
#include <span>

#include "base/flat_array.h"
#include "geometry/window/segment_grid.h"
#include "predicate/point.h"

namespace apollonius::internal {

inline constexpr std::uint32_t kNoneBelow = 0xFFFFFFFFu;

/// Do two segments meet in more than a common end? (Not if both their ends are common.) Exact.
/// REQUIRES: equal points have equal numbers.
[[nodiscard]] bool doMeet(std::span<const Point> points, const Segment& s, const Segment& t);

class SegmentSweep {
 public:
  /// REQUIRES: points and the starts of segments ascend from left to right, and so does each
  /// segment; no points are equal. All live as long.
  SegmentSweep(std::span<const Point> points, std::span<const Segment> segments)
      : points_(points), segments_(segments), status_(IsBelow{this}) {}

  /// For each segment, whether it is taken out; of two, the one with less `costs`, and any that is
  /// but a point. Cost: O(n log
  /// n).
  FlatArray<char> takeOut(std::span<const double> costs);
  /// For each segment the one below its left end, or to the right of that; or kNoneBelow. REQUIRES:
  /// no two meet. Cost: O(n log n), but O(1) for segments that go on where just one ends.
  FlatArray<std::uint32_t> listBelow();

  /// How many pairs have been compared or tested.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  struct Placed {
    mutable std::uint32_t segment;  // another can take the place of one that ends
  };
  struct IsBelow {
    SegmentSweep* sweep;
    bool operator()(const Placed& s, const Placed& t) const {
      return sweep->isBelow(sweep->segments_[s.segment], sweep->segments_[t.segment]);
    }
  };
  using Status = std::set<Placed, IsBelow>;
  using Place = Status::iterator;

  void run();
  [[nodiscard]] bool isBelow(const Segment& s, const Segment& t);
  [[nodiscard]] Place before(Place place) {
    return place == status_.begin() ? status_.end() : std::prev(place);
  }
  void place(std::uint32_t segment);
  void part(Place low, Place high);

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  std::span<const double> costs_;  // none where nothing meets
  Status status_;
  FlatArray<Place> places_;  // by segment
  FlatArray<char> isOut_;
  FlatArray<std::uint32_t> below_;
  std::size_t looks_ = 0;
};

}  // namespace apollonius::internal
