#include "geometry/polygons/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/radix_sort.h"
#include "geometry/window/segment_pairs.h"
#include "geometry/window/segment_sweep.h"
#include "number/fp.h"
#include "number/sum.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

/// Sites in general position need one or two rounds. Where thousands of edges come to one place
/// (sites on a circle), they are closer together than doubles can tell on a way longer than
/// rounding; detours only make more of them. So in each round from this one on, points four times
/// as far apart become one.
constexpr int kFirstWideRound = 4;
/// By then whatever meets would have become one point many rounds ago.
constexpr int kMostRounds = 64;
/// How far points of edges can be off, as a share of the window's numbers and of their distances
/// from the sites (docs/PROOFS.md, "Polygons").
constexpr double kRounding = powerOfTwo(-38);

/// Sums of areas are off by less than this share of the box around the window: a cross product is
/// off by four roundings of the box that its ring fills, and a ring is shorter than 2^10 boxes.
constexpr double kAreaRounding = powerOfTwo(-40);

/// The sum of the areas of rings, those of holes negative; `at(ring, k)` is one of its points.
template <class Count, class At>
double areaOf(std::size_t rings, Count&& count, At&& at) {
  Sum twice;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const std::size_t size = count(ring);
    if (size == 0) continue;
    const Point first = at(ring, 0);
    for (std::size_t k = 1; k + 1 < size; ++k)
      twice.add(cross(at(ring, k) - first, at(ring, k + 1) - first));
  }
  return twice.value() / 2;
}

class Mesh {
 public:
  Mesh(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box);

  /// Ends with no two segments that meet; false if that was not reached.
  bool part();
  void list(Coverage& coverage);
  /// Is the area of the rings that have been listed this one, up to rounding; or if it is not
  /// known, that of the rings as the cells gave them?
  [[nodiscard]] bool hasArea(double area, const Rings& listed) const;

 private:
  struct Ring {
    std::uint32_t first, count;  // of corners_
  };
  struct CellRings {
    SiteId site;
    std::uint32_t firstRing;
    bool isTraced;  // what has changed, or may touch
  };
  /// A segment goes through a point.
  struct Detour {
    std::uint32_t from, to, through;
  };

  [[nodiscard]] Point at(std::uint32_t number) const { return numbers_.points()[number]; }
  [[nodiscard]] bool isOnBorder(std::uint32_t point) const { return isOnBorder_[point] != 0; }
  /// How far a point can be off by rounding.
  [[nodiscard]] double roundingOf(std::uint32_t point) const {
    return kRounding * (size_ + fromSites_[point]);
  }
  void listSegments();
  void mendMeetings();
  void uniteTurned();
  void mend(const Segment& s, const Segment& t);
  bool uniteClose(std::span<const std::uint32_t> points);
  [[nodiscard]] std::uint32_t representative(std::uint32_t point);
  void unite(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] const Detour* detourOf(std::uint32_t a, std::uint32_t b,
                                       std::span<const Keyed> byEnd) const;
  void replacePoints();

  Rectangle box_;
  double size_;  // of the window's numbers
  PointNumbers numbers_;
  FlatArray<double> fromSites_;       // by point: the largest distance from a site it is seen from
  FlatArray<char> isOnBorder_;        // by point
  FlatArray<std::uint32_t> corners_;  // points of the rings, not repeated at their ends
  FlatArray<Ring> rings_;
  FlatArray<CellRings> cells_;
  FlatArray<Segment> segments_;      // each once
  FlatArray<std::uint32_t> united_;  // by point: itself or one that it became, in this round
  double closeness_ = 1;             // as many times as rounding: points so close can become one
  double givenArea_ = 0;             // of the rings as the cells gave them
  double areaRounding_ = 0;          // how far rounding can move the border, times its length
  bool isUnited_ = false;            // any in this round
  FlatArray<Detour> detours_;
  std::size_t work_ = 0;  // Coverage::work
};

Mesh::Mesh(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box)
    : box_(box),
      size_(std::max(absolute(box.xmin), absolute(box.xmax)) +
            std::max(absolute(box.ymin), absolute(box.ymax))) {
  Rings rings;
  FlatArray<char> isBorder;
  for (SiteId id = 0; id < core.ids().idLimit(); ++id) {
    const Slot slot = core.ids().slotOf(id);
    if (slot == kNoSlot) continue;
    const auto soundness = finder.findRaw(slot, rings, &isBorder);
    if (rings.ringCount() == 0) continue;
    cells_.push_back({id, static_cast<std::uint32_t>(rings_.size()),
                      soundness != PolygonFinder::Soundness::kSure});
    for (std::size_t k = 0; k < rings.ringCount(); ++k) {
      const std::span<const double> ring = rings.ring(k);
      const auto count = static_cast<std::uint32_t>(ring.size() / 2 - 1);
      rings_.push_back({static_cast<std::uint32_t>(corners_.size()), count});
      for (std::uint32_t m = 0; m < count; ++m)
        corners_.push_back(numbers_.add({ring[2 * m], ring[2 * m + 1]}));
    }
    isOnBorder_.resize(numbers_.points().size(), 0);
    fromSites_.resize(numbers_.points().size(), 0);
    const Point center{core.site(slot).x, core.site(slot).y};
    for (std::size_t k = 0; k < rings.ringCount(); ++k) {
      const Ring& ring = rings_[cells_.back().firstRing + k];
      for (std::uint32_t m = 0; m < ring.count; ++m) {
        double& farthest = fromSites_[corners_[ring.first + m]];
        farthest = std::max(farthest, length(at(corners_[ring.first + m]) - center));
        if (isBorder[rings.starts[k] + m] == 0) continue;
        isOnBorder_[corners_[ring.first + m]] = 1;
        isOnBorder_[corners_[ring.first + (m + 1) % ring.count]] = 1;
      }
    }
  }
  givenArea_ = areaOf(
      rings_.size(), [&](std::size_t k) { return rings_[k].count; },
      [&](std::size_t k, std::size_t m) { return at(corners_[rings_[k].first + m]); });
  for (const Ring& ring : rings_) {
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const std::uint32_t a = corners_[ring.first + k],
                          b = corners_[ring.first + (k + 1) % ring.count];
      if (isOnBorder(a) && isOnBorder(b))
        areaRounding_ += (roundingOf(a) + roundingOf(b)) * length(at(b) - at(a));
    }
  }
}

bool Mesh::part() {
  for (int round = 0; round < kMostRounds; ++round) {
    if (round >= kFirstWideRound) closeness_ *= 4;
    listSegments();
    mendMeetings();
    uniteTurned();
    if (!isUnited_ && detours_.empty()) return true;
    replacePoints();
  }
  return false;
}

/// Lists each segment once: in one direction where two cells have it, as it is on the border.
void Mesh::listSegments() {
  segments_.clear();
  for (const Ring& ring : rings_) {
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const std::uint32_t a = corners_[ring.first + k],
                          b = corners_[ring.first + (k + 1) % ring.count];
      if (a < b || (a != b && isOnBorder(a) && isOnBorder(b))) segments_.push_back({a, b});
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

/// Unites those that are so close; of two or four points.
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

/// Of two segments that meet: unites the two ends that are closest, if they are apart by rounding;
/// or sends one segment through the end of the other that is closest to it.
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

/// Of a cell that rounding has turned around, unites the two points that are closest.
void Mesh::uniteTurned() {
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Ring& ring = rings_[cells_[c].firstRing];  // the others are at the border
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

/// A point of the border is kept; of others, the left one.
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
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const std::size_t end = c + 1 < cells_.size() ? cells_[c + 1].firstRing : rings_.size();
    for (std::size_t r = cells_[c].firstRing; r < end; ++r) {
      Ring& ring = rings_[r];
      const auto first = static_cast<std::uint32_t>(corners.size());
      const auto add = [&](std::uint32_t point) {
        const std::uint32_t kept = representative(point);
        if (kept != point) cells_[c].isTraced = true;
        if (corners.size() == first || corners.back() != kept) corners.push_back(kept);
      };
      for (std::uint32_t k = 0; k < ring.count; ++k) {
        const std::uint32_t a = corners_[ring.first + k],
                            b = corners_[ring.first + (k + 1) % ring.count];
        add(a);
        const Detour* const detour = detourOf(a, b, byEnd);
        if (detour == nullptr) continue;
        cells_[c].isTraced = true;
        if (isOnBorder(a) && isOnBorder(b)) isOnBorder_[detour->through] = 1;
        add(detour->through);
      }
      while (corners.size() > first + 1 && corners.back() == corners[first]) corners.pop_back();
      ring = {first, static_cast<std::uint32_t>(corners.size()) - first};
    }
  }
  corners_.swap(corners);
}

void Mesh::list(Coverage& coverage) {
  Rings& all = coverage.rings;
  all.clear();
  coverage.sites.clear();
  coverage.cells.assign(1, 0);
  coverage.work = work_;
  Tracer tracer;
  Rings rings;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const std::size_t end = c + 1 < cells_.size() ? cells_[c + 1].firstRing : rings_.size();
    rings.clear();
    for (std::size_t r = cells_[c].firstRing; r < end; ++r) {
      const Ring& ring = rings_[r];
      for (std::uint32_t k = 0; k <= ring.count && ring.count > 0; ++k) {
        rings.add(at(corners_[ring.first + k % ring.count]));
      }
      if (ring.count > 0) rings.endRing();
    }
    if (cells_[c].isTraced) {
      tracer.clear();
      for (std::size_t k = 0; k < rings.ringCount(); ++k) tracer.addRing(rings.ring(k));
      tracer.trace(rings);
    } else {
      rings.endPart();  // inside the window a cell is one ring
    }
    if (rings.ringCount() == 0) continue;
    coverage.sites.push_back(cells_[c].site);
    const auto firstRing = static_cast<std::uint32_t>(all.ringCount());
    const auto firstPoint = static_cast<std::uint32_t>(all.coordinates.size() / 2);
    all.coordinates.append(rings.coordinates);
    for (std::size_t k = 1; k < rings.starts.size(); ++k)
      all.starts.push_back(firstPoint + rings.starts[k]);
    for (std::size_t k = 1; k < rings.parts.size(); ++k)
      all.parts.push_back(firstRing + rings.parts[k]);
    coverage.cells.push_back(static_cast<std::uint32_t>(all.parts.size() - 1));
  }
}

bool Mesh::hasArea(double area, const Rings& listed) const {
  const double found = areaOf(
      listed.ringCount(), [&](std::size_t k) { return listed.ring(k).size() / 2 - 1; },
      [&](std::size_t k, std::size_t m) {
        return Point{listed.ring(k)[2 * m], listed.ring(k)[2 * m + 1]};
      });
  const double whole = box_.width() * box_.height();
  return absolute(found - (std::isnan(area) ? givenArea_ : area)) <=
         closeness_ * areaRounding_ + kAreaRounding * whole;
}

}  // namespace

bool coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box, double area,
                 Coverage& coverage) {
  Mesh mesh(core, finder, box);
  const bool isParted = mesh.part();
  mesh.list(coverage);
  return coverage.sites.empty() ? core.visibleCount() == 0 || std::isnan(area)
                                : isParted && mesh.hasArea(area, coverage.rings);
}

}  // namespace apollonius::internal
