// Rows of differences to a pole in each number type, and what turns a number into a sign: the parts by which the filter and
// the exact stage of one predicate differ. Everything else is one template.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>

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
