// The cells of SphericalDiagram: measures, polygons, and the parts that a new cell would take.
#include <cmath>
#include <limits>
#include <numbers>

#include "api/sphere/spherical_checks.h"
#include "apollonius/spherical_diagram.h"
#include "base/flat_array.h"
#include "sphere/inner_circle.h"
#include "sphere/listing.h"
#include "sphere/measures.h"
#include "sphere/natural_neighbors.h"
#include "sphere/nearby.h"
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

Error SphericalDiagram::distancesError(std::span<const double> distances) const {
  for (const double distance : distances) {
    if (std::isnan(distance)) return Error::kNotFinite;
    if (distance != kEverywhere && !isInRange(taken(distance))) return Error::kOutOfRange;
  }
  return checkLength(distances.size() <= 1 || distances.size() == idLimit());
}

Error SphericalDiagram::cellError(SiteId id, double distance) const {
  return has(id) ? distancesError({&distance, 1}) : Error::kUnknownSite;
}

Error SphericalDiagram::cellNeighbors(SiteId id, std::vector<SiteId>& neighbors,
                                      std::vector<double>& distances) const {
  return guarded(*core_, checkIds(*this, {&id, 1}),
                 [&] { listNeighbors(core_->projected(), id, radius(), neighbors, distances); });
}

Error SphericalDiagram::contains(SiteId id, double lon, double lat, double distance,
                                 bool& inside) const {
  const Error error = firstOf(cellError(id, distance), takePoint(*core_, lon, lat));
  return guarded(*core_, error, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    const Direction point = directionOf({lon, lat});
    inside = !diagram.isHidden(id) && distanceTo(core_->sites(), id, point) <= taken(distance) &&
             !(internal::sphere::distance(point, diagram.cap(nearestNode(diagram, point))) <
               internal::sphere::distance(point, diagram.cap(diagram.nodeOf(id))));
  });
}

Error SphericalDiagram::cellArea(SiteId id, double distance, double& area) const {
  return guarded(*core_, cellError(id, distance), [&] {
    area = measureOf(core_->projected(), id, CellMeasure::kArea, {{&distance, 1}, radius()}) *
           (radius() * radius());
  });
}

Error SphericalDiagram::cellPerimeter(SiteId id, double distance, double& perimeter) const {
  return guarded(*core_, cellError(id, distance), [&] {
    perimeter =
        measureOf(core_->projected(), id, CellMeasure::kPerimeter, {{&distance, 1}, radius()}) *
        radius();
  });
}

Error SphericalDiagram::cellAreas(std::span<const double> distances,
                                  std::vector<double>& areas) const {
  bool isWhole = true;
  const Error error = guarded(*core_, distancesError(distances), [&] {
    constexpr double kSphere = 4 * std::numbers::pi, kRounding = 1e-5;
    const AngularReach reach(distances, radius());
    listMeasures(core_->projected(), core_->sites(), CellMeasure::kArea, reach, areas);
    double sum = 0;
    for (const double area : areas) sum += area;
    const double missing = kSphere - sum;
    isWhole = core_->sites().size() == 0 ||
              (reach.isUnlimited() ? std::abs(missing) : -missing) <= kRounding * kSphere;
    for (double& area : areas) area *= radius() * radius();
    if (!isWhole) areas.clear();
  });
  return error == Error::kNone && !isWhole ? Error::kBroken : error;
}

Error SphericalDiagram::cellPerimeters(std::span<const double> distances,
                                       std::vector<double>& perimeters) const {
  return guarded(*core_, distancesError(distances), [&] {
    listMeasures(core_->projected(), core_->sites(), CellMeasure::kPerimeter, {distances, radius()},
                 perimeters);
    for (double& perimeter : perimeters) perimeter *= radius();
  });
}

Error SphericalDiagram::cellCentroid(SiteId id, double distance, SphericalPoint& centroid) const {
  return guarded(*core_, cellError(id, distance), [&] {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    centroid = {kNone, kNone};
    const ProjectedDiagram& diagram = core_->projected();
    if (diagram.isHidden(id)) return;
    const VertexId node = diagram.nodeOf(id);
    const double most = AngularReach({&distance, 1}, radius()).of(diagram, node);
    if (!(most > 0)) return;
    SphericalVertices vertices(diagram, SphericalVertices::Of::kSome);
    FlatArray<Sector> sectors;
    listSectors(diagram, node, vertices, sectors);
    Direction moment;
    const double area = areaOfCell(diagram.cap(node), sectors, most, &moment);
    // The moment of a cell that is symmetric about the sphere's centre is nothing but rounding.
    const bool hasDirection = lengthOf(moment) > 0x1p-40 * area;
    const LonLat point = lonLatOf(hasDirection ? moment : diagram.cap(node).centre);
    centroid = {point.lon, point.lat};
  });
}

Error SphericalDiagram::cellCircle(SiteId id, double distance, SphericalCircle& circle) const {
  bool isFound = true;
  const Error error = guarded(*core_, cellError(id, distance), [&] {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    circle = {kNone, kNone, kNone};
    const ProjectedDiagram& diagram = core_->projected();
    if (diagram.isHidden(id)) return;
    const VertexId node = diagram.nodeOf(id);
    const AngularReach reach({&distance, 1}, radius());
    if (!(reach.of(diagram, node) > 0)) return;
    InnerCircle found;
    isFound = findInnerCircle(diagram, node, reach, found);
    const LonLat centre = lonLatOf(found.centre);
    if (isFound) circle = {centre.lon, centre.lat, found.radius * radius()};
  });
  return error == Error::kNone && !isFound ? Error::kNoConvergence : error;
}

Error SphericalDiagram::cellPolygon(SiteId id, double tolerance, bool isCut, double distance,
                                    RingArrays& rings) const {
  const Error error = firstOf(cellError(id, distance), checkTolerance(tolerance));
  return guarded(*core_, error, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    CellPolygons cells(diagram, tolerance, isCut, {{&distance, 1}, radius()},
                       SphericalVertices::Of::kSome);
    if (!diagram.isHidden(id)) cells.append(diagram.nodeOf(id));
    copyRings(cells.rings(), rings);
  });
}

Error SphericalDiagram::cellPolygons(double tolerance, bool isCut,
                                     std::span<const double> distances,
                                     CoverageArrays& polygons) const {
  bool isCovered = true;
  const Error before = firstOf(checkTolerance(tolerance), distancesError(distances));
  const Error error = guarded(*core_, before, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    const AngularReach reach(distances, radius());
    CellPolygons cells(diagram, tolerance, isCut, reach, SphericalVertices::Of::kAll);
    FlatArray<SiteId> sites;
    FlatArray<std::uint32_t> ends{0};
    for (SiteId id = 0; id < core_->sites().idLimit(); ++id) {
      if (!has(id) || diagram.isHidden(id)) continue;
      cells.append(diagram.nodeOf(id));
      const auto end = static_cast<std::uint32_t>(cells.rings().parts.size() - 1);
      const bool isEmpty = end == ends.back();  // or it is the whole sphere
      if (isEmpty && reach.of(diagram, diagram.nodeOf(id)) < std::numbers::pi) continue;
      sites.push_back(id);
      ends.push_back(end);
    }
    const bool isCoverage = isCut && reach.isUnlimited() && !sites.empty();
    isCovered = !isCoverage || isRectangleCovered(cells.rings());
    if (!isCovered) return;
    copyRings(cells.rings(), polygons);
    polygons.sites.assign(sites.begin(), sites.end());
    polygons.cells.assign(ends.begin(), ends.end());
  });
  return error == Error::kNone && !isCovered ? Error::kBroken : error;
}

Error SphericalDiagram::naturalWeights(double lon, double lat, double r,
                                       NaturalWeights& found) const {
  const Error error = firstOf(takePoint(*core_, lon, lat), takeWeight(*core_, r));
  return guarded(*core_, error, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    found = {};
    if (diagram.isEmpty()) return;
    NaturalNeighbors neighbors(diagram, SphericalVertices::Of::kSome);
    for (const auto& [node, weight] : neighbors.find(capOf({lon, lat}, r / radius()))) {
      found.ids.push_back(diagram.siteOf(node));
      found.weights.push_back(weight);
    }
  });
}

Error SphericalDiagram::interpolate(std::span<const double> values, std::span<const double> lonLat,
                                    double r, std::span<double> results) const {
  const bool areLengthsGood = values.size() == idLimit() && lonLat.size() == 2 * results.size();
  const Error error =
      firstOf(checkLength(areLengthsGood), takeWeight(*core_, r), checkPoints(*core_, lonLat));
  return guarded(*core_, error, [&] {
    internal::sphere::interpolate(core_->projected(), values, TakenNumbers(lonLat), r / radius(),
                                  results);
  });
}

}  // namespace apollonius
