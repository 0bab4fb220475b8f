// What every call of the public interface does before and after its work: checks numbers, and
// translates lack of memory into an error.
#pragma once

#include <cmath>
#include <limits>
#include <new>
#include <span>
#include <stdexcept>

#include "apollonius/diagram.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

inline Error checkNumber(double value) {
  if (!std::isfinite(value)) return Error::kNotFinite;
  return isInRange(value) ? Error::kNone : Error::kOutOfRange;
}

inline Error checkNumbers(std::span<const double> values) {
  for (const double value : values) {
    if (const Error error = checkNumber(value); error != Error::kNone) return error;
  }
  return Error::kNone;
}

inline Error checkNumbers(double x, double y) {
  const Error error = checkNumber(x);
  return error != Error::kNone ? error : checkNumber(y);
}

/// Of a distance beyond which nothing is looked for; infinite if there is none.
inline Error checkLimit(double maxDistance) {
  return maxDistance == std::numeric_limits<double>::infinity() ? Error::kNone
                                                                : checkNumber(maxDistance);
}

/// Memory that runs out throws std::bad_alloc, or from a vector std::length_error. std::bad_alloc
/// also ends a call that finds out that trusted bytes were no diagram, which the diagram remembers.
template <class Operation>
Error guarded(const DiagramCore& core, Operation&& operation) {
  if (core.isBroken()) return Error::kCorruptSnapshot;
  try {
    operation();
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return core.isBroken() ? Error::kCorruptSnapshot : Error::kOutOfMemory;
  } catch (const std::length_error&) {
    return Error::kOutOfMemory;
  }
}

}  // namespace apollonius::internal
