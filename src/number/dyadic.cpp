#include "number/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace apollonius {

Dyadic::Dyadic(double value) {
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

Dyadic::Rounded Dyadic::rounded() const {
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

Dyadic Dyadic::truncated(unsigned bits) const {
  if (mantissa_.is_zero()) return {};
  const int excess = static_cast<int>(boost::multiprecision::msb(boost::multiprecision::abs(mantissa_))) + 1 - static_cast<int>(bits);
  if (excess <= 0) return *this;
  Integer digits = boost::multiprecision::abs(mantissa_);
  digits >>= static_cast<unsigned>(excess);
  if (mantissa_.sign() < 0) digits.backend().negate();
  return Dyadic(std::move(digits), exponent_ + excess);
}

// Newton's iteration for 1/√x, which needs no division: long division and what Boost's sqrt is made of would be a tenth of the wasm
// module, for this one use.
//
// An inverse with relative error 2^-k becomes one with 1.5 * 2^-2k, and truncating to b bits adds at most 1.5 * 2^(1-b): with
// b = 2k + 4 together below 2^-(2k-1). From an error below 2^-(digits+3), and two truncations to digits + 8 bits, the product x/√x
// is off by less than 2^-(digits+2); lowered by 2^-(digits+1) it is below the root, and by less than 2^-digits.
Dyadic Dyadic::root(unsigned digits) const {
  Rounded start = rounded();
  if (start.exponent % 2 != 0) start = {2 * start.mantissa, start.exponent - 1};
  Dyadic inverse = Dyadic(1 / std::sqrt(start.mantissa)) * powerOfTwo(-start.exponent / 2);
  for (unsigned known = 48; known < digits + 3; known = 2 * known - 1) {
    const unsigned bits = std::min(2 * known + 4, digits + 10);
    const Dyadic rest = Dyadic(1) - truncated(bits) * (inverse * inverse);
    inverse = (inverse + inverse * rest * powerOfTwo(-1)).truncated(bits);
  }
  const Dyadic near = (truncated(digits + 8) * inverse).truncated(digits + 8);
  return near - near * powerOfTwo(-static_cast<int>(digits) - 1);
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  return Dyadic(a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_);
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.mantissa_.is_zero()) return b;
  if (b.mantissa_.is_zero()) return a;
  if (a.exponent_ < b.exponent_) return b + a;
  Dyadic::Integer aligned = a.mantissa_;
  aligned <<= static_cast<unsigned>(a.exponent_ - b.exponent_);
  aligned += b.mantissa_;
  return Dyadic(std::move(aligned), b.exponent_);
}

Dyadic operator-(const Dyadic& a) { return Dyadic(-a.mantissa_, a.exponent_); }

}  // namespace apollonius
