// Numbers for points, the same for equal ones.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "predicate/point.h"

namespace apollonius::internal {

class PointNumbers {
 public:
  /// The number of a point; of a new one, how many there have been. Expected O(1).
  std::uint32_t add(Point p);
  [[nodiscard]] const FlatArray<Point>& points() const { return points_; }
  /// Cost: O(1) for each of the points.
  void clear();

 private:
  void grow();
  [[nodiscard]] std::size_t entryOf(Point p) const;

  FlatArray<Point> points_;
  FlatArray<std::uint32_t> table_;  // open addressing: numbers, or kNone
};

}  // namespace apollonius::internal
