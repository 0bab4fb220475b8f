#include "number/fixed_integer.h"

#include "number/fp.h"

namespace apollonius::internal {

FixedInteger FixedInteger::inUnits(double value, int unit) {
  FixedInteger result;
  if (value == 0) return result;
  auto [digits, exponent] = decompose(value);
  int shift = exponent - unit;
  if (shift < 0) {  // the digits shifted out are zeros
    digits >>= -shift;
    shift = 0;
  }
  const int skipped = shift / 32, within = shift % 32;
  std::fill_n(result.limbs_, skipped, 0u);
  const std::uint64_t low = digits << within;
  result.limbs_[skipped] = static_cast<std::uint32_t>(low);
  result.limbs_[skipped + 1] = static_cast<std::uint32_t>(low >> 32);
  result.limbs_[skipped + 2] =
      within != 0 ? static_cast<std::uint32_t>(digits >> (64 - within)) : 0;
  result.size_ = skipped + 3;
  result.isNegative_ = value < 0;
  result.dropZeros();
  return result;
}

FixedInteger operator*(const FixedInteger& a, const FixedInteger& b) {
  FixedInteger product;
  if (a.size_ == 0 || b.size_ == 0) return product;
  product.size_ = a.size_ + b.size_;
  product.isNegative_ = a.isNegative_ != b.isNegative_;
  std::fill_n(product.limbs_, product.size_, 0u);
  for (int i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    const std::uint64_t factor = a.limbs_[i];
    for (int j = 0; j < b.size_; ++j) {
      carry += factor * b.limbs_[j] + product.limbs_[i + j];
      product.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    product.limbs_[i + b.size_] = static_cast<std::uint32_t>(carry);
  }
  product.dropZeros();
  return product;
}

FixedInteger FixedInteger::sum(const FixedInteger& a, const FixedInteger& b, bool bIsNegative) {
  if (a.isNegative_ == bIsNegative || a.size_ == 0 || b.size_ == 0) {
    FixedInteger result = a.size_ >= b.size_ ? added(a, b) : added(b, a);
    result.isNegative_ = a.size_ == 0 ? bIsNegative : a.isNegative_;
    return result;
  }
  const bool aIsLarger = compareMagnitudes(a, b) >= 0;
  FixedInteger result = aIsLarger ? subtracted(a, b) : subtracted(b, a);
  result.isNegative_ = aIsLarger ? a.isNegative_ : bIsNegative;
  return result;
}

/// |a| + |b|. REQUIRES: a has at least as many limbs.
FixedInteger FixedInteger::added(const FixedInteger& a, const FixedInteger& b) {
  FixedInteger result;
  std::uint64_t carry = 0;
  for (int k = 0; k < a.size_; ++k) {
    carry += std::uint64_t{a.limbs_[k]} + (k < b.size_ ? b.limbs_[k] : 0);
    result.limbs_[k] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  result.limbs_[a.size_] = static_cast<std::uint32_t>(carry);
  result.size_ = a.size_ + (carry != 0);
  return result;
}

/// |a| - |b|. REQUIRES: |a| >= |b|.
FixedInteger FixedInteger::subtracted(const FixedInteger& a, const FixedInteger& b) {
  FixedInteger result;
  std::int64_t borrow = 0;
  for (int k = 0; k < a.size_; ++k) {
    borrow += std::int64_t{a.limbs_[k]} - (k < b.size_ ? std::int64_t{b.limbs_[k]} : 0);
    result.limbs_[k] = static_cast<std::uint32_t>(borrow);
    borrow >>= 32;
  }
  result.size_ = a.size_;
  result.dropZeros();
  return result;
}

int FixedInteger::compareMagnitudes(const FixedInteger& a, const FixedInteger& b) {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (int k = a.size_; k-- > 0;) {
    if (a.limbs_[k] != b.limbs_[k]) return a.limbs_[k] < b.limbs_[k] ? -1 : 1;
  }
  return 0;
}

}  // namespace apollonius::internal
