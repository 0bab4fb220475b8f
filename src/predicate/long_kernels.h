// The kernels (kernels.h) in long numbers: the second middle stage and the exact one.
#pragma once

#include <array>
#include <initializer_list>

#include "number/dyadic.h"
#include "number/fixed_integer.h"
#include "predicate/kernels.h"

namespace apollonius::internal {

/// Second middle stage, for longer inputs (decimal fractions, integers of many digits): integers of
/// fixed width in the common unit. Fails only where the coordinates range over more than 2^117
/// units.
class FixedKernel {
 public:
  using Number = FixedInteger;

  FixedKernel(const Site& reference, std::initializer_list<Corner> corners) {
    const Differences differences(reference, corners);
    if (differences.areExact) {
      if (!fits(differences.unit, differences.highest)) return;
      const auto in = [&](double d) { return FixedInteger::inUnits(d, differences.unit); };
      for (std::size_t k = 0; k < differences.count; ++k) {
        const Differences::Triple& d = differences.triples[k];
        rows_[k] = d.isFinite ? rowOf(in(d.x), in(d.y), in(d.r)) : infinityRow<FixedInteger>();
      }
      return;
    }
    Range range;
    range.include(reference);
    for (Corner c : corners) {
      if (c != nullptr) range.include(*c);
    }
    if (!fits(range.lowest, range.highest)) return;
    const auto in = [&](double v) { return FixedInteger::inUnits(v, range.lowest); };
    const FixedInteger x = in(reference.x), y = in(reference.y), r = in(reference.r);
    std::size_t n = 0;
    for (Corner c : corners) {
      rows_[n++] = c != nullptr ? rowOf(in(c->x) - x, in(c->y) - y, in(c->r) - r)
                                : infinityRow<FixedInteger>();
    }
  }

  [[nodiscard]] bool hasEqualWeights() const { return haveEqualWeights(rows_); }
  [[nodiscard]] const Row<FixedInteger>& row(std::size_t k) const { return rows_[k]; }
  [[nodiscard]] static Sign sign(const FixedInteger& x, Roundings) { return x.sign(); }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  bool fits(int lowest, int highest) {
    failed_ = highest >= lowest && highest - lowest > FixedInteger::kInputBits - 3;
    return !failed_;
  }

  std::array<Row<FixedInteger>, 4> rows_;
  bool failed_ = false;
};

/// Exact stage: numbers as long as any input can ask for.
class ExactKernel {
 public:
  using Number = Dyadic;

  ExactKernel(const Site& reference, std::initializer_list<Corner> corners) {
    const Dyadic x(reference.x), y(reference.y), r(reference.r);
    std::size_t n = 0;
    for (Corner c : corners) {
      rows_[n++] = c != nullptr ? rowOf(Dyadic(c->x) - x, Dyadic(c->y) - y, Dyadic(c->r) - r)
                                : infinityRow<Dyadic>();
    }
  }

  [[nodiscard]] bool hasEqualWeights() const { return haveEqualWeights(rows_); }
  [[nodiscard]] const Row<Dyadic>& row(std::size_t k) const { return rows_[k]; }
  [[nodiscard]] static Sign sign(const Dyadic& x, Roundings) { return x.sign(); }
  [[nodiscard]] static bool failed() { return false; }

 private:
  std::array<Row<Dyadic>, 4> rows_;
};

}  // namespace apollonius::internal
