// The part `sphere` for Embind: the diagram of the sphere.
#include <memory>
#include <utility>
#include <vector>

#include "adapters.h"
#include "apollonius/spherical_diagram.h"
#include "parts.h"

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

void sphereFromBytes(SphericalDiagram& diagram, const NumbersIn& bytes) {
  check(diagram.fromBytes(vectorOf<std::uint8_t>(bytes)));
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
  registerDiagram<SphericalDiagram, SphericalNearestFirst>("SphericalDiagram",
                                                           "SphericalNearestFirst")
      .constructor(&createSpherical, allow_raw_pointers())
      .function("radius", &SphericalDiagram::radius)
      .function("insertMany", &insertIntoSphere)
      .function("contains", returning<&SphericalDiagram::contains>())
      .function("cellArea", returning<&SphericalDiagram::cellArea>())
      .function("cellAreas", returning<&SphericalDiagram::cellAreas>())
      .function("cellCentroid", returning<&SphericalDiagram::cellCentroid>())
      .function("cellPolygon", returning<&SphericalDiagram::cellPolygon>(), moved)
      .function("cellPolygons", returning<&SphericalDiagram::cellPolygons>(), moved)
      .function("fromBytes", &sphereFromBytes);
}
