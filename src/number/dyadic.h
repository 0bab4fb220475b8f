// Dyadic: the one exact ring of the library. A number m * 2^e with an integer m of any length; every double is one, and
// + - * stay inside. Exponents are carried beside the integer, so that wide ranges of exponents cost no digits until two
// numbers of different exponents are added.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <utility>

#include "number/sign.h"

namespace apollonius {

class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(int value) : mantissa_(value) {}  // NOLINT: implicit on purpose, formulas contain small constants

  /// The exact value of a finite double.
  explicit Dyadic(double value);

  static Dyadic powerOfTwo(int exponent) { return Dyadic(Integer(1), exponent); }

  [[nodiscard]] Sign sign() const { return signOf(mantissa_.sign()); }

  /// About `mantissa * 2^exponent` with 2^62 <= |mantissa| <= 2^63 (or 0): a relative error of at most 2^-52.
  struct Rounded {
    double mantissa = 0;
    int exponent = 0;
  };
  [[nodiscard]] Rounded rounded() const;

  /// The leading bits, at least one: towards 0, with a relative error below 2^(1 - bits).
  [[nodiscard]] Dyadic truncated(unsigned bits) const;

  /// The root of a positive number from below, with a relative error of at most 2^-digits.
  [[nodiscard]] Dyadic root(unsigned digits) const;

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }

 private:
  // 512 bits are kept inline: the degree-8 predicates of inputs of similar size need no heap.
  using Integer = boost::multiprecision::number<
      boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                             std::allocator<boost::multiprecision::limb_type>>,
      boost::multiprecision::et_off>;

  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

inline Sign signOf(const Dyadic& x) { return x.sign(); }

}  // namespace apollonius
