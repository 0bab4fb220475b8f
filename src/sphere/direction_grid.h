// Hints for starts of searches on the sphere: a grid of the directions that remembers in each cell
// a site that was seen there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/flat_array.h"
#include "diagram/id_pool.h"
#include "sphere/cap.h"

namespace apollonius::internal::sphere {

/// The faces of a cube about the sphere, each divided into equal squares. Its slots are hints: a
/// slot may be free by now, or that of a site elsewhere.
class DirectionGrid {
 public:
  /// Forgets all hints and makes about one cell per site. Throws std::bad_alloc.
  void reset(std::size_t sites) {
    side_ = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(sites) / 6)));
    slots_.assign(std::size_t{6} * side_ * side_, kNoSlot);
  }
  /// Gives each cell without a site that of the nearest cell before it that has one, or else
  /// behind.
  void fill() {
    Slot seen = kNoSlot;
    const auto pass = [&](Slot& slot) { seen = slot == kNoSlot ? slot = seen : slot; };
    for (Slot& slot : slots_) pass(slot);
    for (std::size_t k = slots_.size(); k-- > 0;) pass(slots_[k]);
  }
  void set(const Direction& direction, Slot slot) {
    if (side_ > 0) slots_[cellOf(direction)] = slot;
  }
  /// The slot seen in the cell of a direction; kNoSlot if no site has been seen there.
  [[nodiscard]] Slot at(const Direction& direction) const {
    return side_ == 0 ? kNoSlot : slots_[cellOf(direction)];
  }

  /// The cell of a direction; 0 if there are no cells.
  [[nodiscard]] std::uint32_t cellOf(const Direction& d) const {
    if (side_ == 0) return 0;
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    if (x >= y && x >= z) return cellAt(d.x > 0 ? 0 : 1, d.y / x, d.z / x);
    if (y >= z) return cellAt(d.y > 0 ? 2 : 3, d.x / y, d.z / y);
    return cellAt(d.z > 0 ? 4 : 5, d.x / z, d.y / z);
  }

 private:
  /// The cell of a point (u, v) in [-1, 1] x [-1, 1] of a face.
  [[nodiscard]] std::uint32_t cellAt(std::uint32_t face, double u, double v) const {
    const auto index = [&](double t) {
      return std::min(static_cast<std::uint32_t>((t + 1) / 2 * side_), side_ - 1);
    };
    const std::uint32_t column = index(v), row = face * side_ + index(u);
    // Rows run to and fro, so that the next cell is an adjacent one.
    return row * side_ + (row % 2 == 0 ? column : side_ - 1 - column);
  }

  std::uint32_t side_ = 0;
  FlatArray<Slot> slots_;
};

}  // namespace apollonius::internal::sphere
