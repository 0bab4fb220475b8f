#include "geometry/segment_grid.h"

#include <algorithm>
#include <cmath>

namespace apollonius::internal {

SegmentGrid::SegmentGrid(std::span<const Point> points, std::span<const Segment> segments,
                         const Window& box)
    : box_(box) {
  const auto count = static_cast<double>(std::max<std::size_t>(segments.size(), 1));
  const auto share = [&](double one, double other) {
    return static_cast<std::uint32_t>(std::clamp(std::sqrt(count * (one / other)), 1.0, count));
  };
  columns_ = share(box.width(), box.height());
  rows_ = share(box.height(), box.width());
  starts_.assign(std::size_t{columns_} * rows_ + 1, 0);
  // Count, add up, fill from the ends.
  for (const Segment& s : segments)
    visitCells(points[s.from], points[s.to], [&](std::size_t cell) { ++starts_[cell]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) sum = start += sum;
  entries_.resize(sum);
  for (auto k = static_cast<std::uint32_t>(segments.size()); k-- > 0;) {
    visitCells(points[segments[k].from], points[segments[k].to],
               [&](std::size_t cell) { entries_[--starts_[cell]] = k; });
  }
}

/// The cells of the segment's box, without those that its line certainly passes by.
template <class Visit>
void SegmentGrid::visitCells(Point a, Point b, Visit&& visit) const {
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
      visit(std::size_t{row} * columns_ + column);
    }
  }
}

}  // namespace apollonius::internal
