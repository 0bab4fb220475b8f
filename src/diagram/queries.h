// Queries about places: the sites near a point, the circle under a pointer, the circles in a
// window.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

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
