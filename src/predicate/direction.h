// Directions in doubles with error bounds, and turns between them: the filter of edge conflicts and
// the sector walk.
#pragma once

#include <algorithm>

#include "number/approx.h"
#include "number/fp.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// A vector with a bound on the error of each component; infinite if nothing is known.
struct Arrow {
  double x, y, error;
  [[nodiscard]] double size() const { return absolute(x) + absolute(y); }
};

/// Direction of a face's vertex from one of its sites, not normalised: the circle's centre less the
/// site's, or the half-plane's normal.
inline Arrow directionOf(const VoronoiCircle& circle, const Site& reference) {
  if (circle.isHalfPlane()) return {circle.x, circle.y, circle.slope};
  const double x = circle.x - reference.x, y = circle.y - reference.y;
  return {x, y, circle.error + kUnitRoundoff * std::max(absolute(x), absolute(y))};
}

/// Direction of a point from a site.
inline Arrow directionOf(double px, double py, const Site& reference) {
  const double x = px - reference.x, y = py - reference.y;
  return {x, y, kUnitRoundoff * std::max(absolute(x), absolute(y))};
}

/// Bounds the error of a sum of two products of components of a and b.
inline double productBound(const Arrow& a, const Arrow& b) {
  const double sa = a.size(), sb = b.size();
  return (a.error * sb + b.error * sa + 2 * a.error * b.error + 3 * kUnitRoundoff * sa * sb) *
         (1 + 16 * kUnitRoundoff);
}

/// Do the directions certainly differ by less than a quarter turn?
inline bool differByLessThanAQuarter(const Arrow& a, const Arrow& b) {
  const double bound = productBound(a, b);
  return bound > powerOfTwo(-900) && a.x * b.x + a.y * b.y > bound;
}

/// Is b to the left of a (positive) or to the right? Sign of a.x b.y - a.y b.x, whose error is at
/// most a.error |b| + b.error |a| + twice their product, and two roundings of each of the two
/// products.
inline MaybeSign turn(const Arrow& a, const Arrow& b) {
  const double value = a.x * b.y - a.y * b.x;
  const double bound = productBound(a, b);
  // Underflow is far below the bound where the arrows are not tiny; NaN ends as unknown.
  if (!(bound > powerOfTwo(-900))) return {};
  if (value > bound) return {Sign::kPositive, true};
  if (value < -bound) return {Sign::kNegative, true};
  return {};
}

}  // namespace apollonius::internal
