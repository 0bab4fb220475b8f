// The squared length of the outer common tangent of two circles, between the points where it
// touches them.
#pragma once

#include "predicate/site.h"

namespace apollonius::internal {

/// p = |a - b|² - (ra - rb)², with a small relative error also where it is small. Positive exactly
/// if neither circle covers the other, unless numbers underflow.
[[nodiscard]] double squaredTangent(const Site& a, const Site& b);

}  // namespace apollonius::internal
