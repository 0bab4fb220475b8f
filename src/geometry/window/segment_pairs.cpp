#include "geometry/window/segment_pairs.h"

#include <algorithm>

namespace apollonius::internal {

FlatArray<std::uint32_t> orderedFromLeft(std::span<const Point> points) {
  FlatArray<std::uint32_t> order(points.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::partial_sort(order.begin(), order.end(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return isLeftOf(points[a], points[b]);
  });
  return order;
}

SegmentPairs::SegmentPairs(const FlatArray<Point>& points, std::span<const Segment> segments,
                           const Rectangle& box, double fewLooks)
    : points_(points), segments_(segments), grid_(points, segments, box) {
  if (!(grid_.looks() > fewLooks * static_cast<double>(segments.size()))) return;
  sweep();
  // If more than half are out, it is quicker to examine each pair from one side only.
  std::size_t out = 0;
  for (std::uint32_t k = 0; k < outFor_.size(); ++k) out += isOut(k) ? 1 : 0;
  isEachPairVisited_ = 2 * out > outFor_.size();
}

/// Runs the sweep from left to right.
void SegmentPairs::sweep() {
  const FlatArray<std::uint32_t> order = orderedFromLeft(points_);
  FlatArray<Point> points(order.size());
  FlatArray<std::uint32_t> rankOf(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    points[k] = points_[order[k]];
    rankOf[order[k]] = k;
  }
  FlatArray<Segment> segments;
  for (const auto [from, to] : segments_) {
    const std::uint32_t a = rankOf[from], b = rankOf[to];
    segments.push_back({std::min(a, b), std::max(a, b)});
  }
  SegmentSweep sweep(points, segments);
  outFor_ = sweep.takeOut();
  looks_ += sweep.looks();
}

void SegmentPairs::visitAll(void (*call)(void* to, std::uint32_t k, std::uint32_t m), void* to) {
  const auto count = static_cast<std::uint32_t>(segments_.size());
  FlatArray<std::uint32_t> countedFor(count, 0xFFFFFFFFu), cells;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (!isEachPairVisited_ && !isOut(k)) continue;
    grid_.listCells(points_[segments_[k].from], points_[segments_[k].to], cells);
    for (const std::uint32_t cell : cells) {
      for (const std::uint32_t m : grid_.at(cell)) {
        ++looks_;
        if (m >= k) {
          if (isEachPairVisited_) break;
          if (isOut(m)) continue;  // the other one visits the pair
        }
        if (countedFor[m] == k) continue;
        countedFor[m] = k;
        call(to, std::max(k, m), std::min(k, m));
      }
    }
  }
}

}  // namespace apollonius::internal
