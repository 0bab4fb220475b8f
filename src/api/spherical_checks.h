// What the calls of SphericalDiagram do before and after their work, as checks.h has it for the
// plane.
#pragma once

#include <cmath>

#include "api/checks.h"
#include "apollonius/spherical_diagram.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

inline Error checkPoint(double lon, double lat) {
  if (!std::isfinite(lon) || !std::isfinite(lat)) return Error::kNotFinite;
  return lat >= -90 && lat <= 90 ? Error::kNone : Error::kOutOfRange;
}

/// Lack of memory becomes an error.
template <class Operation>
Error guarded(const SphericalCore& core, Operation&& operation) {
  return internal::guarded(core.projected().plane(), operation);
}

}  // namespace apollonius::internal::sphere
