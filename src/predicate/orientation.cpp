#include "predicate/orientation.h"

#include "number/approx.h"
#include "number/dyadic.h"
#include "number/fp.h"
#include "predicate/shadow_check.h"

namespace apollonius::internal {

namespace {

/// Roundings of each product: two differences and itself; and that of the last difference. 2^-900
/// is for products that underflow.
MaybeSign filteredOrient2d(Point a, Point b, Point c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double turn = left - right, size = absolute(left) + absolute(right);
  if (absolute(turn) > 5 * kUnitRoundoff * size + powerOfTwo(-900)) return {signOf(turn), true};
  return {};
}

Sign exactOrient2d(Point a, Point b, Point c) {
  const auto difference = [](double p, double q) { return Dyadic(p) - Dyadic(q); };
  return (difference(b.x, a.x) * difference(c.y, a.y) - difference(b.y, a.y) * difference(c.x, a.x))
      .sign();
}

}  // namespace

Sign orient2d(Point a, Point b, Point c) {
  const MaybeSign filtered = filteredOrient2d(a, b, c);
  const auto exact = [&] { return exactOrient2d(a, b, c); };
  shadowCheck(filtered, exact);
  return filtered.known ? filtered.sign : exact();
}

bool comesFirstClockwise(Point around, Point back, Point a, Point b) {
  const bool isRightA = orient2d(around, back, a) != Sign::kPositive,
             isRightB = orient2d(around, back, b) != Sign::kPositive;
  if (isRightA != isRightB) return isRightA;
  return orient2d(around, a, b) == Sign::kNegative;
}

}  // namespace apollonius::internal
