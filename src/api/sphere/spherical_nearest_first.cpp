#include "api/nearest_first.h"
#include "api/sphere/spherical_checks.h"
#include "apollonius/spherical_diagram.h"
#include "sphere/nearby.h"

namespace apollonius {

template <>
struct SphericalNearestFirst::Search : internal::NearbySearch<internal::sphere::Sphere> {
  Search(const internal::sphere::SphericalCore& core, double lon, double lat, double maxDistance)
      : NearbySearch(internal::sphere::Sphere(core), internal::sphere::directionOf({lon, lat}),
                     maxDistance) {}
};

template class NearestFirstOf<SphericalDiagram>;

}  // namespace apollonius
