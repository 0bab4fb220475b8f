// Empty circles on the sphere: about the places that are farthest from all sites.
#pragma once

#include <cstddef>

#include "apollonius/types.h"
#include "sphere/projected_diagram.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

/// The `most` largest circles that no site reaches into, none of which has its centre in one before
/// it: longitude and latitude, the distance to the nearest site, and that one site. Replaces the
/// contents. Throws std::bad_alloc. Cost: O(h (log n + most)).
void listEmptyCircles(const ProjectedDiagram& diagram, const SiteTable& sites, std::size_t most,
                      VertexArrays& circles);

}  // namespace apollonius::internal::sphere
