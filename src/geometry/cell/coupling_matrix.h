// How the areas of cells depend on the weights, to first order: a sparse symmetric matrix, with
// division by its triangles.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"

namespace apollonius::internal {

/// A pair of cells: if the weight of one grows, it gains this times the growth from the other.
struct Coupling {
  std::uint32_t i, j;
  double derivative;  ///< > 0
};

/// The matrix with the entries -derivative beside the diagonal, in which each row's sum is 0; then
/// row and column k are multiplied by scale(k), so that the diagonal is 1: I + L + U, L below it
/// and U above. Several couplings of the same two cells add up.
class CouplingMatrix {
 public:
  CouplingMatrix(std::size_t count, std::span<const Coupling> couplings);

  [[nodiscard]] double scale(std::size_t k) const { return scale_[k]; }
  /// values := (I + L)^-1 values
  void divideByLower(std::span<double> values) const;
  /// values := (I + U)^-1 values
  void divideByUpper(std::span<double> values) const;
  /// rest := rest - (I + L + U) values
  void subtractProduct(std::span<const double> values, std::span<double> rest) const;

 private:
  struct Entry {
    std::uint32_t column;
    double value;
  };
  /// Row k of L.
  [[nodiscard]] std::span<const Entry> row(std::size_t k) const {
    return std::span(entries_).subspan(starts_[k], starts_[k + 1] - starts_[k]);
  }

  FlatArray<double> scale_;
  FlatArray<std::uint32_t> starts_;  // by row, of entries_
  FlatArray<Entry> entries_;
};

}  // namespace apollonius::internal
