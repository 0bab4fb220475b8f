#include "geometry/turn.h"

#include "number/dyadic.h"
#include "number/fp.h"

namespace apollonius::internal {

Sign turnOf(Point from, Point a, Point b) {
  const double left = (a.x - from.x) * (b.y - from.y), right = (a.y - from.y) * (b.x - from.x);
  const double turn = left - right, size = absolute(left) + absolute(right);
  // Roundings of each product: two differences and itself; and that of the last difference. 2^-900
  // is for products that underflow.
  if (absolute(turn) > 5 * kUnitRoundoff * size + powerOfTwo(-900)) return signOf(turn);
  const auto difference = [](double p, double q) { return Dyadic(p) - Dyadic(q); };
  return (difference(a.x, from.x) * difference(b.y, from.y) -
          difference(a.y, from.y) * difference(b.x, from.x))
      .sign();
}

bool comesFirstClockwise(Point around, Point back, Point a, Point b) {
  const bool isRightA = turnOf(around, back, a) != Sign::kPositive,
             isRightB = turnOf(around, back, b) != Sign::kPositive;
  if (isRightA != isRightB) return isRightA;
  return turnOf(around, a, b) == Sign::kNegative;
}

}  // namespace apollonius::internal
