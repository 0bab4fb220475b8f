// FixedInteger: integers of up to 1500 bits that are kept in place, for the second middle stage. No
// heap, no exponents, and only the limbs in use are copied and multiplied, which makes it several
// times as fast as Dyadic on the coordinates that people have. The same operations on 32-bit limbs
// everywhere: WebAssembly multiplies 32 x 32 bits in one instruction, 64 x 64 in a call.
#pragma once

#include <algorithm>
#include <cstdint>

#include "number/sign.h"

namespace apollonius::internal {

class FixedInteger {
 public:
  /// Bits of an input: formulas of degree 12 with up to 2^8 terms stay within the limbs.
  static constexpr int kInputBits = 120;

  FixedInteger() = default;
  FixedInteger(int value)  // NOLINT: implicit on purpose, formulas contain small constants
      : limbs_{static_cast<std::uint32_t>(value < 0 ? -value : value)},
        size_(value != 0),
        isNegative_(value < 0) {}
  FixedInteger(const FixedInteger& other) : size_(other.size_), isNegative_(other.isNegative_) {
    std::copy_n(other.limbs_, size_, limbs_);
  }
  FixedInteger& operator=(const FixedInteger& other) {
    if (this == &other) return *this;
    size_ = other.size_;
    isNegative_ = other.isNegative_;
    std::copy_n(other.limbs_, size_, limbs_);
    return *this;
  }

  /// value / 2^unit. REQUIRES: an integer, of less than kInputBits bits.
  static FixedInteger inUnits(double value, int unit);

  [[nodiscard]] Sign sign() const {
    return size_ == 0 ? Sign::kZero : isNegative_ ? Sign::kNegative : Sign::kPositive;
  }

  // Not inline: copied into each formula, products and sums would be most of the WebAssembly
  // module.
  friend FixedInteger operator*(const FixedInteger& a, const FixedInteger& b);
  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    return sum(a, b, b.isNegative_);
  }
  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) {
    return sum(a, b, !b.isNegative_);
  }

 private:
  static constexpr int kLimbs = 50;
  static_assert(12 * kInputBits + 8 <= 32 * (kLimbs - 4));

  /// a + b, with the sign of b given.
  static FixedInteger sum(const FixedInteger& a, const FixedInteger& b, bool bIsNegative);
  static FixedInteger added(const FixedInteger& a, const FixedInteger& b);
  static FixedInteger subtracted(const FixedInteger& a, const FixedInteger& b);
  static int compareMagnitudes(const FixedInteger& a, const FixedInteger& b);
  void dropZeros() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
  }

  std::uint32_t limbs_[kLimbs];  // least significant first; only the first size_ mean something
  int size_ = 0;
  bool isNegative_ = false;  // arbitrary for zero
};

inline Sign signOf(const FixedInteger& x) { return x.sign(); }

}  // namespace apollonius::internal
