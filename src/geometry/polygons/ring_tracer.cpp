#include "geometry/polygons/ring_tracer.h"

#include <algorithm>

#include "base/radix_sort.h"
#include "geometry/window/polygon.h"
#include "number/fp.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

constexpr std::uint32_t kNotOnWay = 0xFFFFFFFFu;

}  // namespace

void Tracer::clear() {
  numbers_.clear();
  segments_.clear();
}

void Tracer::addRing(std::span<const double> ring) {
  std::uint32_t last = numbers_.add({ring[0], ring[1]});
  for (std::size_t k = 2; k + 1 < ring.size(); k += 2) {
    const std::uint32_t next = numbers_.add({ring[k], ring[k + 1]});
    if (next != last) segments_.push_back({last, next, false});
    last = next;
  }
}

/// Sorts the segments by their starts.
void Tracer::sortSegments() {
  firstFrom_.assign(numbers_.points().size() + 1, 0);
  for (const Segment& s : segments_) ++firstFrom_[s.from];
  std::uint32_t sum = 0;
  for (std::uint32_t& first : firstFrom_) sum = first += sum;
  FlatArray<Segment> sorted(segments_.size());
  for (std::size_t k = segments_.size(); k-- > 0;)
    sorted[--firstFrom_[segments_[k].from]] = segments_[k];
  segments_.swap(sorted);
}

/// Removes pairs of a segment and its reverse.
void Tracer::cancel() {
  sortSegments();
  for (Segment& s : segments_) {
    if (s.isDone) continue;
    for (std::uint32_t k = firstFrom_[s.to]; k < firstFrom_[s.to + 1]; ++k) {
      Segment& back = segments_[k];
      if (back.to != s.from || back.isDone) continue;
      s.isDone = back.isDone = true;
      break;
    }
  }
}

/// The segment that continues where this one ends.
std::uint32_t Tracer::next(std::uint32_t segment) const {
  const Segment& s = segments_[segment];
  std::uint32_t best = kNotOnWay;
  for (std::uint32_t k = firstFrom_[s.to]; k < firstFrom_[s.to + 1]; ++k) {
    if (segments_[k].isDone) continue;
    if (best == kNotOnWay ||
        comesFirstClockwise(at(s.to), at(s.from), at(segments_[k].to), at(segments_[best].to)))
      best = k;
  }
  return best;
}

/// Ends a loop where the way comes to a point again.
void Tracer::cut(std::uint32_t point) {
  const std::uint32_t begin = indexOnWay_[point];
  Loop loop{static_cast<std::uint32_t>(traced_.size()),
            static_cast<std::uint32_t>(way_.size()) - begin,
            0,
            {}};
  double reach = 0;
  Point last = at(way_.back());
  loop.box = {last.x, last.y, last.x, last.y};
  for (std::size_t k = begin; k < way_.size(); ++k) {
    const Point p = at(way_[k]);
    traced_.push_back(p);
    indexOnWay_[way_[k]] = kNotOnWay;
    loop.box.include(p);
    reach += length(p - last);
    last = p;
  }
  way_.resize(begin);
  loop.area = 2 * areaOf(ringOf(loop)).value;
  if (absolute(loop.area) > width_ * reach) {
    loops_.push_back(loop);
  } else {
    traced_.resize(loop.first);
  }
}

void Tracer::link() {
  cancel();
  traced_.clear();
  loops_.clear();
  indexOnWay_.assign(numbers_.points().size(), kNotOnWay);
  for (std::uint32_t first = 0; first < segments_.size(); ++first) {
    way_.clear();
    for (std::uint32_t k = first; k != kNotOnWay && !segments_[k].isDone; k = next(k)) {
      const std::uint32_t from = segments_[k].from;
      segments_[k].isDone = true;
      if (indexOnWay_[from] != kNotOnWay) cut(from);
      indexOnWay_[from] = static_cast<std::uint32_t>(way_.size());
      way_.push_back(from);
    }
    // The way ends where it began: at each point as many segments end as start.
    if (!way_.empty()) cut(way_[0]);
  }
}

bool Tracer::isCrossed(std::uint32_t loop, std::size_t k, Point p) {
  const auto [a, aside, b] = piece(loop, k);
  isCorner_ |= p == a || p == b;
  return (a.y > p.y) != (b.y > p.y) && (orient2d(a, b, p) == Sign::kPositive) == (b.y > a.y);
}

/// Is the first point of the hole that is no corner of the loop inside the loop?
bool Tracer::isAround(std::uint32_t loop) {
  for (const Point p : ringOf(loops_[hole_])) {
    isCorner_ = false;
    const bool isInside = nesting_.isInside(loop, p);
    if (!isCorner_) return isInside;
  }
  return false;
}

void Tracer::trace(Rings& rings, double thinnest) {
  width_ = thinnest;
  link();
  rings.clear();
  const auto add = [&](const Loop& loop) {
    for (const Point p : ringOf(loop)) rings.add(p);
    rings.add(traced_[loop.first]);
    rings.endRing();
  };
  FlatArray<Keyed> holes;  // by the loop around each
  nesting_.clear();
  for (std::uint32_t k = 0; k < loops_.size(); ++k) {
    if (loops_[k].area > 0) nesting_.add(k, loops_[k].area, loops_[k].box);
  }
  for (hole_ = 0; hole_ < loops_.size(); ++hole_) {
    const Loop& hole = loops_[hole_];
    if (hole.area < 0) holes.push_back({nesting_.find(hole.box.center(), -hole.area), hole_});
  }
  sortByKey(holes);
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < loops_.size(); ++k) {
    if (loops_[k].area < 0) continue;
    add(loops_[k]);
    for (; next < holes.size() && holes[next].key <= k; ++next) add(loops_[holes[next].value]);
    rings.endPart();
  }
}

}  // namespace apollonius::internal
