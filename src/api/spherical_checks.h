// What the calls of SphericalDiagram check in another way than those of the plane (checks.h).
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "api/checks.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

inline Error checkPoint(const SphericalCore&, double lon, double lat) {
  if (!std::isfinite(lon) || !std::isfinite(lat)) return Error::kNotFinite;
  return lat >= -90 && lat <= 90 ? Error::kNone : Error::kOutOfRange;
}

/// Checks pairs of longitude and latitude.
inline Error checkPoints(const SphericalCore& core, std::span<const double> lonLat) {
  for (std::size_t k = 0; k + 1 < lonLat.size(); k += 2) {
    const Error error = checkPoint(core, lonLat[k], lonLat[k + 1]);
    if (error != Error::kNone) return error;
  }
  return Error::kNone;
}

inline Error checkWeight(const SphericalCore& core, double r) {
  if (!std::isfinite(r)) return Error::kNotFinite;
  return std::abs(r) / core.sites().radius() < std::numbers::pi ? Error::kNone : Error::kOutOfRange;
}

/// Checks triples of longitude, latitude, weight.
inline Error checkSites(const SphericalCore& core, std::span<const double> sites) {
  for (std::size_t k = 0; k + 2 < sites.size(); k += 3) {
    const Error error =
        firstOf(checkPoint(core, sites[k], sites[k + 1]), checkWeight(core, sites[k + 2]));
    if (error != Error::kNone) return error;
  }
  return Error::kNone;
}

template <class... Arguments>
[[nodiscard]] Error guarded(const SphericalCore& core, Arguments&&... arguments) {
  return internal::guarded(core.projected().plane(), arguments...);
}

}  // namespace apollonius::internal::sphere
