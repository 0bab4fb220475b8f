#include "geometry/polygons/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/radix_sort.h"
#include "geometry/window/segment_pairs.h"
#include "geometry/window/segment_sweep.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

/// Sites in general position need one or two rounds. Where thousands of edges meet at one point
/// (sites on a circle), they are closer together than doubles can tell, over a length beyond
/// rounding; detours only make more of them. So in each round from this one on, points four times
/// as far apart become one.
constexpr int kFirstWideRound = 4;
/// By then any segments that meet would have become one point many rounds before.
constexpr int kMostRounds = 64;

}  // namespace

PointRounding::PointRounding(const Rectangle& box)
    : size_(std::max(absolute(box.xmin), absolute(box.xmax)) +
            std::max(absolute(box.ymin), absolute(box.ymax))) {}

Mesh::Mesh(const DiagramCore& core, const Rectangle& box, CellList& raw)
    : box_(box), rounding_(box), raw_(raw), rings_(raw.rings.ringCount()) {
  for (const CellList::Cell& cell : raw.cells) {
    const Point center{core.site(cell.slot).x, core.site(cell.slot).y};
    for (std::uint32_t k = raw.firstRing(cell); k < raw.endRing(cell); ++k) {
      const Corners corners = raw.rings.corners(k);
      const std::size_t first = corners_.size();
      rings_[k] = {static_cast<std::uint32_t>(first), corners.size()};
      for (std::uint32_t m = 0; m < corners.size(); ++m)
        corners_.push_back(numbers_.add(corners[m]));
      isOnBorder_.resize(numbers_.points().size(), 0);
      fromSites_.resize(numbers_.points().size(), 0);
      for (std::uint32_t m = 0; m < corners.size(); ++m) {
        const std::uint32_t corner = corners_[first + m];
        fromSites_[corner] = std::max(fromSites_[corner], length(at(corner) - center));
        if (raw.isBorder[raw.rings.starts[k] + m] == 0) continue;
        isOnBorder_[corner] = isOnBorder_[corners_[first + (m + 1) % corners.size()]] = 1;
      }
    }
  }
}

bool Mesh::mend() {
  for (int round = 0; round < kMostRounds; ++round) {
    if (round >= kFirstWideRound) closeness_ *= 4;
    listSegments();
    mendMeetings();
    uniteTurned();
    if (!isUnited_ && detours_.empty()) {
      write();
      return true;
    }
    replacePoints();
  }
  return false;
}

/// Lists each segment once: interior ones in one direction, border ones as they stand.
void Mesh::listSegments() {
  segments_.clear();
  for (const CellList::Cell& cell : raw_.cells) {
    for (const Ring& ring : ringsOf(cell)) {
      for (std::uint32_t k = 0; k < ring.count; ++k) {
        const std::uint32_t a = corners_[ring.first + k],
                            b = corners_[ring.first + (k + 1) % ring.count];
        if (a < b || (a != b && isOnBorder(a) && isOnBorder(b))) segments_.push_back({a, b});
      }
    }
  }
}

void Mesh::mendMeetings() {
  const FlatArray<Point>& points = numbers_.points();
  united_.resize(points.size());
  for (std::uint32_t k = 0; k < united_.size(); ++k) united_[k] = k;
  isUnited_ = false;
  detours_.clear();
  work_ += segments_.size();
  SegmentPairs(points, segments_, box_).visitWitnesses([&](std::uint32_t k, std::uint32_t m) {
    ++work_;
    if (doMeet(points, segments_[k], segments_[m])) mend(segments_[k], segments_[m]);
  });
}

/// Unites those of two or four points that are close enough. True if there are any.
bool Mesh::uniteClose(std::span<const std::uint32_t> points) {
  bool isAny = false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t m = 0; m < k; ++m) {
      const std::uint32_t p = points[k], q = points[m];
      if (p == q || length(at(p) - at(q)) > closeness_ * roundingOf(p)) continue;
      unite(p, q);
      isAny = true;
    }
  }
  return isAny;
}

/// Mends two segments that meet: merges their two closest ends, if rounding explains the distance;
/// or leads one segment through the end of the other that is closest to it.
void Mesh::mend(const Segment& s, const Segment& t) {
  if (closeness_ > 1 && uniteClose(std::array{s.from, s.to, t.from, t.to})) return;
  std::pair<std::uint32_t, std::uint32_t> closest{s.from, t.from};
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t p : {s.from, s.to}) {
    for (const std::uint32_t q : {t.from, t.to}) {
      const double distance = length(at(p) - at(q));
      if (p == q || !(distance < least)) continue;
      least = distance;
      closest = {p, q};
    }
  }
  const bool isCommon = s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
  if (!isCommon && uniteClose(std::array{closest.first, closest.second})) return;
  const Segment* passing = nullptr;
  std::uint32_t through = 0;
  least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Segment& segment, std::uint32_t p) {
    if (p == segment.from || p == segment.to) return;
    const Point from = at(segment.from), way = at(segment.to) - from;
    const double along = dot(at(p) - from, way), square = dot(way, way);
    if (!(along > 0 && along < square)) return;
    const double distance = absolute(cross(way, at(p) - from)) / std::sqrt(square);
    if (!(distance < least)) return;
    least = distance;
    passing = &segment;
    through = p;
  };
  for (const std::uint32_t p : {t.from, t.to}) consider(s, p);
  for (const std::uint32_t p : {s.from, s.to}) consider(t, p);
  if (passing == nullptr) return unite(closest.first, closest.second);
  detours_.push_back({passing->from, passing->to, through});
}

/// Merges the two closest points of a cell that rounding has turned inside out.
void Mesh::uniteTurned() {
  for (const CellList::Cell& cell : raw_.cells) {
    const Ring& ring = rings_[raw_.firstRing(cell)];  // the others are at the border
    if (ring.count < 3) continue;
    const Point first = at(corners_[ring.first]);
    std::uint32_t a = corners_[ring.first + ring.count - 1];
    std::pair<std::uint32_t, std::uint32_t> closest;
    double area = 0, least = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const std::uint32_t b = corners_[ring.first + k];
      area += cross(at(a) - first, at(b) - first);
      const double distance = length(at(b) - at(a));
      if (distance < least) closest = {a, b};
      least = std::min(least, distance);
      a = b;
    }
    if (area > 0 || least > closeness_ * roundingOf(closest.first)) continue;
    unite(closest.first, closest.second);
  }
}

std::uint32_t Mesh::representative(std::uint32_t point) {
  while (united_[point] != point) point = united_[point] = united_[united_[point]];
  return point;
}

/// Merges two points: into the one on the border, or else into the left one.
void Mesh::unite(std::uint32_t a, std::uint32_t b) {
  a = representative(a);
  b = representative(b);
  if (a == b) return;
  const bool isFirst = isOnBorder(a) != isOnBorder(b) ? isOnBorder(a) : isLeftOf(at(a), at(b));
  united_[isFirst ? b : a] = isFirst ? a : b;
  isUnited_ = true;
}

/// The detour of a segment, in either direction, or null.
const Mesh::Detour* Mesh::detourOf(std::uint32_t a, std::uint32_t b,
                                   std::span<const Keyed> byEnd) const {
  const auto isBefore = [](const Keyed& entry, std::uint32_t key) { return entry.key < key; };
  auto at = std::lower_bound(byEnd.begin(), byEnd.end(), std::min(a, b), isBefore);
  for (; at != byEnd.end() && at->key == std::min(a, b); ++at) {
    const Detour& detour = detours_[at->value];
    if (std::max(detour.from, detour.to) == std::max(a, b)) return &detour;
  }
  return nullptr;
}

void Mesh::replacePoints() {
  FlatArray<Keyed> byEnd;  // detours by the smaller end
  for (std::uint32_t k = 0; k < detours_.size(); ++k)
    byEnd.push_back({std::min(detours_[k].from, detours_[k].to), k});
  sortByKey(byEnd);
  FlatArray<std::uint32_t> corners;
  for (CellList::Cell& cell : raw_.cells) {
    for (Ring& ring : ringsOf(cell)) {
      const auto first = static_cast<std::uint32_t>(corners.size());
      const auto add = [&](std::uint32_t point) {
        const std::uint32_t kept = representative(point);
        if (kept != point) cell.isTraced = true;
        if (corners.size() == first || corners.back() != kept) corners.push_back(kept);
      };
      for (std::uint32_t k = 0; k < ring.count; ++k) {
        const std::uint32_t a = corners_[ring.first + k],
                            b = corners_[ring.first + (k + 1) % ring.count];
        add(a);
        const Detour* const detour = detourOf(a, b, byEnd);
        if (detour == nullptr) continue;
        cell.isTraced = true;
        if (isOnBorder(a) && isOnBorder(b)) isOnBorder_[detour->through] = 1;
        add(detour->through);
      }
      while (corners.size() > first + 1 && corners.back() == corners[first]) corners.pop_back();
      ring = {first, static_cast<std::uint32_t>(corners.size()) - first};
    }
  }
  corners_.swap(corners);
}

/// Writes each ring to raw_ as a part.
void Mesh::write() {
  Rings mended;
  for (CellList::Cell& cell : raw_.cells) {
    const std::span<const Ring> rings = ringsOf(cell);
    cell.firstPart = static_cast<std::uint32_t>(mended.partCount());
    for (const Ring& ring : rings) {
      for (std::uint32_t m = 0; m <= ring.count; ++m)
        mended.add(at(corners_[ring.first + m % ring.count]));
      mended.endRing();
      mended.endPart();
    }
    cell.endPart = static_cast<std::uint32_t>(mended.partCount());
  }
  raw_.rings = std::move(mended);
  raw_.isBorder.clear();
}

}  // namespace apollonius::internal
