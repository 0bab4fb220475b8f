// Dyadic: the one exact ring of the library. A number m * 2^e with an integer m of any length; every double is one, and
// + - * stay inside. Exponents are carried beside the integer, so that wide ranges of exponents cost no digits until two
// numbers of different exponents are added.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <utility>

#include "number/fp.h"
#include "number/sign.h"

namespace apollonius {

class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(int value) : mantissa_(value) {}  // NOLINT: implicit on purpose, formulas contain small constants

  /// The exact value of a finite double.
  explicit Dyadic(double value) {
    if (value == 0) return;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>((bits >> 52) & 0x7FF);
    std::uint64_t digits = bits & ((std::uint64_t{1} << 52) - 1);
    if (biased != 0) digits |= std::uint64_t{1} << 52;
    const int zeros = std::countr_zero(digits);  // short integers for round inputs (grids, small integers)
    exponent_ = (biased != 0 ? biased : 1) - 1075 + zeros;
    mantissa_ = digits >> zeros;
    if (value < 0) mantissa_.backend().negate();
  }

  [[nodiscard]] Sign sign() const { return signOf(mantissa_.sign()); }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return Dyadic(a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_);
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.mantissa_.is_zero()) return b;
    if (b.mantissa_.is_zero()) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    Integer aligned = a.mantissa_;
    aligned <<= static_cast<unsigned>(a.exponent_ - b.exponent_);
    aligned += b.mantissa_;
    return Dyadic(std::move(aligned), b.exponent_);
  }
  friend Dyadic operator-(const Dyadic& a) { return Dyadic(-a.mantissa_, a.exponent_); }
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
