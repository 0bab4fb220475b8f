// Numbers for points: equal points have the same number.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "predicate/point.h"

namespace apollonius::internal {

class PointNumbers {
 public:
  /// Returns the number of a point; numbers are given in the order of addition, from 0 on. Expected
  /// cost: O(1).
  std::uint32_t add(Point p);
  [[nodiscard]] const FlatArray<Point>& points() const { return points_; }
  /// Cost: O(1) for each of the points.
  void clear();

 private:
  void grow();
  [[nodiscard]] std::size_t entryOf(Point p) const;

  FlatArray<Point> points_;
  FlatArray<std::uint32_t> table_;  // hash table, open addressing: numbers, or kNone
};

}  // namespace apollonius::internal
