#include "geometry/window/segment_sweep.h"

#include <algorithm>

#include "base/radix_sort.h"
#include "number/fp.h"
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

/// On which side of t is s? Of two segments that the sweep meets, and that do not meet each other
/// before it; zero if they overlap.
Sign SegmentSweep::sideOf(std::uint32_t s, std::uint32_t t) {
  ++looks_;
  const bool isFirst = segments_[s].from < segments_[t].from;
  const auto [a, b] = segments_[isFirst ? s : t];
  const auto [c, d] = segments_[isFirst ? t : s];
  Sign side = orient2d(points_[a], points_[b], points_[c]);
  if (side == Sign::kZero) side = orient2d(points_[a], points_[b], points_[d]);
  return isFirst ? -side : side;
}

double SegmentSweep::lengthOf(std::uint32_t segment) const {
  const Point way = points_[segments_[segment].to] - points_[segments_[segment].from];
  return way.x + absolute(way.y);
}

void SegmentSweep::run() {
  const auto count = static_cast<std::uint32_t>(segments_.size());
  root_ = count;
  places_.assign(count + std::size_t{1}, {kNoneBelow, {count, count}, {count, count}});
  placeOf_.assign(count, count);
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
      const std::uint32_t place = placeOf_[k];
      if (isOnly && isOut_[first] == 0) {
        // Nothing else comes to the point, as its neighbours do not meet it.
        placeOf_[first] = place;
        places_[place].segment = first;
      } else {
        erase(place);
        part(places_[place].next[0], places_[place].next[1]);
      }
    }
    for (std::uint32_t k = first; k < next; ++k) {
      if (isOut_[k] != 0) continue;
      if (placeOf_[k] == count) insert(k);
      if (isOut_[k] == 0) part(places_[placeOf_[k]].next[0], placeOf_[k]);
      if (isOut_[k] == 0) part(placeOf_[k], places_[placeOf_[k]].next[1]);
    }
    for (std::uint32_t k = first; k < next; ++k)
      below_[k] = isOut_[k] != 0 ? kNoneBelow : places_[places_[placeOf_[k]].next[0]].segment;
  }
}

/// Makes a place the root that a segment has or is next to, top down.
void SegmentSweep::splay(std::uint32_t segment) {
  const auto none = static_cast<std::uint32_t>(segments_.size());
  // What is above and what is below hangs on the spare place, and grows at these.
  std::array<std::uint32_t, 2> tails{none, none};
  std::uint32_t at = root_;
  Sign side = sideOf(segment, places_[at].segment);
  while (side != Sign::kZero) {
    const std::size_t way = side == Sign::kPositive ? 1 : 0;
    std::uint32_t child = places_[at].children[way];
    if (child == none) break;
    Sign nextSide = sideOf(segment, places_[child].segment);
    if (nextSide == side) {  // two steps the same way: turned, so that the tree becomes flatter
      places_[at].children[way] = places_[child].children[1 - way];
      places_[child].children[1 - way] = at;
      at = child;
      child = places_[at].children[way];
      if (child == none) break;
      nextSide = sideOf(segment, places_[child].segment);
    }
    places_[tails[way]].children[way] = at;
    tails[way] = at;
    at = child;
    side = nextSide;
  }
  for (const std::size_t way : {0, 1}) {
    places_[tails[way]].children[way] = places_[at].children[1 - way];
    places_[at].children[1 - way] = places_[none].children[way];
    places_[none].children[way] = none;
  }
  root_ = at;
}

void SegmentSweep::join(std::uint32_t low, std::uint32_t high) {
  places_[low].next[1] = high;
  places_[high].next[0] = low;
}

/// The second of two that overlap is out.
void SegmentSweep::insert(std::uint32_t segment) {
  const auto none = static_cast<std::uint32_t>(segments_.size());
  Place& place = places_[segment];
  place.segment = segment;
  std::uint32_t below = none;
  if (root_ != none) {
    splay(segment);
    const Sign side = sideOf(segment, places_[root_].segment);
    if (side == Sign::kZero) {
      isOut_[segment] = 1;
      return;
    }
    const std::size_t way = side == Sign::kPositive ? 1 : 0;
    place.children[way] = places_[root_].children[way];
    place.children[1 - way] = root_;
    places_[root_].children[way] = none;
    below = way == 1 ? root_ : places_[root_].next[0];
  }
  placeOf_[segment] = root_ = segment;
  const std::uint32_t above = places_[below].next[1];
  join(below, segment);
  join(segment, above);
}

/// It still knows its neighbours.
void SegmentSweep::erase(std::uint32_t place) {
  const auto none = static_cast<std::uint32_t>(segments_.size());
  splay(places_[place].segment);
  const auto [below, above] = places_[place].next;
  const auto [low, high] = places_[place].children;
  root_ = high;
  if (low != none) {
    root_ = low;
    splay(places_[below].segment);
    places_[root_].children[1] = high;
  }
  join(below, above);
}

/// Of neighbours that meet, takes one out, until none do.
void SegmentSweep::part(std::uint32_t low, std::uint32_t high) {
  while (isTesting_ && places_[low].segment != kNoneBelow && places_[high].segment != kNoneBelow) {
    const std::uint32_t s = places_[low].segment, t = places_[high].segment;
    ++looks_;
    if (!doMeet(points_, segments_[s], segments_[t])) return;
    const bool isLow = lengthOf(s) < lengthOf(t);
    isOut_[isLow ? s : t] = 1;
    erase(isLow ? low : high);
    (isLow ? low : high) = places_[isLow ? low : high].next[isLow ? 0 : 1];
  }
}

}  // namespace apollonius::internal
