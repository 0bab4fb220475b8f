// The sites around a point, in the order of their distance: kNearest and within.
#pragma once

#include <cstddef>
#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

/// Sites in the order of their distance to (x, y), at most `most`, and none farther than `farthest`
/// if that is given; ties as in DiagramCore::nearest(). Replaces the contents of `sites`. Throws
/// std::bad_alloc. Cost: one location and O(m log m), m = the neighbours of the sites found.
void listNearby(const DiagramCore& diagram, double x, double y, std::size_t most,
                const double* farthest, std::vector<SiteId>& sites);

}  // namespace apollonius::internal
