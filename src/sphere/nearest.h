// The nearest site of a point on the sphere.
#pragma once

#include <span>

#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// The node of the site that is nearest to a point, to within some 10^-15 radians; of sites that
/// are equally near, any. REQUIRES: not empty. Cost: one location in the plane and a few steps.
[[nodiscard]] VertexId nearestNode(const ProjectedDiagram& diagram, const Direction& point);

/// The nearest site of each of the points longitude, latitude in degrees, or kNoSite in an empty
/// diagram. Throws std::bad_alloc. Cost: as nearestNode() for each; many points are located along a
/// curve.
void listNearest(const ProjectedDiagram& diagram, std::span<const double> lonLat,
                 std::span<SiteId> ids);

}  // namespace apollonius::internal::sphere
