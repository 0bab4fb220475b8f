// What the calls of SphericalDiagram do before and after their work, as checks.h has it for the
// plane.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "api/checks.h"
#include "apollonius/spherical_diagram.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

inline Error checkPoint(double lon, double lat) {
  if (!std::isfinite(lon) || !std::isfinite(lat)) return Error::kNotFinite;
  return lat >= -90 && lat <= 90 ? Error::kNone : Error::kOutOfRange;
}

/// Pairs of longitude and latitude.
inline Error checkPoints(std::span<const double> lonLat) {
  for (std::size_t k = 0; k < lonLat.size(); k += 2) {
    if (const Error error = checkPoint(lonLat[k], lonLat[k + 1]); error != Error::kNone)
      return error;
  }
  return Error::kNone;
}

/// Triples of longitude, latitude, weight.
inline Error checkSites(std::span<const double> sites, double radius) {
  for (std::size_t k = 0; k < sites.size(); k += 3) {
    if (const Error error = checkPoint(sites[k], sites[k + 1]); error != Error::kNone) return error;
    if (!std::isfinite(sites[k + 2])) return Error::kNotFinite;
    if (!(std::abs(sites[k + 2]) / radius < std::numbers::pi)) return Error::kOutOfRange;
  }
  return Error::kNone;
}

/// Lack of memory becomes an error.
template <class Operation>
Error guarded(const SphericalCore& core, Operation&& operation) {
  return internal::guarded(core.projected().plane(), operation);
}

}  // namespace apollonius::internal::sphere
