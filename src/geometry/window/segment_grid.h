// Segments by the cells of a grid that they meet, so that those near each other are found.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "base/flat_array.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// From one point to another, as indices of an array of points.
struct Segment {
  std::uint32_t from, to;
};

class SegmentGrid {
 public:
  /// About one cell a segment, in as many rows and columns as make these meet the fewest cells:
  /// what runs upwards is in many columns. REQUIRES: `box` holds all points and has an area.
  SegmentGrid(std::span<const Point> points, std::span<const Segment> segments,
              const Rectangle& box);

  /// The segments that meet a cell, and perhaps others beside it; ascending.
  [[nodiscard]] std::span<const std::uint32_t> at(std::size_t cell) const {
    return std::span(entries_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  /// How many segments all see that look at those in their cells: again in each, and themselves.
  [[nodiscard]] double looks() const;
  /// The cells that a segment meets, and perhaps others beside them, replace the contents. Cost:
  /// these, and the rows between.
  void listCells(Point a, Point b, FlatArray<std::uint32_t>& cells) const;
  /// Does `ask(cell)` say yes for any of the cells that a convex shape meets, and perhaps others
  /// beside them? It ends with the first. The shape's corners in order: two are a segment.
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
  /// One for all kinds of questions, which are `ask(asked, cell)`.
  bool isAny(std::span<const Point> corners, bool (*ask)(void* asked, std::size_t cell),
             void* asked) const;
  /// Of a cell: more than rounding.
  static constexpr double kMargin = 0.01;

  [[nodiscard]] static std::uint32_t indexOf(double along, double whole, std::uint32_t count) {
    const double at = along / whole * count;
    return at > 0 ? std::min(static_cast<std::uint32_t>(std::min(at, 1e9)), count - 1) : 0;
  }

  Rectangle box_;
  std::uint32_t columns_ = 1, rows_ = 1;
  FlatArray<std::uint32_t> starts_;   // by cell, of entries_; and their number
  FlatArray<std::uint32_t> entries_;  // segments
};

}  // namespace apollonius::internal
