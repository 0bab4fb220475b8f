#include "geometry/window/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace apollonius::internal {

namespace {

/// Widens a range of x by that of a segment between two heights.
void include(Point p, Point q, double bottom, double top, double& left, double& right) {
  if (std::max(p.y, q.y) < bottom || std::min(p.y, q.y) > top) return;
  for (const Point end : {p, q}) {
    const double y = std::clamp(end.y, bottom, top);
    const double x = y == end.y ? end.x : p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
    left = std::min(left, x);
    right = std::max(right, x);
  }
}

}  // namespace

SegmentGrid::SegmentGrid(std::span<const Point> points, std::span<const Segment> segments,
                         const Rectangle& box)
    : box_(box) {
  const auto count = static_cast<double>(std::max<std::size_t>(segments.size(), 1));
  // Segments meet up to across · columns + up · rows cells. With as many cells as segments, this is
  // least where both terms are equal.
  double across = 1, up = 1;
  for (const Segment& s : segments) {
    across += absolute(points[s.to].x - points[s.from].x) / box.width();
    up += absolute(points[s.to].y - points[s.from].y) / box.height();
  }
  // A cell is at least 2^12 doubles wide and high, so that its margin is more than rounding.
  const auto most = [](double low, double high) {
    return powerOfTwo(40) * (high - low) / std::max(absolute(low), absolute(high));
  };
  const double columns =
      std::min({std::sqrt(count * (up / across)), count, most(box.xmin, box.xmax)});
  const double rows = std::min(count / std::max(columns, 1.0), most(box.ymin, box.ymax));
  columns_ = static_cast<std::uint32_t>(std::max(columns, 1.0));
  rows_ = static_cast<std::uint32_t>(std::max(rows, 1.0));
  starts_.assign(std::size_t{columns_} * rows_ + 1, 0);
  // Count, add up, fill from the ends.
  FlatArray<std::uint32_t> cells;
  for (const Segment& s : segments) {
    listCells(points[s.from], points[s.to], cells);
    for (const std::uint32_t cell : cells) ++starts_[cell];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) sum = start += sum;
  entries_.resize(sum);
  for (auto k = static_cast<std::uint32_t>(segments.size()); k-- > 0;) {
    listCells(points[segments[k].from], points[segments[k].to], cells);
    for (const std::uint32_t cell : cells) entries_[--starts_[cell]] = k;
  }
}

double SegmentGrid::looks() const {
  double sum = 0;
  for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell) {
    const auto size = static_cast<double>(at(cell).size());
    sum += size * size;
  }
  return sum;
}

void SegmentGrid::listCells(Point a, Point b, FlatArray<std::uint32_t>& cells) const {
  cells.clear();
  (void)isAnyCell({a, b}, [&](std::size_t cell) {
    cells.push_back(static_cast<std::uint32_t>(cell));
    return false;
  });
}

bool SegmentGrid::isAny(std::span<const Point> corners, bool (*ask)(void* asked, std::size_t cell),
                        void* asked) const {
  const double width = box_.width() / columns_, height = box_.height() / rows_;
  double low = corners[0].y, high = low;
  for (const Point p : corners) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const std::uint32_t last = rowOf(high + kMargin * height);
  for (std::uint32_t row = rowOf(low - kMargin * height); row <= last; ++row) {
    const double bottom = box_.ymin + (row - kMargin) * height,
                 top = box_.ymin + (row + 1 + kMargin) * height;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    Point p = corners.back();
    for (const Point q : corners) {
      include(p, q, bottom, top, left, right);
      p = q;
    }
    if (left > right) continue;
    const std::uint32_t end = columnOf(right + kMargin * width);
    for (std::uint32_t column = columnOf(left - kMargin * width); column <= end; ++column) {
      if (ask(asked, cellOf(column, row))) return true;
    }
  }
  return false;
}

}  // namespace apollonius::internal
