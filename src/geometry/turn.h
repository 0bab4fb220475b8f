// Exact orientation of three points with double coordinates.
#pragma once

#include "geometry/point.h"
#include "number/sign.h"

namespace apollonius::internal {

/// Positive if a, b is a turn to the left as seen from `from`: the sign of (a - from) × (b - from).
/// Exact.
[[nodiscard]] Sign turnOf(Point from, Point a, Point b);

/// Around a point, clockwise from the direction of `back`: does that of a come before that of b?
/// Exact.
[[nodiscard]] bool comesFirstClockwise(Point around, Point back, Point a, Point b);

}  // namespace apollonius::internal
