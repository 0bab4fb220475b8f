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

/// Hash of a directed segment; that of its reverse is the negative.
std::uint64_t directedHash(Point from, Point to) {
  return isLeftOf(from, to) ? hashOf(from, to) : 0 - hashOf(to, from);
}

/// Does a ring that turns counter-clockwise around a centre at each step do so once?
bool turnsOnce(const Corners& ring, Point center) {
  int turns = 0;
  for (std::uint32_t k = 0; k < ring.size(); ++k)
    turns += static_cast<int>(ring[k].y < center.y && ring[k + 1].y >= center.y);
  return turns == 1;
}

bool isAround(const Corners& ring, Point center) {
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    if (orient2d(center, ring[k], ring[k + 1]) != Sign::kPositive) return false;
  }
  return turnsOnce(ring, center);
}

/// REQUIRES: the ring is simple.
bool isCounterClockwise(const Corners& ring) {
  std::uint32_t first = 0;
  for (std::uint32_t k = 1; k < ring.size(); ++k) {
    if (isLeftOf(ring[k], ring[first])) first = k;
  }
  return orient2d(ring[first > 0 ? first - 1 : ring.size() - 1], ring[first], ring[first + 1]) ==
         Sign::kPositive;
}

}  // namespace

TilingProof::TilingProof(const DiagramCore& core, const Rectangle& box, const CellList& raw)
    : core_(core), box_(box), raw_(raw) {
  FlatArray<double> fromSites;  // by point: the largest distance
  for (const CellList::Cell& cell : raw.cells) {
    if (!cell.isTraced) continue;
    const Point center{core.site(cell.slot).x, core.site(cell.slot).y};
    const auto numberOf = [&](Point p) {
      const std::uint32_t number = numbers_.add(p);
      fromSites.resize(numbers_.points().size(), 0);
      fromSites[number] = std::max(fromSites[number], length(p - center));
      return number;
    };
    for (std::uint32_t ring = raw.firstRing(cell); ring < raw.endRing(cell); ++ring) {
      const Corners corners = raw.rings.corners(ring);
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        if (raw.isBorder[raw.rings.starts[ring] + k] == 0) continue;
        const std::uint32_t from = numberOf(corners[k]);
        segments_.push_back({from, numberOf(corners[k + 1])});
      }
    }
  }
  const PointRounding rounding(box);
  for (const auto& [from, to] : segments_) {
    borderRounding_ += (rounding.at(fromSites[from]) + rounding.at(fromSites[to])) *
                       length(numbers_.points()[to] - numbers_.points()[from]);
  }
}

bool TilingProof::holds() {
  if (doAnyMeet()) return false;
  std::uint64_t sum = 0;
  for (const CellList::Cell& cell : raw_.cells) {
    const Point center{core_.site(cell.slot).x, core_.site(cell.slot).y};
    for (std::uint32_t ring = raw_.firstRing(cell); ring < raw_.endRing(cell); ++ring) {
      const Corners corners = raw_.rings.corners(ring);
      // A ring that is not traced is known to turn to the left at each step.
      if (cell.isTraced ? !isAround(corners, center) && !isSimple(corners)
                        : !turnsOnce(corners, center))
        return false;
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        if (raw_.isBorder[raw_.rings.starts[ring] + k] == 0)
          sum += directedHash(corners[k], corners[k + 1]);
      }
    }
  }
  return sum == 0;
}

bool TilingProof::isSimple(const Corners& ring) {
  numbers_.clear();
  segments_.clear();
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    if (numbers_.add(ring[k]) != k) return false;
    segments_.push_back({k, (k + 1) % ring.size()});
  }
  return !doAnyMeet() && isCounterClockwise(ring);
}

/// Do any of the segments meet?
bool TilingProof::doAnyMeet() const {
  const FlatArray<Point>& points = numbers_.points();
  Rectangle box = box_;
  for (const Point p : points) box.include(p);
  bool isAny = false;
  SegmentPairs(points, segments_, box).visitWitnesses([&](std::uint32_t k, std::uint32_t m) {
    isAny = isAny || doMeet(points, segments_[k], segments_[m]);
  });
  return isAny;
}

}  // namespace apollonius::internal
