#include "api/checks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace apollonius::internal {

// This function and the constructor below stay out of line: inlined into their callers, they would
// add two kilobytes to the WebAssembly.
[[gnu::noinline]] Error takeNumber(double& value) {
  value = taken(value);
  if (!std::isfinite(value)) return Error::kNotFinite;
  return isInRange(value) ? Error::kNone : Error::kOutOfRange;
}

Error checkNumbers(std::span<const double> values) {
  for (double value : values) {
    if (const Error error = takeNumber(value); error != Error::kNone) return error;
  }
  return Error::kNone;
}

[[gnu::noinline]] TakenNumbers::TakenNumbers(std::span<const double> given) : numbers_(given) {
  // By their bits, as -0 equals 0.
  const auto isTaken = [](double value) {
    return std::bit_cast<std::uint64_t>(taken(value)) == std::bit_cast<std::uint64_t>(value);
  };
  if (std::all_of(given.begin(), given.end(), isTaken)) return;
  copy_.resize(given.size());
  std::transform(given.begin(), given.end(), copy_.begin(), taken);
  numbers_ = {copy_.data(), copy_.size()};
}

Error takeLimit(double& maxDistance) {
  return maxDistance == std::numeric_limits<double>::infinity() ? Error::kNone
                                                                : takeNumber(maxDistance);
}

}  // namespace apollonius::internal
