// Kernels: the parts in which the stages of one predicate differ. A kernel holds the rows of
// differences to a reference site in one kind of number, and turns a number into a sign; everything
// else is one template in the predicate's file. Here are the kernels in doubles, and `decide`;
// those in longer numbers are in long_kernels.h. Each has
//     Number               type of its numbers
//     row(k)               the k-th corner
//     hasEqualWeights()    have all finite sites the same weight?
//     sign(x, roundings)   sign of a formula's value; `roundings` are the formula's
//     failed()             was a sign uncertain, or are these sites beyond this kernel?
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>

#include "number/approx.h"
#include "number/fp.h"
#include "predicate/formulas.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// Power of two that brings differences of at most `largest` below kLargestInput without making any
/// of them subnormal; 1 for the magnitudes that people use.
inline double inputScale(double largest) {
  if (largest > powerOfTwo(-32) && largest < kLargestInput) return 1;
  if (!(largest > 0)) return 1;
  return powerOfTwo(std::clamp(-exponentOf(largest), -1000, 1000));
}

/// Filter stage: doubles with error bounds, scaled.
class FilterKernel {
 public:
  using Number = Approx;

  FilterKernel(const Site& reference, std::initializer_list<Corner> corners) {
    double largest = 0;
    std::size_t n = 0;
    for (Corner c : corners) {
      if (c != nullptr)
        differences_[n] = {c->x - reference.x, c->y - reference.y, c->r - reference.r, true};
      const Difference& d = differences_[n++];
      largest = std::max({largest, absolute(d.x), absolute(d.y), absolute(d.r)});
    }
    const double scale = inputScale(largest);
    if (scale != 1) {
      for (std::size_t k = 0; k < n; ++k) {
        differences_[k].x *= scale;
        differences_[k].y *= scale;
        differences_[k].r *= scale;
      }
    }
  }

  /// A difference of two doubles is zero only if they are equal, rounded or not.
  [[nodiscard]] bool hasEqualWeights() const {
    return std::all_of(differences_.begin(), differences_.end(),
                       [](const Difference& d) { return d.r == 0; });
  }
  [[nodiscard]] Row<Approx> row(std::size_t k) const {
    const Difference& d = differences_[k];
    return d.finite ? rowOf(Approx(d.x), Approx(d.y), Approx(d.r)) : infinityRow<Approx>();
  }

  Sign sign(Approx x, Roundings roundings) {
    const MaybeSign s = filteredSign(x, errorFactor(roundings));
    // A sum of nothing but zeros (equal weights, axis-parallel lines) is certainly zero, if no
    // product was lost to underflow.
    if (!s.known && !(x.magnitude == 0 && productsSurvive())) failed_ = true;
    return s.sign;
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  struct Difference {
    double x = 0, y = 0, r = 0;
    bool finite = false;
  };

  /// Inputs of at least 2^-85: products of twelve are normal numbers.
  [[nodiscard]] bool productsSurvive() const {
    const auto fits = [](double x) { return x == 0 || absolute(x) >= powerOfTwo(-85); };
    return std::all_of(differences_.begin(), differences_.end(),
                       [&](const Difference& d) { return fits(d.x) && fits(d.y) && fits(d.r); });
  }

  std::array<Difference, 4> differences_{};
  bool failed_ = false;
};

/// REQUIRES: exact rows.
template <class T>
bool haveEqualWeights(const std::array<Row<T>, 4>& rows) {
  return std::all_of(rows.begin(), rows.end(),
                     [](const Row<T>& row) { return signOf(row.r) == Sign::kZero; });
}

/// The digits of numbers: exponents of the lowest one and of the highest one.
struct Range {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
  void include(double v) {
    if (v == 0) return;
    lowest = std::min(lowest, lowestExponentOf(v));
    highest = std::max(highest, exponentOf(v));
  }
  void include(const Site& s) {
    include(s.x);
    include(s.y);
    include(s.r);
  }
};

/// The differences of some sites to a reference site in doubles, whether all of them are exact (of
/// sites close together they are as a rule), and if so, their digits.
struct Differences {
  struct Triple {
    double x = 0, y = 0, r = 0;
    bool isFinite = false;
  };
  std::array<Triple, 4> triples;
  std::size_t count = 0;
  bool areExact = true;
  int unit = 0, highest = 0;

  Differences(const Site& reference, std::initializer_list<Corner> corners) {
    Range range;
    const auto difference = [&](double a, double b) {
      const double d = a - b;
      // The rounding error of a difference is a double (Knuth's TwoSum).
      const double back = a - d;
      areExact &= (a - (d + back)) + (back - b) == 0;
      range.include(d);
      return d;
    };
    for (Corner c : corners) {
      if (c != nullptr)
        triples[count] = {difference(c->x, reference.x), difference(c->y, reference.y),
                          difference(c->r, reference.r), true};
      ++count;
    }
    unit = range.lowest == std::numeric_limits<int>::max() ? 0 : range.lowest;
    highest = range.lowest == std::numeric_limits<int>::max() ? 0 : range.highest;
  }
};

/// A double that is known to be exact or not. `magnitude` is that of the value, or, if inexact, at
/// least 2^53 and a bound on the magnitudes of all operands.
struct ExactDouble {
  double value = 0;
  double magnitude = 0;
  constexpr ExactDouble() = default;
  constexpr ExactDouble(int constant)  // NOLINT: constants in formulas
      : value(constant), magnitude(absolute(value)) {}
  /// An integer.
  constexpr explicit ExactDouble(double integer) : ExactDouble(integer, absolute(integer)) {}
  friend constexpr ExactDouble operator+(ExactDouble a, ExactDouble b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
  }
  friend constexpr ExactDouble operator-(ExactDouble a, ExactDouble b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
  }
  friend constexpr ExactDouble operator*(ExactDouble a, ExactDouble b) {
    return {a.value * b.value, a.magnitude * b.magnitude};
  }

  static constexpr double kLargest = powerOfTwo(53);
  [[nodiscard]] constexpr bool isExact() const { return magnitude < kLargest; }
  friend constexpr Sign signOf(ExactDouble x) { return signOf(x.value); }

 private:
  /// Exact integers whose sum or product is below 2^53 in magnitude: no rounding happened. Zero
  /// times anything is zero.
  constexpr ExactDouble(double v, double m) : value(v), magnitude(m < kLargest ? absolute(v) : m) {}
};

/// First middle stage: if the coordinates are small multiples of one power of two (grids, integers,
/// quarters), doubles in that unit compute exactly, and zeros are known to be zeros.
class UnitKernel {
 public:
  using Number = ExactDouble;

  UnitKernel(const Site& reference, std::initializer_list<Corner> corners) {
    const Differences differences(reference, corners);
    // Normal numbers in the unit are integers.
    failed_ = !differences.areExact || differences.unit < -900 || differences.unit > 900;
    if (failed_) return;
    const double scale = powerOfTwo(-differences.unit);
    const auto in = [&](double d) { return ExactDouble(d * scale); };
    for (std::size_t k = 0; k < differences.count; ++k) {
      const Differences::Triple& d = differences.triples[k];
      rows_[k] = d.isFinite ? rowOf(in(d.x), in(d.y), in(d.r)) : infinityRow<ExactDouble>();
    }
  }

  [[nodiscard]] bool hasEqualWeights() const { return haveEqualWeights(rows_); }
  [[nodiscard]] const Row<ExactDouble>& row(std::size_t k) const { return rows_[k]; }
  Sign sign(ExactDouble x, Roundings) {
    if (!x.isExact()) failed_ = true;
    return signOf(x);
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  std::array<Row<ExactDouble>, 4> rows_;
  bool failed_ = false;
};

/// The answer of a stage: `decision` takes the signs that it needs from the kernel of the reference
/// site and the corners.
template <class Kernel, class Decision>
MaybeSign decide(const Site& reference, std::initializer_list<Corner> corners,
                 const Decision& decision) {
  Kernel kernel(reference, corners);
  if (kernel.failed()) return {};
  const Sign sign = decision(kernel);
  return {sign, !kernel.failed()};
}

}  // namespace apollonius::internal
