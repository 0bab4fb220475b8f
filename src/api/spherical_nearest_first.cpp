#include "api/spherical_checks.h"
#include "sphere/nearby.h"

namespace apollonius {

using namespace internal;
using namespace internal::sphere;

SphericalNearestFirst::SphericalNearestFirst(const SphericalDiagram& diagram) noexcept
    : diagram_(&diagram) {}
SphericalNearestFirst::~SphericalNearestFirst() = default;
SphericalNearestFirst::SphericalNearestFirst(SphericalNearestFirst&&) noexcept = default;

Error SphericalNearestFirst::start(double lon, double lat, double maxDistance) {
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  if (std::isnan(maxDistance)) return Error::kNotFinite;
  const SphericalCore& core = *diagram_->core_;
  return guarded(core, [&] {
    search_ = std::make_unique<SphericalSearch>(core.projected(), core.sites(),
                                                directionOf({lon, lat}), maxDistance);
  });
}

Error SphericalNearestFirst::next(SiteId& id) {
  id = kNoSite;
  if (search_ == nullptr) return Error::kNone;
  const Error error = guarded(*diagram_->core_, [&] { id = search_->next(); });
  if (error != Error::kNone) search_.reset();
  return error;
}

double SphericalNearestFirst::distance() const {
  return search_ == nullptr ? std::numeric_limits<double>::infinity() : search_->distance();
}

}  // namespace apollonius
