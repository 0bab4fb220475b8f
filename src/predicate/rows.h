// Rows of differences to a pole in each number type, and what turns a number into a sign: the parts by which the filter and
// the exact stage of one predicate differ. Everything else is one template.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>

#include "number/approx.h"
#include "number/dyadic.h"
#include "number/fp.h"
#include "predicate/formulas.h"
#include "predicate/site.h"

namespace apollonius {

/// Power of two that brings differences of at most `largest` below kLargestInput without making any of them subnormal; 1 for
/// the magnitudes that people use.
inline double inputScale(double largest) {
  if (largest > powerOfTwo(-32) && largest < kLargestInput) return 1;
  if (!(largest > 0)) return 1;
  return powerOfTwo(std::clamp(-exponentOf(largest), -1000, 1000));
}

/// Filter stage: Approx rows, scaled; signs with error bounds. `failed` becomes true when a sign was not certain.
class FilterRows {
 public:
  using Number = Approx;

  FilterRows(const Site& pole, std::initializer_list<Corner> corners) {
    double largest = 0;
    std::size_t n = 0;
    for (Corner c : corners) {
      if (c != nullptr) differences_[n] = {c->x - pole.x, c->y - pole.y, c->r - pole.r, true};
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

  [[nodiscard]] Row<Approx> row(std::size_t k) const {
    const Difference& d = differences_[k];
    return d.finite ? rowOf(Approx(d.x), Approx(d.y), Approx(d.r)) : infinityRow<Approx>();
  }

  Sign sign(Approx x, Depth depth) {
    const MaybeSign s = filteredSign(x, boundFactor(depth));
    // A sum of nothing but zeros (equal weights, axis-parallel lines) is certainly zero, if no product was lost to underflow.
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

/// Middle stage: where the coordinates are small multiples of one power of two (grids, integers, quarters), doubles in that unit
/// compute exactly, and zeros are known to be zeros. If the magnitude of a formula (number/approx.h) is below 2^53 units, so is
/// everything that it was made of: every number on the way is an integer that a double holds, and no rounding happened.
class UnitRows {
 public:
  using Number = Approx;

  UnitRows(const Site& pole, std::initializer_list<Corner> corners) {
    int unit = std::numeric_limits<int>::max();
    const auto include = [&](const Site& s) {
      for (const double v : {s.x, s.y, s.r}) {
        if (v != 0) unit = std::min(unit, lowestExponentOf(v));
      }
    };
    include(pole);
    for (Corner c : corners) {
      if (c != nullptr) include(*c);
    }
    // Coordinates are normal numbers; in the unit they are integers, and up to 2^53 their differences are exact.
    failed_ = unit < -900 || unit > 900;
    const double scale = failed_ ? 1 : powerOfTwo(-unit);
    const auto difference = [&](double a, double b) {
      const double x = a * scale, y = b * scale;
      if (!(absolute(x) <= kLargestExact && absolute(y) <= kLargestExact)) failed_ = true;
      return Approx(x - y);
    };
    std::size_t n = 0;
    for (Corner c : corners) {
      rows_[n++] = c != nullptr ? rowOf(difference(c->x, pole.x), difference(c->y, pole.y), difference(c->r, pole.r))
                                : infinityRow<Approx>();
    }
  }

  [[nodiscard]] const Row<Approx>& row(std::size_t k) const { return rows_[k]; }
  Sign sign(Approx x, Depth) {
    if (!(x.magnitude < kLargestExact)) failed_ = true;
    return signOf(x.value);
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  static constexpr double kLargestExact = powerOfTwo(53);
  std::array<Row<Approx>, 4> rows_;
  bool failed_ = false;
};

/// Exact stage: the same rows and signs over Dyadic.
class ExactRows {
 public:
  using Number = Dyadic;

  ExactRows(const Site& pole, std::initializer_list<Corner> corners) {
    const Dyadic x(pole.x), y(pole.y), r(pole.r);
    std::size_t n = 0;
    for (Corner c : corners) {
      rows_[n++] = c != nullptr ? rowOf(Dyadic(c->x) - x, Dyadic(c->y) - y, Dyadic(c->r) - r) : infinityRow<Dyadic>();
    }
  }

  [[nodiscard]] const Row<Dyadic>& row(std::size_t k) const { return rows_[k]; }
  [[nodiscard]] static Sign sign(const Dyadic& x, Depth) { return x.sign(); }

 private:
  std::array<Row<Dyadic>, 4> rows_;
};

}  // namespace apollonius
