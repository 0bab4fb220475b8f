// Areas and centroids of cells on the unit sphere.
#pragma once

#include <vector>

#include "sphere/cell.h"

namespace apollonius::internal::sphere {

/// The area of the cell of a visible site, of which all sectors are given, and, unless `moment` is
/// null, the vector integral of its points.
[[nodiscard]] double areaOfCell(const Cap& cap, const FlatArray<Sector>& sectors,
                                Direction* moment = nullptr);

/// The areas of all cells by id, 0 for hidden sites and free ids; they add up to 4 pi. Replaces the
/// contents. Throws std::bad_alloc. Cost: O(n).
void listAreas(const ProjectedDiagram& diagram, const SiteTable& sites, std::vector<double>& areas);

}  // namespace apollonius::internal::sphere
