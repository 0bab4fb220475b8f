#include "api/checks.h"

#include <cmath>
#include <limits>

namespace apollonius::internal {

Error checkNumber(double value) {
  if (!std::isfinite(value)) return Error::kNotFinite;
  return isInRange(value) ? Error::kNone : Error::kOutOfRange;
}

Error checkNumbers(std::span<const double> values) {
  for (const double value : values) {
    if (const Error error = checkNumber(value); error != Error::kNone) return error;
  }
  return Error::kNone;
}

Error checkLimit(double maxDistance) {
  return maxDistance == std::numeric_limits<double>::infinity() ? Error::kNone
                                                                : checkNumber(maxDistance);
}

}  // namespace apollonius::internal
