// Areas, centroids and perimeters of cells on the unit sphere.
#pragma once

#include <vector>

#include "sphere/cell.h"

namespace apollonius::internal::sphere {

/// The area of the part of a visible site's cell within the angle `reach` of the centre; and,
/// unless `moment` is null, the vector integral of its points. REQUIRES: all sectors of the cell
/// are given; reach > 0.
[[nodiscard]] double areaOfCell(const Cap& cap, const FlatArray<Sector>& sectors, double reach,
                                Direction* moment = nullptr);
/// The length of the boundary of that part.
[[nodiscard]] double perimeterOfCell(const FlatArray<Sector>& sectors, double reach);

/// The area between a site and a part of one of its bisectors.
[[nodiscard]] double areaBelow(const SphericalBisector& bisector, double from, double width);

enum class CellMeasure : unsigned char { kArea, kPerimeter };

/// The measure of one cell, 0 without one. Throws std::bad_alloc. Cost: O(d).
[[nodiscard]] double measureOf(const ProjectedDiagram& diagram, SiteId site, CellMeasure measure,
                               const AngularReach& reach);
/// Lists the measures of all cells by id, 0 for hidden sites and free ids; without a reach, areas
/// add up to 4 pi. Replaces the contents. Throws std::bad_alloc. Cost: O(n).
void listMeasures(const ProjectedDiagram& diagram, const SiteTable& sites, CellMeasure measure,
                  const AngularReach& reach, std::vector<double>& measures);

}  // namespace apollonius::internal::sphere
