// The nearest site of a point on the sphere.
#pragma once

#include <span>

#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// The node of the site that is nearest to a point, to within twice the rounding of sites: 4 (loss
/// + 1) units of 2^-53 radians, with the loss of the projection. Of sites that are equally near,
/// any. REQUIRES: not empty. Throws std::bad_alloc. Cost: one location in the plane and a few
/// steps, and one for each site that is equally near but for rounding.
[[nodiscard]] VertexId nearestNode(const ProjectedDiagram& diagram, const Direction& point);

/// The nearest site of each of the points longitude, latitude in degrees, or kNoSite in an empty
/// diagram. Throws std::bad_alloc. Cost: as nearestNode() for each; many points are located along a
/// curve.
void listNearest(const ProjectedDiagram& diagram, std::span<const double> lonLat,
                 std::span<SiteId> ids);

}  // namespace apollonius::internal::sphere
