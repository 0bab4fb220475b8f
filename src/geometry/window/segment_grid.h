// Segments by the cells of a grid that they meet, to find those near each other.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "base/flat_array.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// A segment from one point to another, as indices of an array of points.
struct Segment {
  std::uint32_t from, to;
};

class SegmentGrid {
 public:
  /// Makes about one cell a segment, with the numbers of rows and columns for which segments meet
  /// the fewest cells: many columns if segments run upwards. REQUIRES: `box` holds all points and
  /// has an area.
  SegmentGrid(std::span<const Point> points, std::span<const Segment> segments,
              const Rectangle& box);

  /// The segments that meet a cell, and perhaps others close to it; ascending.
  [[nodiscard]] std::span<const std::uint32_t> at(std::size_t cell) const {
    return std::span(entries_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  /// The number of pairs of segments in one cell, summed over the cells: in both orders, and each
  /// segment with itself.
  [[nodiscard]] double looks() const;
  /// Lists the cells that a segment meets, and perhaps others beside them; replaces the contents.
  /// Cost: the number of these cells, and of rows between.
  void listCells(Point a, Point b, FlatArray<std::uint32_t>& cells) const;
  /// Is ask(cell) true for any of the cells that a convex shape meets, or perhaps others beside
  /// them? Stops at the first. The shape is given by its corners in order: two are a segment.
  template <class Ask>
  [[nodiscard]] bool isAnyCell(std::initializer_list<Point> corners, Ask ask) const {
    return isAny(
        std::span(corners.begin(), corners.size()),
        [](void* asked, std::size_t cell) { return (*static_cast<Ask*>(asked))(cell); }, &ask);
  }

 private:
  /// Monotonic.
  [[nodiscard]] std::uint32_t columnOf(double x) const {
    return indexOf(x - box_.xmin, box_.width(), columns_);
  }
  [[nodiscard]] std::uint32_t rowOf(double y) const {
    return indexOf(y - box_.ymin, box_.height(), rows_);
  }
  [[nodiscard]] std::size_t cellOf(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * columns_ + column;
  }
  /// Type-erased, so that this code exists once.
  bool isAny(std::span<const Point> corners, bool (*ask)(void* asked, std::size_t cell),
             void* asked) const;
  /// Margin around a cell, as a share of its size: more than rounding.
  static constexpr double kMargin = 0.01;

  [[nodiscard]] static std::uint32_t indexOf(double along, double whole, std::uint32_t count) {
    const double at = along / whole * count;
    return at > 0 ? std::min(static_cast<std::uint32_t>(std::min(at, 1e9)), count - 1) : 0;
  }

  Rectangle box_;
  std::uint32_t columns_ = 1, rows_ = 1;
  FlatArray<std::uint32_t> starts_;   // by cell: its first entry; and the number of entries
  FlatArray<std::uint32_t> entries_;  // segments
};

}  // namespace apollonius::internal
