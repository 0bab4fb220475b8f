// Which of two sites is nearer to a point?
#pragma once

#include <cmath>

#include "number/approx.h"
#include "number/fp.h"
#include "number/sign.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// sign(d(p, a) - d(p, b)) for the point p = (x, y) and d(p, s) = |p - c_s| - r_s. Law:
/// antisymmetric in a, b. Degree 4.
[[nodiscard]] Sign compareDistance(double x, double y, const Site& a, const Site& b);

/// Is b nearer to (x, y) than a, where a tie goes to the larger site in the order of precedes()?
/// Irreflexive and transitive.
[[nodiscard]] bool isNearer(double x, double y, const Site& a, const Site& b);

/// Is a site farther from (x, y) than a limit, which may be infinite?
[[nodiscard]] bool isBeyond(double x, double y, const Site& site, double limit);

/// The distance from a point to a site in doubles: the filter of all searches for the nearest site,
/// which store it. |value - (|p - c| - r)| <= bound, for p = (x, y) and the site within the
/// documented range.
///
/// Derivation, u the unit roundoff: the differences carry one factor (1+d) each, their squares
/// three, the sum four, its root half of that and one more: 3u relative. Subtracting r adds u
/// |value|. Together at most 4u (|p - c| + |r|) to first order; 5u covers the rest. Differences are
/// 0 or at least 1e-116, so nothing underflows.
struct ApproxDistance {
  double value;
  double bound;

  ApproxDistance(double x, double y, const Site& s) {
    const double dx = s.x - x;
    const double dy = s.y - y;
    const double length = std::sqrt(dx * dx + dy * dy);
    value = length - s.r;
    bound = 5 * kUnitRoundoff * (length + absolute(s.r));
  }
};

/// |p - c| - r for p = (x, y), with an error of less than one unit in the last place: of the right
/// sign, and 0 on the circle only. For results; takes a tenth of the time of a search.
[[nodiscard]] double roundedDistance(double x, double y, const Site& s);

namespace stages {

/// compareDistance from two ApproxDistances; in doubles that are exact (sites of equal weights
/// only); in integers of fixed width; exactly.
[[nodiscard]] MaybeSign distanceFilter(double x, double y, const Site& a, const Site& b);
[[nodiscard]] MaybeSign distanceMiddle(double x, double y, const Site& a, const Site& b);
[[nodiscard]] MaybeSign distanceFixed(double x, double y, const Site& a, const Site& b);
[[nodiscard]] Sign distanceExact(double x, double y, const Site& a, const Site& b);

}  // namespace stages

}  // namespace apollonius::internal
