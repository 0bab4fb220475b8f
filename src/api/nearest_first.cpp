#include "api/nearest_first.h"

#include "diagram/plane.h"

namespace apollonius {

template <>
struct NearestFirst::Search : internal::NearbySearch<internal::Plane> {
  Search(const internal::DiagramCore& core, double x, double y, double maxDistance)
      : NearbySearch(internal::Plane(core), {x, y}, maxDistance) {}
};

template class NearestFirstOf<Diagram>;

}  // namespace apollonius
