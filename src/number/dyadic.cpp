#include "number/dyadic.h"

#include <bit>
#include <cstdint>
#include <limits>

#include "number/fp.h"
#include "number/invariant.h"

namespace apollonius::internal {

namespace {
/// 64 where the compiler has integers of 128 bits.
constexpr int kLimb = std::numeric_limits<boost::multiprecision::limb_type>::digits;
}  // namespace

// None of these is inline: the code that clears the memory of an Integer would be everywhere.

Dyadic::Dyadic() noexcept = default;

Dyadic::Dyadic(int value) : mantissa_(value) {}

Dyadic::Dyadic(const Dyadic& other) noexcept { *this = other; }

Dyadic& Dyadic::operator=(const Dyadic& other) noexcept {
  mantissa_.backend().assign(other.mantissa_.backend());
  exponent_ = other.exponent_;
  return *this;
}

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  const auto [digits, exponent] = decompose(value);
  // Short integers for round inputs (grids, small integers).
  const int zeros = std::countr_zero(digits);
  exponent_ = exponent + zeros;
  mantissa_ = digits >> zeros;
  if (value < 0) mantissa_.backend().negate();
}

Dyadic::Rounded Dyadic::rounded() const {
  if (mantissa_.is_zero()) return {};
  const auto& digits = mantissa_.backend();
  const int zeros = std::countl_zero(digits.limbs()[digits.size() - 1]);
  std::uint64_t leading = 0;
  int room = 64;
  for (std::size_t k = digits.size(), bits = kLimb - zeros; k > 0 && room > 0; bits = kLimb) {
    const std::uint64_t limb = digits.limbs()[--k];
    const int shift = room - static_cast<int>(bits);
    leading |= shift >= 0 ? limb << shift : limb >> -shift;
    room = shift;
  }
  const auto magnitude = static_cast<double>(leading >> 1);
  return {digits.sign() ? -magnitude : magnitude,
          exponent_ + static_cast<int>(digits.size()) * kLimb - zeros - 63};
}

// Results are computed where they are kept: an Integer is 1.5 KB, and making one costs some 20 ns
// whatever it holds.

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  const auto &left = a.mantissa_.backend(), &right = b.mantissa_.backend();
  invariant((left.size() + right.size()) * kLimb <= Dyadic::kBits, "an exact product is too long");
  Dyadic product;
  eval_multiply(product.mantissa_.backend(), left, right);
  product.exponent_ = a.exponent_ + b.exponent_;
  return product;
}

/// a + b, or a - b.
Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool isDifference) {
  if (b.mantissa_.is_zero()) return a;
  if (a.mantissa_.is_zero()) return isDifference ? -b : b;
  const bool aIsFirst = a.exponent_ >= b.exponent_;
  const Dyadic &first = aIsFirst ? a : b, &second = aIsFirst ? b : a;  // by exponent
  const auto distance = static_cast<unsigned>(first.exponent_ - second.exponent_);
  Dyadic sum;
  auto& digits = sum.mantissa_.backend();
  invariant(first.mantissa_.backend().size() * kLimb + distance < kBits,
            "an exact sum is too long");
  digits.assign(first.mantissa_.backend());
  eval_left_shift(digits, distance);
  if (isDifference) {
    eval_subtract(digits, second.mantissa_.backend());
    if (!aIsFirst) digits.negate();
  } else {
    eval_add(digits, second.mantissa_.backend());
  }
  sum.exponent_ = second.exponent_;
  return sum;
}

Dyadic operator-(const Dyadic& a) {
  Dyadic negative = a;
  negative.mantissa_.backend().negate();
  return negative;
}

double Dyadic::Rounded::value() const {
  double value = mantissa;
  int rest = exponent;
  for (; rest > 1000; rest -= 1000) value *= powerOfTwo(1000);
  for (; rest < -1000; rest += 1000) value *= powerOfTwo(-1000);
  return value * powerOfTwo(rest);
}

}  // namespace apollonius::internal
