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

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  /// Monotonic.
  [[nodiscard]] std::uint32_t columnOf(double x) const {
    return place(x - box_.xmin, box_.width(), columns_);
  }
  [[nodiscard]] std::uint32_t rowOf(double y) const {
    return place(y - box_.ymin, box_.height(), rows_);
  }
  /// The segments that meet a cell, and perhaps others beside it; ascending.
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t* const start = &starts_[row * columns_ + column];
    return std::span(entries_).subspan(start[0], start[1] - start[0]);
  }

 private:
  [[nodiscard]] static std::uint32_t place(double along, double whole, std::uint32_t count) {
    const double at = along / whole * count;
    return at > 0 ? std::min(static_cast<std::uint32_t>(std::min(at, 1e9)), count - 1) : 0;
  }
  template <class Visit>
  void visitCells(Point a, Point b, Visit&& visit) const;

  Window box_;
  std::uint32_t columns_ = 1, rows_ = 1;
  FlatArray<std::uint32_t> starts_;   // by cell, of entries_; and their number
  FlatArray<std::uint32_t> entries_;  // segments
};

}  // namespace apollonius::internal
