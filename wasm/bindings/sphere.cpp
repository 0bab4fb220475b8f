// The part `sphere` for Embind: the diagram of the sphere.
#include <memory>
#include <utility>
#include <vector>

#include "adapters.h"
#include "apollonius/builder.h"
#include "apollonius/nearest_first.h"
#include "apollonius/spherical_diagram.h"
#include "parts.h"

using apollonius::SphericalBuilder;
using apollonius::SphericalCircle;
using apollonius::SphericalDiagram;
using apollonius::SphericalNearestFirst;
using apollonius::SphericalPoint;

namespace {

/// REQUIRES: a radius that a sphere can have.
SphericalDiagram* createSpherical(double radius) {
  return allocating([&] { return new SphericalDiagram(radius); });
}

/// The new ids go to an array that is there before, so that nothing can fail when all are in.
void insertIntoSphere(SphericalDiagram& diagram, const NumbersIn& sites, const NumbersOut& ids) {
  const std::vector<double> numbers = vectorOf<double>(sites);
  auto inserted = allocating([&] { return std::vector<SiteId>(numbers.size() / 3); });
  check(diagram.insertMany(numbers, inserted));
  ids.call<void>("set", viewOf(inserted));
}

std::vector<double> cellAreas(const SphericalDiagram& diagram, const NumbersIn& distances) {
  std::vector<double> areas;
  check(diagram.cellAreas(vectorOf<double>(distances), areas));
  return areas;
}

std::vector<double> cellPerimeters(const SphericalDiagram& diagram, const NumbersIn& distances) {
  std::vector<double> perimeters;
  check(diagram.cellPerimeters(vectorOf<double>(distances), perimeters));
  return perimeters;
}

apollonius::CoverageArrays cellPolygons(const SphericalDiagram& diagram, const NumbersIn& distances,
                                        double tolerance, bool isCut) {
  apollonius::CoverageArrays polygons;
  check(diagram.cellPolygons(tolerance, isCut, vectorOf<double>(distances), polygons));
  return polygons;
}

/// The ids of neighbours, one an edge, and after them how near the edges come.
std::vector<double> cellNeighbors(const SphericalDiagram& diagram, SiteId id) {
  std::vector<SiteId> ids;
  std::vector<double> distances;
  check(diagram.cellNeighbors(id, ids, distances));
  return allocating([&] {
    distances.insert(distances.begin(), ids.begin(), ids.end());
    return std::move(distances);
  });
}

/// The ids of the natural neighbours, and after them their weights: `shapes` has the record.
std::vector<double> naturalWeights(const SphericalDiagram& diagram, double lon, double lat,
                                   double r) {
  apollonius::NaturalWeights found;
  check(diagram.naturalWeights(lon, lat, r, found));
  return allocating([&] {
    std::vector<double> numbers(found.ids.begin(), found.ids.end());
    numbers.insert(numbers.end(), found.weights.begin(), found.weights.end());
    return numbers;
  });
}

/// Values by id at points longitude, latitude, ….
std::vector<double> interpolate(const SphericalDiagram& diagram, const NumbersIn& values,
                                const NumbersIn& lonLat, double r) {
  const std::vector<double> points = vectorOf<double>(lonLat);
  auto results = allocating([&] { return std::vector<double>(points.size() / 2); });
  check(diagram.interpolate(vectorOf<double>(values), points, r, results));
  return results;
}

}  // namespace

void registerSphere() {
  using namespace emscripten;
  const return_value_policy::take_ownership moved;  // not copied
  value_object<SphericalCircle>("SphericalCircle")
      .field("lon", &SphericalCircle::lon)
      .field("lat", &SphericalCircle::lat)
      .field("r", &SphericalCircle::r);
  value_object<SphericalPoint>("SphericalPoint")
      .field("lon", &SphericalPoint::lon)
      .field("lat", &SphericalPoint::lat);
  const auto diagram = registerDiagram<SphericalDiagram>("SphericalDiagram");
  registerOthers<SphericalNearestFirst, SphericalBuilder>(diagram, "SphericalNearestFirst",
                                                          "SphericalBuilder");
  diagram.constructor(&createSpherical, allow_raw_pointers())
      .function("radius", &SphericalDiagram::radius)
      .function("insertMany", &insertIntoSphere)
      .function("narrowest", returning<&SphericalDiagram::narrowest>(), moved)
      .function("emptyCircles", returning<&SphericalDiagram::emptyCircles>(), moved)
      .function("cellNeighbors", &cellNeighbors)
      .function("cellArea", returning<&SphericalDiagram::cellArea>())
      .function("cellPerimeter", returning<&SphericalDiagram::cellPerimeter>())
      .function("cellAreas", &cellAreas)
      .function("cellPerimeters", &cellPerimeters)
      .function("cellCentroid", returning<&SphericalDiagram::cellCentroid>())
      .function("cellCircle", returning<&SphericalDiagram::cellCircle>())
      .function("cellPolygon", returning<&SphericalDiagram::cellPolygon>(), moved)
      .function("cellPolygons", &cellPolygons, moved)
      .function("naturalWeights", &naturalWeights)
      .function("interpolate", &interpolate);
}
