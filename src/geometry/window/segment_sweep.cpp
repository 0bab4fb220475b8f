#include "geometry/window/segment_sweep.h"

#include <algorithm>

#include "base/radix_sort.h"
#include "number/fp.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

/// Are both ends of a segment on one side of another's line, and not on it?
bool isBeside(std::span<const Point> points, const Segment& s, const Segment& t) {
  const Point a = points[t.from], b = points[t.to];
  return orient2d(a, b, points[s.from]) * orient2d(a, b, points[s.to]) == Sign::kPositive;
}

}  // namespace

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
  return !isBeside(points, s, t) && !isBeside(points, t, s);
}

/// On which side of t is s? Zero if they overlap. REQUIRES: the sweep line meets both, and they do
/// not meet each other before it.
Sign SegmentSweep::sideOf(std::uint32_t s, std::uint32_t t) {
  ++looks_;
  if (s == t) return Sign::kZero;
  const bool isFirst = segments_[s].from < segments_[t].from;
  const auto [a, b] = segments_[isFirst ? s : t];
  const auto [c, d] = segments_[isFirst ? t : s];
  Sign side = a == c ? Sign::kZero : orient2d(points_[a], points_[b], points_[c]);
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
  outFor_.assign(count, kStays);
  below_.assign(count, kNoneBelow);
  FlatArray<Keyed> starts, ends;
  for (std::uint32_t k = 0; k < count; ++k) {
    starts.push_back({segments_[k].from, k});
    ends.push_back({segments_[k].to, k});
  }
  sortByKey(starts);
  sortByKey(ends);
  std::uint32_t ended = 0, next = 0;
  while (ended < count) {
    const std::uint32_t first = next;
    const std::uint32_t point = first < count ? starts[first].key : ends[ended].key;
    while (next < count && starts[next].key == point) ++next;
    const auto begun = std::span(starts).subspan(first, next - first);
    for (; ended < count && ends[ended].key <= point; ++ended) {
      const std::uint32_t k = ends[ended].value, place = placeOf_[k];
      if (isOut(k)) continue;
      // A segment that begins at the point ends later, so there is a next end.
      const bool isOnly = begun.size() == 1 && ends[ended].key == point &&
                          (ended == 0 || ends[ended - 1].key != point) &&
                          ends[ended + 1].key != point;
      if (isOnly) {
        // No other segment comes to the point, as its neighbours do not meet it.
        placeOf_[begun[0].value] = place;
        places_[place].segment = begun[0].value;
      } else {
        erase(place);
        part(places_[place].next[0], places_[place].next[1]);
      }
    }
    for (const Keyed& start : begun) {
      const std::uint32_t k = start.value;
      if (placeOf_[k] == count) insert(k);
      if (!isOut(k)) part(places_[placeOf_[k]].next[0], placeOf_[k]);
      if (!isOut(k)) part(placeOf_[k], places_[placeOf_[k]].next[1]);
    }
    for (const Keyed& start : begun) {
      const std::uint32_t k = start.value;
      if (!isOut(k)) below_[k] = places_[places_[placeOf_[k]].next[0]].segment;
    }
  }
}

/// Makes the place of a segment, or one next to it, the root; top down.
void SegmentSweep::splay(std::uint32_t segment) {
  const auto none = static_cast<std::uint32_t>(segments_.size());
  // The parts of the tree above and below hang on the spare place, and grow at these ends.
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

/// Inserts a segment into the order; takes it out if it overlaps another one.
void SegmentSweep::insert(std::uint32_t segment) {
  const auto none = static_cast<std::uint32_t>(segments_.size());
  Place& place = places_[segment];
  place.segment = segment;
  std::uint32_t below = none;
  if (root_ != none) {
    splay(segment);
    const Sign side = sideOf(segment, places_[root_].segment);
    if (side == Sign::kZero) {
      outFor_[segment] = places_[root_].segment;
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

/// Removes a place from the order. The place keeps its links to its neighbours.
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

/// While two neighbours meet, takes out one of them.
void SegmentSweep::part(std::uint32_t low, std::uint32_t high) {
  while (isTesting_ && places_[low].segment != kNoneBelow && places_[high].segment != kNoneBelow) {
    const std::uint32_t s = places_[low].segment, t = places_[high].segment;
    ++looks_;
    if (!doMeet(points_, segments_[s], segments_[t])) return;
    const bool isLow = lengthOf(s) < lengthOf(t);
    outFor_[isLow ? s : t] = isLow ? t : s;
    erase(isLow ? low : high);
    (isLow ? low : high) = places_[isLow ? low : high].next[isLow ? 0 : 1];
  }
}

}  // namespace apollonius::internal
