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

  static Dyadic powerOfTwo(int exponent) { return Dyadic(Integer(1), exponent); }

  [[nodiscard]] Sign sign() const { return signOf(mantissa_.sign()); }

  /// About `mantissa * 2^exponent` with 2^62 <= |mantissa| <= 2^63 (or 0): a relative error of at most 2^-52.
  struct Rounded {
    double mantissa = 0;
    int exponent = 0;
  };
  [[nodiscard]] Rounded rounded() const {
    if (mantissa_.is_zero()) return {};
    Integer digits = boost::multiprecision::abs(mantissa_);
    const int excess = static_cast<int>(boost::multiprecision::msb(digits)) - 62;
    if (excess > 0) {
      digits >>= static_cast<unsigned>(excess);
    } else {
      digits <<= static_cast<unsigned>(-excess);
    }
    const auto magnitude = static_cast<double>(static_cast<std::uint64_t>(digits));
    return {mantissa_.sign() < 0 ? -magnitude : magnitude, exponent_ + excess};
  }

  /// The root of a positive number from below, with a relative error of at most 2^-digits.
  [[nodiscard]] Dyadic root(unsigned digits) const {
    Integer m = mantissa_;
    int e = exponent_;
    const unsigned wanted = 2 * digits + 2, present = static_cast<unsigned>(boost::multiprecision::msb(m));
    unsigned shift = wanted > present ? wanted - present : 0;
    if (((e - static_cast<int>(shift)) & 1) != 0) ++shift;
    m <<= shift;
    e -= static_cast<int>(shift);
    return Dyadic(Integer(boost::multiprecision::sqrt(m)), e / 2);
  }

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
