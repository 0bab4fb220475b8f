// Dyadic: the exact numbers of the library, m * 2^e with an integer m. Every double is one, and + -
// * yield such numbers. Exponents are stored beside the integer, so that wide ranges of exponents
// cost no digits until two numbers of different exponents are added.
//
// The integer has memory of a fixed size, so that nothing here can run out of memory. That size is
// enough: coordinates and weights, 0 or from 1e-100 to 1e100, are multiples of 2^-385
// below 2^333, their differences below 2^334; so a form of degree d with t terms is a multiple of
// 2^(-385 d) below 2^(334 d) t, and its integer has at most 719 d + log2(t) bits, as have those of
// its parts. The predicates' forms have degree 12 at most; the highest degree is 16, with fewer
// than 2^20 terms (squares in preciseVoronoiCircle; commonVoronoiCircle checks the digits first):
// 11 524 bits. An integer longer than kBits breaks an invariant.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <utility>

#include "number/sign.h"

namespace apollonius::internal {

class Dyadic {
 public:
  Dyadic() noexcept;
  Dyadic(int value);  // NOLINT: implicit on purpose, formulas contain small constants

  /// The exact value of a finite double.
  explicit Dyadic(double value);

  // Copies only the memory in use.
  Dyadic(const Dyadic& other) noexcept;
  Dyadic& operator=(const Dyadic& other) noexcept;

  [[nodiscard]] Sign sign() const { return signOf(mantissa_.sign()); }

  /// About `mantissa * 2^exponent` with 2^62 <= |mantissa| <= 2^63 (or 0): a relative error of at
  /// most (1 + 2^-9) 2^-53.
  struct Rounded {
    double mantissa = 0;
    int exponent = 0;
    /// Infinite or 0 where that is beyond doubles.
    [[nodiscard]] double value() const;
  };
  [[nodiscard]] Rounded rounded() const;

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, false); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, true); }
  friend Dyadic operator-(const Dyadic& a);

 private:
  static constexpr unsigned kBits = 192 * 64;
  using Integer = boost::multiprecision::number<
      boost::multiprecision::cpp_int_backend<kBits, kBits, boost::multiprecision::signed_magnitude,
                                             boost::multiprecision::unchecked, void>,
      boost::multiprecision::et_off>;

  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool isDifference);

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

inline Sign signOf(const Dyadic& x) { return x.sign(); }

}  // namespace apollonius::internal
