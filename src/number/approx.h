// Approx: a double with the size of the terms that it was computed from, for error-bound filters;
// Roundings, which counts the roundings of a formula at compile time; and the error factor that
// follows.
//
// Theorem (standard, e.g. Higham, Accuracy and Stability, chapter 3). Let a formula of + - * be
// evaluated in doubles without overflow or underflow. Expand it into its monomials; each carries
// one factor (1 + d), |d| <= u, for each rounding on its way to the root. If no monomial passes
// more than D roundings, then
//     |computed - exact| <= ((1+u)^D - 1) · M,
// where M is the same formula with every input replaced by its magnitude and every - by +.
// Roundings counts D: of a sum, the larger of its terms' and one more; of a product, those of its
// factors together and one more. M itself is computed in doubles and is at least (1-u)^D times its
// exact value, hence
//     |computed - exact| <= D u (1 + 2^-40) · (computed M)         for D < 1000.
// Underflow: with all inputs at most 2^33 in magnitude (kLargestInput) and formulas of degree at
// most 12, at most 2^8 products lose at most 2^-1075 each, which later factors enlarge by less than
// 2^370: kUnderflow covers the sum.
#pragma once

#include <algorithm>

#include "number/fp.h"
#include "number/sign.h"

namespace apollonius::internal {

/// How many roundings a monomial of a formula passes at most: the number that evaluating the
/// formula over Roundings gives.
struct Roundings {
  int count = 0;
  constexpr Roundings() = default;
  constexpr Roundings(int) {}  // NOLINT: an integer constant carries no error
  struct Input {};
  /// A difference of two doubles: one rounding.
  constexpr explicit Roundings(Input) : count(1) {}
  friend constexpr Roundings operator+(Roundings a, Roundings b) {
    return of(std::max(a.count, b.count) + 1);
  }
  friend constexpr Roundings operator-(Roundings a, Roundings b) { return a + b; }
  friend constexpr Roundings operator*(Roundings a, Roundings b) {
    return of(a.count + b.count + 1);
  }

 private:
  static constexpr Roundings of(int count) {
    Roundings sum;
    sum.count = count;
    return sum;
  }
};

struct Approx {
  double value = 0;
  double magnitude = 0;
  constexpr Approx() = default;
  constexpr Approx(int constant)  // NOLINT: constants in formulas
      : value(constant), magnitude(constant < 0 ? -constant : constant) {}
  constexpr explicit Approx(double input) : value(input), magnitude(absolute(input)) {}
  constexpr Approx(double v, double m) : value(v), magnitude(m) {}
  friend constexpr Approx operator+(Approx a, Approx b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
  }
  friend constexpr Approx operator-(Approx a, Approx b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
  }
  friend constexpr Approx operator*(Approx a, Approx b) {
    return {a.value * b.value, a.magnitude * b.magnitude};
  }
};

/// Largest magnitude of an input to an Approx formula; larger ones are scaled down by a power of
/// two first.
inline constexpr double kLargestInput = powerOfTwo(33);
/// Where kLargestInput is kept, underflow moves no formula by more than this.
inline constexpr double kUnderflow = powerOfTwo(-690);

/// Error factor of a formula with this many roundings: its error is at most this times the computed
/// magnitude (Higham's γ, with room for the roundings of the magnitude).
constexpr double errorFactor(Roundings roundings) {
  return roundings.count * kUnitRoundoff * (1 + powerOfTwo(-40));
}

/// The answer of a filter: a sign, or unknown. A sum of exact zeros is unknown and left to the
/// caller.
struct MaybeSign {
  Sign sign = Sign::kZero;
  bool known = false;
};

inline MaybeSign filteredSign(Approx x, double factor) {
  const double bound = factor * x.magnitude + kUnderflow;
  // Written so that infinities and NaNs end as unknown.
  if (x.value > bound) return {Sign::kPositive, true};
  if (x.value < -bound) return {Sign::kNegative, true};
  return {};
}

}  // namespace apollonius::internal
