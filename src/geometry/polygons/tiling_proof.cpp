#include "geometry/polygons/tiling_proof.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "geometry/window/segment_pairs.h"
#include "geometry/window/segment_sweep.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

std::uint64_t mixed(std::uint64_t word) {
  word = (word ^ (word >> 32)) * 0xD6E8FEB86659FD93u;
  word = (word ^ (word >> 29)) * 0x9E3779B97F4A7C15u;
  return word ^ (word >> 32);
}

std::uint64_t hashOf(Point a, Point b) {
  std::uint64_t hash = 0;
  for (const double x : {a.x, a.y, b.x, b.y}) hash = mixed(hash ^ std::bit_cast<std::uint64_t>(x));
  return hash;
}

/// Of a segment; that of its reverse is the negative.
std::uint64_t directedHash(Point from, Point to) {
  return isLeftOf(from, to) ? hashOf(from, to) : 0 - hashOf(to, from);
}

/// Calls step(from, to) for the segments of a ring until it returns false. Has none?
template <class Step>
bool isTrueForAll(std::span<const Point> ring, Step&& step) {
  Point from = ring.back();
  for (const Point to : ring) {
    if (!step(from, to)) return false;
    from = to;
  }
  return true;
}

/// How often a ring that turns counter-clockwise around a centre at each step does so.
int turnsOf(std::span<const Point> ring, Point center) {
  int turns = 0;
  isTrueForAll(ring, [&](Point from, Point to) {
    turns += static_cast<int>(from.y < center.y && to.y >= center.y);
    return true;
  });
  return turns;
}

bool isAround(std::span<const Point> ring, Point center) {
  return isTrueForAll(
             ring,
             [&](Point from, Point to) { return orient2d(center, from, to) == Sign::kPositive; }) &&
         turnsOf(ring, center) == 1;
}

/// Of a simple ring.
bool isCounterClockwise(std::span<const Point> ring) {
  std::size_t first = 0;
  for (std::size_t k = 1; k < ring.size(); ++k) {
    if (isLeftOf(ring[k], ring[first])) first = k;
  }
  return orient2d(ring[first > 0 ? first - 1 : ring.size() - 1], ring[first],
                  ring[first + 1 < ring.size() ? first + 1 : 0]) == Sign::kPositive;
}

}  // namespace

TilingProof::TilingProof(const DiagramCore& core, const Rectangle& box, const RawRings& raw) {
  bool areSimple = true;
  std::uint64_t sum = 0;
  for (const RawRings::Cell& cell : raw.cells) {
    const Point center{core.site(cell.slot).x, core.site(cell.slot).y};
    for (const RawRings::Ring& ring : raw.ringsOf(cell)) {
      const std::span<const Point> points = raw.pointsOf(ring);
      // Of a ring that is not traced each step is known to turn to the left.
      areSimple = areSimple && (cell.isTraced ? isAround(points, center) || isSimple(points)
                                              : turnsOf(points, center) == 1);
      for (std::uint32_t k = 0; k < ring.count; ++k) {
        if (raw.isBorder[ring.first + k] != 0) continue;
        sum += directedHash(points[k], points[k + 1 < ring.count ? k + 1 : 0]);
      }
    }
  }
  listBorder(core, box, raw);
  holds_ = areSimple && sum == 0 && !doAnyMeet(box);
}

bool TilingProof::isSimple(std::span<const Point> ring) {
  numbers_.clear();
  segments_.clear();
  const auto count = static_cast<std::uint32_t>(ring.size());
  Rectangle box{ring[0].x, ring[0].y, ring[0].x, ring[0].y};
  for (std::uint32_t k = 0; k < count; ++k) {
    if (numbers_.add(ring[k]) != k) return false;
    segments_.push_back({k, k + 1 < count ? k + 1 : 0});
    box.include(ring[k]);
  }
  return box.width() > 0 && box.height() > 0 && !doAnyMeet(box) && isCounterClockwise(ring);
}

/// Do any of the segments meet? `box` has an area.
bool TilingProof::doAnyMeet(Rectangle box) const {
  const FlatArray<Point>& points = numbers_.points();
  bool isAny = false;
  const auto look = [&](std::uint32_t k, std::uint32_t m) {
    isAny = isAny || doMeet(points, segments_[k], segments_[m]);
  };
  if (segments_.size() <= kFew) {
    for (std::uint32_t k = 0; k < segments_.size(); ++k) {
      for (std::uint32_t m = 0; m < k; ++m) look(k, m);
    }
    return isAny;
  }
  for (const Point p : points) box.include(p);
  SegmentPairs(points, segments_, box).visitWitnesses(look);
  return isAny;
}

void TilingProof::listBorder(const DiagramCore& core, const Rectangle& box, const RawRings& raw) {
  numbers_.clear();
  segments_.clear();
  FlatArray<double> fromSites;  // by point: the largest distance
  for (const RawRings::Cell& cell : raw.cells) {
    if (!cell.isTraced) continue;
    const Point center{core.site(cell.slot).x, core.site(cell.slot).y};
    for (const RawRings::Ring& ring : raw.ringsOf(cell)) {
      const std::span<const Point> points = raw.pointsOf(ring);
      const auto numberOf = [&](Point p) {
        const std::uint32_t number = numbers_.add(p);
        fromSites.resize(numbers_.points().size(), 0);
        fromSites[number] = std::max(fromSites[number], length(p - center));
        return number;
      };
      for (std::uint32_t k = 0; k < ring.count; ++k) {
        if (raw.isBorder[ring.first + k] == 0) continue;
        const std::uint32_t from = numberOf(points[k]);
        segments_.push_back({from, numberOf(points[k + 1 < ring.count ? k + 1 : 0])});
      }
    }
  }
  const PointRounding rounding(box);
  for (const auto& [from, to] : segments_) {
    borderRounding_ += (rounding.at(fromSites[from]) + rounding.at(fromSites[to])) *
                       length(numbers_.points()[to] - numbers_.points()[from]);
  }
}

}  // namespace apollonius::internal
