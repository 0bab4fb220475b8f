// The cells of SphericalDiagram: measures and polygons.
#include <cmath>
#include <numbers>

#include "api/spherical_checks.h"
#include "base/flat_array.h"
#include "sphere/measures.h"
#include "sphere/nearest.h"
#include "sphere/polygons.h"

namespace apollonius {

using namespace internal;
using namespace internal::sphere;

namespace {

Error checkTolerance(double tolerance) {
  if (!std::isfinite(tolerance)) return Error::kNotFinite;
  return tolerance >= kFinestTolerance ? Error::kNone : Error::kOutOfRange;
}

/// Do rings have the area of the rectangle of all longitudes and latitudes? Slivers that rounding
/// turns over change it by less.
bool isRectangleCovered(const LonLatRings& rings) {
  constexpr double kWhole = 360.0 * 180, kSlivers = 1e-6;
  double doubled = 0;
  for (std::size_t ring = 0; ring + 1 < rings.starts.size(); ++ring) {
    for (std::size_t k = rings.starts[ring]; k + 1 < rings.starts[ring + 1]; ++k) {
      const double* p = &rings.coordinates[2 * k];
      doubled += (p[0] - p[2]) * (p[1] + p[3]);
    }
  }
  return std::abs(doubled / 2 - kWhole) <= kSlivers * kWhole;
}

/// To the arrays of one cell or of all.
template <class Arrays>
void copyRings(const LonLatRings& rings, Arrays& arrays) {
  arrays.coordinates.assign(rings.coordinates.begin(), rings.coordinates.end());
  arrays.starts.assign(rings.starts.begin(), rings.starts.end());
  arrays.parts.assign(rings.parts.begin(), rings.parts.end());
}

}  // namespace

Error SphericalDiagram::contains(SiteId id, double lon, double lat, bool& inside) const {
  if (!has(id)) return Error::kUnknownSite;
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    const Direction point = directionOf({lon, lat});
    inside = !diagram.isHidden(id) && !(distance(point, diagram.cap(nearestNode(diagram, point))) <
                                        distance(point, diagram.cap(diagram.nodeOf(id))));
  });
}

Error SphericalDiagram::cellArea(SiteId id, double& area) const {
  if (!has(id)) return Error::kUnknownSite;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    area = 0;
    if (diagram.isHidden(id)) return;
    const VertexId node = diagram.nodeOf(id);
    SphericalVertices vertices(diagram, SphericalVertices::Of::kSome);
    FlatArray<Sector> sectors;
    listSectors(diagram, node, vertices, sectors);
    area = areaOfCell(diagram.cap(node), sectors) * (radius() * radius());
  });
}

Error SphericalDiagram::cellAreas(std::vector<double>& areas) const {
  bool isWhole = true;
  const Error error = guarded(*core_, [&] {
    constexpr double kSphere = 4 * std::numbers::pi, kRounding = 1e-5;
    listAreas(core_->projected(), core_->sites(), areas);
    double sum = 0;
    for (const double area : areas) sum += area;
    isWhole = core_->sites().size() == 0 || std::abs(sum - kSphere) <= kRounding * kSphere;
    for (double& area : areas) area *= radius() * radius();
    if (!isWhole) areas.clear();
  });
  return error == Error::kNone && !isWhole ? Error::kBroken : error;
}

Error SphericalDiagram::cellCentroid(SiteId id, SphericalPoint& centroid) const {
  if (!has(id)) return Error::kUnknownSite;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    if (diagram.isHidden(id)) return;
    const VertexId node = diagram.nodeOf(id);
    SphericalVertices vertices(diagram, SphericalVertices::Of::kSome);
    FlatArray<Sector> sectors;
    listSectors(diagram, node, vertices, sectors);
    Direction moment;
    const double area = areaOfCell(diagram.cap(node), sectors, &moment);
    // Of a cell that is symmetric about the centre of the sphere, only rounding is left.
    const bool hasDirection = lengthOf(moment) > 0x1p-40 * area;
    const LonLat point = lonLatOf(hasDirection ? moment : diagram.cap(node).centre);
    centroid = {point.lon, point.lat};
  });
}

Error SphericalDiagram::cellPolygon(SiteId id, double tolerance, bool isCut,
                                    RingArrays& rings) const {
  if (!has(id)) return Error::kUnknownSite;
  if (const Error error = checkTolerance(tolerance); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    CellPolygons cells(diagram, tolerance, isCut, SphericalVertices::Of::kSome);
    if (!diagram.isHidden(id)) cells.append(diagram.nodeOf(id));
    copyRings(cells.rings(), rings);
  });
}

Error SphericalDiagram::cellPolygons(double tolerance, bool isCut, CoverageArrays& polygons) const {
  if (const Error error = checkTolerance(tolerance); error != Error::kNone) return error;
  bool isCovered = true;
  const Error error = guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    CellPolygons cells(diagram, tolerance, isCut, SphericalVertices::Of::kAll);
    FlatArray<SiteId> sites;
    FlatArray<std::uint32_t> ends{0};
    for (SiteId id = 0; id < core_->sites().idLimit(); ++id) {
      if (!has(id) || diagram.isHidden(id)) continue;
      cells.append(diagram.nodeOf(id));
      sites.push_back(id);
      ends.push_back(static_cast<std::uint32_t>(cells.rings().parts.size() - 1));
    }
    isCovered = !isCut || sites.empty() || isRectangleCovered(cells.rings());
    if (!isCovered) return;
    copyRings(cells.rings(), polygons);
    polygons.sites.assign(sites.begin(), sites.end());
    polygons.cells.assign(ends.begin(), ends.end());
  });
  return error == Error::kNone && !isCovered ? Error::kBroken : error;
}

}  // namespace apollonius
