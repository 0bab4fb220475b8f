// The nearest site of a point on the sphere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// The node of the site that is nearest to a point, to within twice the rounding of sites: 4 (loss
/// + 1) units of 2^-53 radians, with the loss of the projection. Any one of equally near sites.
/// REQUIRES: not empty. Throws std::bad_alloc. Cost: one location in the plane, a few steps, and
/// one step for each site that is equally near up to rounding.
[[nodiscard]] VertexId nearestNode(const ProjectedDiagram& diagram, const Direction& point);

/// Calls visit(k, point) for each of the points longitude, latitude in degrees, in the order of the
/// grid, so that the data that a walk reads is still in the cache. Throws std::bad_alloc.
template <class Visit>
void visitPoints(const ProjectedDiagram& diagram, std::span<const double> lonLat, Visit&& visit) {
  FlatArray<Direction> points(lonLat.size() / 2);
  FlatArray<Keyed> order(points.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    const std::size_t at = 2 * std::size_t{k};
    points[k] = directionOf({lonLat[at], lonLat[at + 1]});
    order[k] = {diagram.cellOf(points[k]), k};
  }
  sortByKey(order);
  for (const Keyed& point : order) visit(std::size_t{point.value}, points[point.value]);
}

/// The nearest site of each of the points longitude, latitude in degrees, or kNoSite in an empty
/// diagram. Throws std::bad_alloc. Cost: as nearestNode() for each; many points are located along a
/// curve.
void listNearest(const ProjectedDiagram& diagram, std::span<const double> lonLat,
                 std::span<SiteId> ids);

}  // namespace apollonius::internal::sphere
