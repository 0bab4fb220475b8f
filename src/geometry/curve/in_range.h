// Coordinates that rounding has left outside of the documented range.
#pragma once

#include "apollonius/types.h"
#include "number/fp.h"

namespace apollonius::internal {

/// Those too small for the range become 0.
inline double inRange(double x) { return absolute(x) < kSmallestMagnitude ? 0 : x; }

}  // namespace apollonius::internal
