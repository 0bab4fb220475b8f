// Signs of numbers with square roots, by squaring: exact over any ordered ring. No root is ever
// taken.
#pragma once

#include "number/sign.h"

namespace apollonius {

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

/// sign(a + b √c + d √e + f √(c e)). REQUIRES c, e >= 0.
/// It is P + Q √e with P = a + b √c and Q = d + f √c, and P² - e Q² has one root only.
template <class Ring>
Sign signOfTwoRoots(const Ring& a, const Ring& b, const Ring& c, const Ring& d, const Ring& e,
                    const Ring& f) {
  const Sign p = signOfRoot(a, b, c);
  const Sign q = signOfRoot(d, f, c) * signOf(e);
  return signOfSum(p, q, [&] {
    return signOfRoot(a * a + b * b * c - e * (d * d + f * f * c),
                      (a * b - e * d * f) + (a * b - e * d * f), c);
  });
}

}  // namespace apollonius
