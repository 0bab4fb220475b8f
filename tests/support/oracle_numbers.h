// The oracle's own exact numbers: doubles as integers over a common power of two, and signs of a +
// b*sqrt(d). Deliberately separate from src/number.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>

namespace apollonius::test {

/// Unlimited integers; those of up to 768 bits need no heap.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<768, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked>,
    boost::multiprecision::et_off>;

inline int signOf(const Integer& value) { return value.sign(); }

/// Sign of a + b*sqrt(d), d >= 0.
inline int signOf(const Integer& a, const Integer& b, const Integer& d) {
  const int signA = signOf(a);
  const int signB = signOf(d) == 0 ? 0 : signOf(b);
  if (signA == signB || signB == 0) return signA;
  if (signA == 0) return signB;
  return signA * signOf(Integer(a * a - b * b * d));
}

/// Sign of sqrt(a) - sqrt(b) - c, a, b >= 0.
inline int signOfRootDifference(const Integer& a, const Integer& b, const Integer& c) {
  // Compare sqrt(a) with sqrt(b) + c: first the sign of the latter, then the squares a and b + c^2
  // + 2c*sqrt(b).
  if (signOf(c, Integer(1), b) < 0) return 1;
  return signOf(Integer(a - b - c * c), Integer(-2 * c), b);
}

/// The exponent e of the lowest bit of a double (value = odd * 2^e); a large number for 0.
inline int lowestBit(double value) {
  if (value == 0) return 1 << 20;
  int exponent = 0;
  double mantissa = std::frexp(value, &exponent) * 0x1p53;
  exponent -= 53;
  while (mantissa == 2 * std::floor(mantissa / 2)) {
    mantissa /= 2;
    ++exponent;
  }
  return exponent;
}

inline int lowestBit(std::initializer_list<double> values) {
  int lowest = 1 << 20;
  for (const double value : values) lowest = std::min(lowest, lowestBit(value));
  return lowest;
}

/// value / 2^unit as an integer; unit must not exceed lowestBit(value).
inline Integer scaled(double value, int unit) {
  if (value == 0) return 0;
  const int exponent = lowestBit(value);
  Integer integer = static_cast<long long>(std::ldexp(value, -exponent));
  integer <<= static_cast<unsigned>(exponent - unit);
  return integer;
}

}  // namespace apollonius::test
