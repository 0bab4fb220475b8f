// A window of any shape: closed rings. A point is inside if a line from it to infinity crosses them
// an odd number of times (even-odd rule). However they are given (in either direction, crossing
// themselves and each other, touching, overlapping, with points repeated), they become rings that
// meet in common points only, with the inside on the left of each.
//
//   1. Segments are split where they cross, and where the end of one is on another, until there is
//      no such point. A crossing is rounded to doubles, so the parts can cross others anew; where
//      this goes on, all points are rounded to a grid, and segments are bent to the points that
//      they pass closely.
//   2. Two equal segments cancel: both of their sides are inside, or both outside.
//   3. Which side of a segment is inside follows from the nearest segment below its left end.
//   4. Segments are linked, each with the next one clockwise around their common point, so that
//      rings that only touch themselves there fall into several. Rings without an area up to
//      rounding are left out: their points are on one line except for the last digits.
//
// All decisions are exact signs for the doubles at that step.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// No segment of a polygon. Segments have the numbers of the points that they start at.
inline constexpr std::uint32_t kNoSegment = 0xFFFFFFFFu;

/// An area, and a bound of its rounding error.
struct Area {
  double value = 0;
  double rounding = 0;
};
/// Computes the area that a closed ring encloses, negative if the ring is clockwise. Its `rounding`
/// covers the computation and the points, which may stand for others up to half a unit in the last
/// place away.
[[nodiscard]] Area areaOf(std::span<const Point> ring);

struct NormalizedPolygon {
  FlatArray<Point> points;  ///< those of all rings, at least three a ring, none repeated at its end
  FlatArray<std::uint32_t> starts;  ///< the first point of each ring, and the number of points
  Rectangle box{};                  ///< the smallest box that holds the points

  [[nodiscard]] std::size_t ringCount() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const Point> ring(std::size_t k) const {
    return std::span(points).subspan(starts[k], starts[k + 1] - starts[k]);
  }
  /// Is a finite point inside, or on a ring? Exact. Cost: O(points).
  [[nodiscard]] bool holds(Point p) const;
};

/// Normalizes rings x, y, …; starts[k] is the first point of ring k, and the last entry the number
/// of points. Returns no rings if nothing is inside (or if step 1 does not end, which was never
/// seen). Cost: O(n log n), n = points and crossings, and the pairs that are examined
/// (segment_pairs.h): 64 a segment, or those of segments that share a cell of a grid, one of which
/// meets another. And as many parts as points times crossings where all segments are a few doubles
/// apart.
[[nodiscard]] NormalizedPolygon normalizePolygon(std::span<const double> coordinates,
                                                 std::span<const std::uint32_t> starts);

}  // namespace apollonius::internal
