#include "geometry/segment_grid.h"

#include <algorithm>
#include <cmath>

namespace apollonius::internal {

SegmentGrid::SegmentGrid(std::span<const Point> points, std::span<const Segment> segments,
                         const Window& box)
    : box_(box) {
  const auto count = static_cast<double>(std::max<std::size_t>(segments.size(), 1));
  columns_ = rows_ = static_cast<std::uint32_t>(std::sqrt(count));
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

}  // namespace apollonius::internal
