#include "geometry/window/segment_sweep.h"

#include <algorithm>

#include "base/radix_sort.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

bool doMeet(std::span<const Point> points, const Segment& s, const Segment& t) {
  const Point a = points[s.from], b = points[s.to], c = points[t.from], d = points[t.to];
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  const bool isFrom = s.from == t.from || s.from == t.to, isTo = s.to == t.from || s.to == t.to;
  if (isFrom && isTo) return false;
  if (isFrom || isTo) {
    const Point common = isFrom ? a : b, p = isFrom ? b : a, q = common == c ? d : c;
    return dot(p - common, q - common) > 0 && orient2d(common, p, q) == Sign::kZero;
  }
  const auto areOnOneSide = [](Sign p, Sign q) { return p * q == Sign::kPositive; };
  return !areOnOneSide(orient2d(a, b, c), orient2d(a, b, d)) &&
         !areOnOneSide(orient2d(c, d, a), orient2d(c, d, b));
}

FlatArray<char> SegmentSweep::takeOut(std::span<const double> costs) {
  costs_ = costs;
  run();
  return std::move(isOut_);
}

FlatArray<std::uint32_t> SegmentSweep::listBelow() {
  run();
  return std::move(below_);
}

/// Of two segments that the sweep meets, and that do not meet each other before it.
bool SegmentSweep::isBelow(const Segment& s, const Segment& t) {
  ++looks_;
  const bool isFirst = s.from <= t.from;
  const Segment &first = isFirst ? s : t, &second = isFirst ? t : s;
  const Point a = points_[first.from], b = points_[first.to];
  Sign side = orient2d(a, b, points_[second.from]);
  if (side == Sign::kZero) side = orient2d(a, b, points_[second.to]);
  return side == (isFirst ? Sign::kPositive : Sign::kNegative);
}

void SegmentSweep::run() {
  const auto count = static_cast<std::uint32_t>(segments_.size());
  places_.assign(count, status_.end());
  isOut_.resize(count);
  below_.assign(count, kNoneBelow);
  FlatArray<Keyed> ends;
  for (std::uint32_t k = 0; k < count; ++k) {
    isOut_[k] = static_cast<char>(segments_[k].from == segments_[k].to);
    ends.push_back({segments_[k].to, k});
  }
  sortByKey(ends);
  std::uint32_t ended = 0, next = 0;
  while (ended < count) {
    const std::uint32_t first = next;
    const std::uint32_t point = first < count ? segments_[first].from : ends[ended].key;
    while (next < count && segments_[next].from == point) ++next;
    for (; ended < count && ends[ended].key <= point; ++ended) {
      const std::uint32_t k = ends[ended].value;
      if (isOut_[k] != 0) continue;
      const bool isOnly = next == first + 1 && ends[ended].key == point &&
                          (ended == 0 || ends[ended - 1].key != point) &&
                          (ended + 1 == count || ends[ended + 1].key != point);
      if (isOnly) {
        // Nothing else comes to the point, as its neighbours do not meet it.
        places_[first] = places_[k];
        places_[first]->segment = first;
      } else {
        const Place high = status_.erase(places_[k]);
        part(before(high), high);
      }
    }
    for (std::uint32_t k = first; k < next; ++k) place(k);
    for (std::uint32_t k = first; k < next; ++k) {
      if (isOut_[k] != 0) continue;
      const Place low = before(places_[k]);
      if (low != status_.end()) below_[k] = low->segment;
    }
  }
}

void SegmentSweep::place(std::uint32_t segment) {
  if (isOut_[segment] != 0) return;
  Place& at = places_[segment];
  if (at == status_.end()) {
    const auto [found, isNew] = status_.insert({segment});
    if (!isNew) {
      isOut_[segment] = 1;
      return;
    }
    at = found;
  }
  part(before(at), at);
  if (isOut_[segment] == 0) part(at, std::next(at));
}

/// Of neighbours that meet, takes one out, until none do.
void SegmentSweep::part(Place low, Place high) {
  while (!costs_.empty() && low != status_.end() && high != status_.end()) {
    ++looks_;
    if (!doMeet(points_, segments_[low->segment], segments_[high->segment])) return;
    const bool isLow = costs_[low->segment] < costs_[high->segment];
    isOut_[isLow ? low->segment : high->segment] = 1;
    if (isLow) {
      status_.erase(low);
      low = before(high);
    } else {
      high = status_.erase(high);
    }
  }
}

}  // namespace apollonius::internal
