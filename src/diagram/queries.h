// Spatial queries: the sites near a point, the circles in a window.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"
#include "diagram/spatial_order.h"
#include "predicate/distance.h"

namespace apollonius::internal {

/// The id of a slot; kNoSite for kNoSlot.
[[nodiscard]] inline SiteId idOrNone(const DiagramCore& diagram, Slot slot) {
  return slot == kNoSlot ? kNoSite : diagram.ids().idOf(slot);
}
/// The distance from (x, y) to a site, as a double; infinite for kNoSlot.
[[nodiscard]] inline double distanceTo(const DiagramCore& diagram, Slot slot, double x, double y) {
  return slot == kNoSlot ? std::numeric_limits<double>::infinity()
                         : roundedDistance(x, y, diagram.site(slot));
}

/// Calls visit(k, hint) for each of the points x, y: k is its index, and `hint` a visible site
/// close to it, or kNoSlot if a search is better begun from scratch. visit() returns a visible site
/// near the point. Many points are visited along a curve, so that the memory that a walk reads is
/// still in the cache. Throws std::bad_alloc.
template <class Visit>
void visitPoints(const DiagramCore& diagram, std::span<const double> xy, Visit&& visit) {
  const std::size_t sites = diagram.visibleCount(), points = xy.size() / 2;
  // The number of points from which on sorting pays: few sites are in the cache anyway, and the
  // walk must be shorter than one from the grid.
  constexpr std::size_t kSitesInCache = 1 << 13;
  const std::size_t many = sites > kSitesInCache ? 64 : std::max(std::size_t{256}, 8 * sites);
  if (points < many) {
    for (std::size_t k = 0; k < points; ++k) (void)visit(k, kNoSlot);
    return;
  }
  // Sorts in portions, as points in the cache are sorted faster; but a portion has more points than
  // there are sites, so that a walk from one to the next is short.
  const std::size_t portion = std::max(std::size_t{1} << 14, 4 * sites);
  for (std::size_t begin = 0; begin < points; begin += portion) {
    const std::size_t count = std::min(portion, points - begin);
    // About √(sites / count) cells are between a point and the next. If these are few, a walk
    // starts where the one before ended; else like that of a single point.
    const bool isDense = count >= sites / 4;
    Slot near = kNoSlot;
    for (const std::uint32_t k : hilbertOrder({xy.subspan(2 * begin, 2 * count), 2}))
      near = visit(begin + k, isDense ? near : kNoSlot);
  }
}

/// Returns the site, or kNoSlot if it is farther from (x, y) than a limit, which may be infinite.
/// Exact.
[[nodiscard]] Slot orNone(const DiagramCore& diagram, Slot slot, double x, double y,
                          double maxDistance);

/// The nearest site of each of the points x, y that is not farther than `maxDistance`, or kNoSite,
/// and its distance unless `distances` is empty. Throws std::bad_alloc. Cost: O(1) a point where
/// sites are spread evenly, O(log n) else, both expected.
void listNearest(const DiagramCore& diagram, std::span<const double> xy, double maxDistance,
                 std::span<SiteId> ids, std::span<double> distances);

/// The first `most` sites of a NearbySearch. Replaces the contents of `sites`. Throws
/// std::bad_alloc.
void listNearby(const DiagramCore& diagram, double x, double y, std::size_t most,
                double maxDistance, std::vector<SiteId>& sites);

/// listNearby() for each of the points x, y. Replaces the contents of `lists`, with distances or
/// without. Throws std::bad_alloc.
void listNearbyMany(const DiagramCore& diagram, std::span<const double> xy, std::size_t most,
                    double maxDistance, bool withDistances, NearbyLists& lists);

/// The visible site whose far side is the farthest from (x, y), with the largest |p - c| + r; ties
/// go to the larger site in the order of precedes(). kNoSlot if there is none. Exact. Cost: O(h)
/// for h sites on the hull; the others do not reach as far in any direction.
[[nodiscard]] Slot farthestSite(const DiagramCore& diagram, double x, double y);

/// The sites whose circles meet a closed rectangle, which may be a segment or a point; none of
/// negative radius. In ascending order of ids. Replaces the contents of `sites`. Throws
/// std::bad_alloc. REQUIRES: low <= high. Cost: on sites spread evenly O(m log m), m = the sites
/// found and those around the border.
void listMeeting(const DiagramCore& diagram, double xmin, double ymin, double xmax, double ymax,
                 std::vector<SiteId>& sites);

}  // namespace apollonius::internal
