#include "geometry/cell/coupling_matrix.h"

#include <algorithm>
#include <cmath>

namespace apollonius::internal {

CouplingMatrix::CouplingMatrix(std::size_t count, std::span<const Coupling> couplings)
    : scale_(count, 0), starts_(count + 1, 0) {
  for (const auto& [i, j, derivative] : couplings) {
    scale_[i] += derivative;
    scale_[j] += derivative;
    ++starts_[std::max(i, j) + std::size_t{1}];
  }
  for (std::size_t k = 0; k < count; ++k) {
    scale_[k] = scale_[k] > 0 ? 1 / std::sqrt(scale_[k]) : 1;
    starts_[k + 1] += starts_[k];
  }
  entries_.resize(couplings.size());
  FlatArray<std::uint32_t> ends(starts_);
  for (const auto& [i, j, derivative] : couplings)
    entries_[ends[std::max(i, j)]++] = {std::min(i, j), -derivative * scale_[i] * scale_[j]};
}

void CouplingMatrix::divideByLower(std::span<double> values) const {
  for (std::size_t k = 0; k < values.size(); ++k) {
    double value = values[k];
    for (const Entry& entry : row(k)) value -= entry.value * values[entry.column];
    values[k] = value;
  }
}

void CouplingMatrix::divideByUpper(std::span<double> values) const {
  for (std::size_t k = values.size(); k-- > 0;) {
    for (const Entry& entry : row(k)) values[entry.column] -= entry.value * values[k];
  }
}

void CouplingMatrix::subtractProduct(std::span<const double> values, std::span<double> rest) const {
  for (std::size_t k = 0; k < values.size(); ++k) {
    rest[k] -= values[k];
    for (const Entry& entry : row(k)) {
      rest[k] -= entry.value * values[entry.column];
      rest[entry.column] -= entry.value * values[k];
    }
  }
}

}  // namespace apollonius::internal
