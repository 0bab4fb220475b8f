// Queries about places: the sites near a point, the circle under a pointer, the circles in a
// window.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"
#include "predicate/distance.h"

namespace apollonius::internal {

/// The id of a slot; kNoSite for kNoSlot.
[[nodiscard]] inline SiteId idOrNone(const DiagramCore& diagram, Slot slot) {
  return slot == kNoSlot ? kNoSite : diagram.ids().idOf(slot);
}
/// From (x, y) to a site, as a double; infinite for kNoSlot.
[[nodiscard]] inline double distanceTo(const DiagramCore& diagram, Slot slot, double x, double y) {
  return slot == kNoSlot ? std::numeric_limits<double>::infinity()
                         : roundedDistance(x, y, diagram.site(slot));
}

/// The nearest site of each of the points x, y, or kNoSite in an empty diagram, and its distance
/// unless `distances` is empty. Throws std::bad_alloc. Cost: O(1) a point where sites are spread
/// evenly, O(log n) else, both expected; many points are visited along a curve, so that what a walk
/// reads is still in the cache.
void listNearest(const DiagramCore& diagram, std::span<const double> xy, std::span<SiteId> ids,
                 std::span<double> distances);

/// The first `most` sites of a NearbySearch. Replaces the contents of `sites`. Throws
/// std::bad_alloc.
void listNearby(const DiagramCore& diagram, double x, double y, std::size_t most, double farthest,
                std::vector<SiteId>& sites);

/// Of the sites whose circles contain the point, rim included, the one on top; else the nearest one
/// if it is not farther than `farthest`; else kNoSite. Throws std::bad_alloc. Cost: one location
/// and O(m log m), m = the neighbours of the circles that contain the point.
[[nodiscard]] SiteId pick(const DiagramCore& diagram, double x, double y, double farthest, Top top);

/// The sites whose circles meet a closed rectangle, which may be a segment or a point; none of
/// negative radius. In ascending order of ids. Replaces the contents of `sites`. Throws
/// std::bad_alloc. REQUIRES: low <= high. Cost: on sites spread evenly O(m log m), m = the sites
/// found and those around the border.
void listMeeting(const DiagramCore& diagram, double xmin, double ymin, double xmax, double ymax,
                 std::vector<SiteId>& sites);

}  // namespace apollonius::internal
