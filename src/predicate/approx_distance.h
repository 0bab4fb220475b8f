// The distance of a point to a site in doubles, with a bound on its error: the filter of all
// nearest-site searches.
#pragma once

#include <cmath>

#include "number/fp.h"
#include "predicate/site.h"

namespace apollonius {

/// |value - (|p - c| - r)| <= bound, for p = (x, y) and the site within the documented range.
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

}  // namespace apollonius
