// Voronoi circles of sites on a grid: integers, multiples of a power of two, pixels. People who
// give such numbers expect 150, not 149.99999999999997.
#pragma once

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

enum class OnGrid : unsigned char { kNo, kYes, kYesRounded };

/// Computes the circle of a counter-clockwise face of three sites whose coordinates and weights are
/// multiples of one unit, no further apart than 2^17 units. kYesRounded, for equal weights only:
/// the centre, and its distance from i, are rounded correctly (the clearance is that distance less
/// i's weight). kYes: the sites are such, but the circle is not known. REQUIRES: i is the reference
/// site.
[[nodiscard]] OnGrid circleOnGrid(const Site& i, const Site& j, const Site& k,
                                  VoronoiCircle& circle);

}  // namespace apollonius::internal
