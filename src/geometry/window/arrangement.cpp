#include "geometry/window/arrangement.h"

#include <algorithm>
#include <limits>

#include "geometry/window/segment_sweep.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

/// Rounds of splitting in which nothing is moved. Most polygons are done with these, as more is
/// left to do only where crossings were rounded; after them, all points are rounded to a grid.
constexpr int kFreeRounds = 2;
/// On the grid, the widths and the heights of a segment's parts add up to its own, so that
/// splitting ends, except for crossings that are rounded to a grid point beside the nearest one.
/// Should it not end for these, the region is refused.
constexpr int kMostRounds = 24;

}  // namespace

bool Arrangement::split() {
  unify();
  for (int round = 1; findCuts();) {
    if (round == kMostRounds) return false;
    cut();
    if (round == kFreeRounds) snap();
    unify();
    round += areRounded_ ? 1 : 0;
  }
  return true;
}

/// Gives equal points one number, directs all segments from left to right, and cancels equal ones
/// in pairs.
void Arrangement::unify() {
  FlatArray<std::uint32_t> numbers(points_.size());
  FlatArray<Point> distinct;
  for (const std::uint32_t k : orderedFromLeft(points_)) {
    if (distinct.empty() || !(distinct.back() == points_[k])) distinct.push_back(points_[k]);
    numbers[k] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  points_.swap(distinct);

  // Sorts by both ends: two stable sorts, by the less important end first. Numbers ascend with the
  // points.
  FlatArray<Keyed> byEnd;
  for (std::uint32_t k = 0; k < segments_.size(); ++k) {
    const std::uint32_t a = numbers[segments_[k].from], b = numbers[segments_[k].to];
    segments_[k] = {std::min(a, b), std::max(a, b)};
    if (a != b) byEnd.push_back({segments_[k].to, k});
  }
  sortByKey(byEnd);
  for (Keyed& end : byEnd) end.key = segments_[end.value].from;
  sortByKey(byEnd);
  FlatArray<Segment> kept;
  for (const Keyed& end : byEnd) {
    const Segment s = segments_[end.value];
    if (!kept.empty() && kept.back().from == s.from && kept.back().to == s.to) {
      kept.pop_back();
    } else {
      kept.push_back(s);
    }
  }
  segments_.swap(kept);
}

/// Rounds all points to a grid of about 2^49 by 2^49 points, or of neighbouring doubles if these
/// are farther apart.
void Arrangement::snap() {
  const auto unitOf = [](double low, double high) {
    const double most = std::max(absolute(low), absolute(high));
    return powerOfTwo(std::max(exponentOf(high - low) - 48, exponentOf(most) - 50));
  };
  unit_ = {unitOf(box_.xmin, box_.xmax), unitOf(box_.ymin, box_.ymax)};
  for (Point& p : points_) p = rounded(p);
}

/// Finds the points where the end of one segment is on another; if there are none, the crossings.
/// The former are exact. So segments that overlap cancel before they are cut at crossings, whose
/// roundings differ.
bool Arrangement::findCuts() {
  cuts_.clear();
  FlatArray<Cut> crossings;
  const std::size_t count = points_.size();
  // With points on a grid, segments that do not meet can have cuts: then all pairs are visited.
  SegmentPairs pairs(points_, segments_, box_,
                     unit_.x == 0 ? fewLooks_ : std::numeric_limits<double>::infinity());
  pairs.visit([&](std::uint32_t k, std::uint32_t m) { cutBoth(k, m, crossings); });
  looks_ += pairs.looks();
  // With points on a grid, cuts at ends are rounded, too.
  areRounded_ = cuts_.empty() || unit_.x != 0;
  if (areRounded_) {
    cuts_.append({crossings.data(), crossings.size()});
  } else {
    points_.resize(count);
  }
  return !cuts_.empty();
}

/// Does a segment go through a point that is not its end; or, with points on a grid, through the
/// rectangle of all points that would be rounded to it (including its lower side, not its upper
/// one)?
/// Snap rounding: segments that are bent into the middles of all such rectangles that they go
/// through do not cross (Hobby, Practical segment intersection with finite precision output, 1999).
bool Arrangement::passes(const Segment& s, std::uint32_t point) const {
  const Point a = from(s), b = to(s), p = points_[point];
  if (point == s.from || point == s.to || p.x < a.x || p.x > b.x || p.y < std::min(a.y, b.y) ||
      p.y > std::max(a.y, b.y))
    return false;
  if (unit_.x == 0) return orient2d(a, b, p) == Sign::kZero;
  // The rectangle's corners that are farthest to either side of the segment.
  const Point way = 0.5 * Point{rises(s) ? -unit_.x : unit_.x, unit_.y};
  return orient2d(a, b, p + way) == Sign::kPositive && orient2d(a, b, p - way) != Sign::kPositive;
}

bool Arrangement::cutAt(std::uint32_t segment, std::uint32_t point) {
  if (!passes(segments_[segment], point)) return false;
  cuts_.push_back({segment, point});
  return true;
}

/// The point where two segments cross, rounded.
Point Arrangement::crossingOf(const Segment& s, const Segment& t) const {
  const Point a = from(s), b = to(s), c = from(t), d = to(t);
  const Point way = b - a, other = d - c;
  // If they are parallel by rounding, they are equally close at any point that they share.
  const double turn = cross(way, other);
  const double along = turn != 0 ? cross(c - a, other) / turn : dot(c - a, way) / dot(way, way);
  const Point p = rounded(a + along * way);
  // Keeps the point in the box that both share, which rounding may have left.
  return {std::clamp(p.x, std::max(a.x, c.x), std::min(b.x, d.x)),
          std::clamp(p.y, std::max(std::min(a.y, b.y), std::min(c.y, d.y)),
                     std::min(std::max(a.y, b.y), std::max(c.y, d.y)))};
}

/// REQUIRES: m < k.
void Arrangement::cutBoth(std::uint32_t k, std::uint32_t m, FlatArray<Cut>& crossings) {
  const Segment s = segments_[k], t = segments_[m];
  const Point a = from(s), b = to(s), c = from(t), d = to(t);
  // t begins no further right than s: unify() has sorted them.
  if (a.x > d.x || std::min(c.y, d.y) > std::max(a.y, b.y) ||
      std::min(a.y, b.y) > std::max(c.y, d.y))
    return;
  bool touches = cutAt(k, t.from);
  touches |= cutAt(k, t.to);
  touches |= cutAt(m, s.from);
  touches |= cutAt(m, s.to);
  if (touches || !doMeet(points_, s, t)) return;
  const auto number = static_cast<std::uint32_t>(points_.size());
  const Point x = crossingOf(s, t);
  points_.push_back(x);
  if (!(x == a || x == b)) crossings.push_back({k, number});
  if (!(x == c || x == d)) crossings.push_back({m, number});
}

void Arrangement::cut() {
  // Sorts by segment, then from left to right, by two stable sorts.
  FlatArray<std::uint32_t> rankOf(points_.size());
  std::uint32_t rank = 0;
  for (const std::uint32_t point : orderedFromLeft(points_)) rankOf[point] = rank++;
  FlatArray<Keyed> order(cuts_.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = {rankOf[cuts_[k].point], k};
  sortByKey(order);
  for (Keyed& entry : order) entry.key = cuts_[entry.value].segment;
  sortByKey(order);
  FlatArray<Cut> cuts;
  for (const Keyed& entry : order) cuts.push_back(cuts_[entry.value]);
  // On a segment that falls, points above each other are taken from above.
  const auto isAfter = [&](const Cut& a, const Cut& b) {
    return a.segment != b.segment || points_[a.point].x != points_[b.point].x;
  };
  for (std::size_t begin = 0, end = 0; begin < cuts.size(); begin = end) {
    while (end < cuts.size() && !isAfter(cuts[begin], cuts[end])) ++end;
    if (!rises(segments_[cuts[begin].segment]))
      std::reverse(cuts.begin() + begin, cuts.begin() + end);
  }
  cuts_.swap(cuts);
  for (const Cut& cut : cuts_) {
    Segment& rest = segments_[cut.segment];
    segments_.push_back({rest.from, cut.point});
    segments_[cut.segment].from = cut.point;
  }
}

void Arrangement::listEnds() {
  ends_.clear();
  for (std::uint32_t k = 0; k < segments_.size(); ++k) {
    ends_.push_back({segments_[k].from, k});
    ends_.push_back({segments_[k].to, k});
  }
  sortByKey(ends_);
  firstEnd_.assign(points_.size() + 1, 0);
  for (const Keyed& end : ends_) ++firstEnd_[end.key + 1];
  for (std::size_t k = 1; k < firstEnd_.size(); ++k) firstEnd_[k] += firstEnd_[k - 1];
}

/// Is the side below a segment inside, a little to the right of its left end? Below it are others
/// that start there, each with the inside on one side; and below these the nearest segment that
/// begins further left. That one is done already, as segments are taken from left to right.
bool Arrangement::isInsideBelow(std::uint32_t segment, std::span<const std::uint32_t> below,
                                std::span<const char> turns) const {
  bool isOdd = false;
  std::uint32_t at = below[segment];
  for (; at != kNoneBelow && segments_[at].from == segments_[segment].from; at = below[at])
    isOdd = !isOdd;
  const bool isInsideAbove = at != kNoneBelow && turns[at] == 0;
  return isInsideAbove != isOdd;
}

/// Turns each segment so that the inside is on its left. In a chain, where just two segments meet
/// at each point, isInsideBelow() is evaluated for one of them.
void Arrangement::orient() {
  listEnds();
  SegmentSweep sweep(points_, segments_);
  const FlatArray<std::uint32_t> below = sweep.listBelow();
  looks_ += sweep.looks();
  FlatArray<char> isDone(segments_.size(), 0);
  FlatArray<char> turns(segments_.size(), 0);
  for (std::uint32_t first = 0; first < segments_.size(); ++first) {
    if (isDone[first] != 0) continue;
    // With the inside below, a segment runs to the left.
    const bool runsLeft = isInsideBelow(first, below, turns);
    isDone[first] = 1;
    turns[first] = static_cast<char>(runsLeft);
    for (const bool forwards : {true, false}) {
      std::uint32_t at = first;
      while (true) {
        const bool endsAtTo = forwards != (turns[at] != 0);
        const std::uint32_t point = endsAtTo ? segments_[at].to : segments_[at].from;
        const auto ends = endsAt(point);
        if (ends.size() != 2) break;
        at = ends[0].value == at ? ends[1].value : ends[0].value;
        if (isDone[at] != 0) break;
        isDone[at] = 1;
        turns[at] = static_cast<char>((segments_[at].from == point) != forwards);
      }
    }
  }
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (turns[k] != 0) std::swap(segments_[k].from, segments_[k].to);
  }
}

/// The segment that continues where this one ends: of those that start there, the first one
/// clockwise from this one, as the inside is between them.
std::uint32_t Arrangement::next(std::uint32_t segment) const {
  const Point at = to(segments_[segment]), back = from(segments_[segment]);
  std::uint32_t best = kNoneBelow;
  for (const Keyed& end : endsAt(segments_[segment].to)) {
    const Segment& s = segments_[end.value];
    if (s.from != end.key) continue;
    if (best == kNoneBelow || comesFirstClockwise(at, back, to(s), to(segments_[best])))
      best = end.value;
  }
  return best;
}

void Arrangement::link(NormalizedPolygon& polygon) {
  FlatArray<char> isLinked(segments_.size(), 0);
  polygon.starts.assign(1, 0);
  for (std::uint32_t first = 0; first < segments_.size(); ++first) {
    if (isLinked[first] != 0) continue;
    std::uint32_t at = first;
    while (at != kNoneBelow && isLinked[at] == 0) {
      isLinked[at] = 1;
      polygon.points.push_back(from(segments_[at]));
      at = next(at);
    }
    const std::uint32_t start = polygon.starts.back();
    const Area area = areaOf(std::span<const Point>(polygon.points).subspan(start));
    if (absolute(area.value) > area.rounding) {
      polygon.starts.push_back(static_cast<std::uint32_t>(polygon.points.size()));
    } else {
      polygon.points.resize(start);
    }
  }
}

}  // namespace apollonius::internal
