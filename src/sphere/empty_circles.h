// Empty circles on the sphere: about the points farthest from all sites.
#pragma once

#include <cstddef>

#include "apollonius/types.h"
#include "sphere/projected_diagram.h"
#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

/// Lists the `most` largest empty circles, none with its centre in a larger one: longitude and
/// latitude, the distance to the nearest site, and that site. Replaces the contents. Throws
/// std::bad_alloc. Cost: O(h (log n + most)).
void listEmptyCircles(const ProjectedDiagram& diagram, const SiteTable& sites, std::size_t most,
                      VertexArrays& circles);

}  // namespace apollonius::internal::sphere
