// Segments by the cells of a grid that they meet, so that those near each other are found.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/window.h"
#include "memory/flat_array.h"

namespace apollonius::internal {

/// From one point to another, as indices of an array of points.
struct Segment {
  std::uint32_t from, to;
};

class SegmentGrid {
 public:
  /// About one cell a segment. REQUIRES: `box` holds all points and has an area.
  SegmentGrid(std::span<const Point> points, std::span<const Segment> segments, const Window& box);

  /// Monotonic.
  [[nodiscard]] std::uint32_t columnOf(double x) const {
    return place(x - box_.xmin, box_.width(), columns_);
  }
  [[nodiscard]] std::uint32_t rowOf(double y) const {
    return place(y - box_.ymin, box_.height(), rows_);
  }
  [[nodiscard]] std::size_t cellOf(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * columns_ + column;
  }
  /// The segments that meet a cell, and perhaps others beside it; ascending.
  [[nodiscard]] std::span<const std::uint32_t> at(std::size_t cell) const {
    return std::span(entries_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  /// visit(cell) for the cells that have a segment, given by its ends: those of its box, without
  /// those that its line certainly passes by.
  template <class Visit>
  void visitCells(Point a, Point b, Visit&& visit) const {
    const std::uint32_t left = columnOf(std::min(a.x, b.x)), right = columnOf(std::max(a.x, b.x)),
                        low = rowOf(std::min(a.y, b.y)), high = rowOf(std::max(a.y, b.y));
    const Point way = b - a;
    const double width = box_.width() / columns_, height = box_.height() / rows_;
    // From a cell's middle, to half a cell and a little more, in units of |way|.
    const double reach = 0.51 * (absolute(way.x) * height + absolute(way.y) * width);
    for (std::uint32_t row = low; row <= high; ++row) {
      for (std::uint32_t column = left; column <= right; ++column) {
        const Point center{box_.xmin + (column + 0.5) * width, box_.ymin + (row + 0.5) * height};
        if (left < right && low < high && absolute(cross(way, center - a)) > reach) continue;
        visit(cellOf(column, row));
      }
    }
  }

 private:
  [[nodiscard]] static std::uint32_t place(double along, double whole, std::uint32_t count) {
    const double at = along / whole * count;
    return at > 0 ? std::min(static_cast<std::uint32_t>(std::min(at, 1e9)), count - 1) : 0;
  }

  Window box_;
  std::uint32_t columns_ = 1, rows_ = 1;
  FlatArray<std::uint32_t> starts_;   // by cell, of entries_; and their number
  FlatArray<std::uint32_t> entries_;  // segments
};

}  // namespace apollonius::internal
