// Orientation of three points with double coordinates, exact.
#pragma once

#include "number/sign.h"
#include "predicate/point.h"

namespace apollonius::internal {

/// Positive if a, b, c turn counter-clockwise: if c is to the left of the line from a to b. The
/// sign of (b - a) × (c - a).
[[nodiscard]] Sign orient2d(Point a, Point b, Point c);

/// Around a point, clockwise from the direction of `back`: does that of a come before that of b?
/// Exact.
[[nodiscard]] bool comesFirstClockwise(Point around, Point back, Point a, Point b);

}  // namespace apollonius::internal
