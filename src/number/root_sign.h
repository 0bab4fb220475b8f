// Signs of numbers with square roots, by squaring: exact over any ordered ring. No root is ever
// taken.
#pragma once

#include "number/sign.h"

namespace apollonius::internal {

/// Sign of s + t where s and t are known by their signs and `squares` gives sign(s² - t²).
/// Used lazily: the squares are only formed when s and t pull in opposite directions.
template <class SquareDifferenceSign>
Sign signOfSum(Sign s, Sign t, SquareDifferenceSign&& squares) {
  if (s == t || t == Sign::kZero) return s;
  if (s == Sign::kZero) return t;
  return s * squares();
}

/// sign(a + b √c). REQUIRES c >= 0.
template <class Ring>
Sign signOfRoot(const Ring& a, const Ring& b, const Ring& c) {
  return signOfSum(signOf(a), signOf(b) * signOf(c), [&] { return signOf(a * a - b * b * c); });
}

/// sign(a + √c - √e). REQUIRES c, e >= 0.
template <class Ring>
Sign signOfRootDifference(const Ring& a, const Ring& c, const Ring& e) {
  return signOfSum(signOfRoot(a, Ring(1), c), -signOf(e), [&] {
    return signOfRoot(a * a + c - e, a + a, c);  // (a + √c)² - e
  });
}

}  // namespace apollonius::internal
