// Checks that SphericalDiagram has in place of the plane's (checks.h): degrees, and weights below
// half a great circle.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "api/checks.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

inline Error takePoint(const SphericalCore&, double& lon, double& lat) {
  lon = taken(lon);
  lat = taken(lat);
  if (!std::isfinite(lon) || !std::isfinite(lat)) return Error::kNotFinite;
  return lat >= -90 && lat <= 90 ? Error::kNone : Error::kOutOfRange;
}

/// Checks pairs of longitude and latitude.
inline Error checkPoints(const SphericalCore& core, std::span<const double> lonLat) {
  for (std::size_t k = 0; k + 1 < lonLat.size(); k += 2) {
    double lon = lonLat[k], lat = lonLat[k + 1];
    const Error error = takePoint(core, lon, lat);
    if (error != Error::kNone) return error;
  }
  return Error::kNone;
}

inline Error takeWeight(const SphericalCore& core, double& r) {
  r = taken(r);
  if (!std::isfinite(r)) return Error::kNotFinite;
  return std::abs(r) / core.sites().radius() < std::numbers::pi ? Error::kNone : Error::kOutOfRange;
}

/// Checks triples of longitude, latitude, weight.
inline Error checkSites(const SphericalCore& core, std::span<const double> sites) {
  for (std::size_t k = 0; k + 2 < sites.size(); k += 3) {
    double lon = sites[k], lat = sites[k + 1], r = sites[k + 2];
    const Error error = firstOf(takePoint(core, lon, lat), takeWeight(core, r));
    if (error != Error::kNone) return error;
  }
  return Error::kNone;
}

template <class... Arguments>
[[nodiscard]] Error guarded(const SphericalCore& core, Arguments&&... arguments) {
  return internal::guarded(core.projected().plane(), arguments...);
}

}  // namespace apollonius::internal::sphere
