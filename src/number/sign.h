// A sign: the only thing that a predicate passes on from the numbers to the topology.
#pragma once

namespace apollonius::internal {

enum class Sign : signed char { kNegative = -1, kZero = 0, kPositive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

/// Sign of a built-in number; a NaN gives kZero, so callers that may meet one must have excluded
/// it.
template <class Number>
constexpr Sign signOf(Number x) {
  return x > 0 ? Sign::kPositive : x < 0 ? Sign::kNegative : Sign::kZero;
}

}  // namespace apollonius::internal
