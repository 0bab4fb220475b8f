// Orders for bulk operations: along a Hilbert curve, so that consecutive points are close together,
// and in randomised rounds of doubling size, each along the curve (biased randomised insertion
// order, Amenta, Choi and Rote), so that the expected cost stays that of a random order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "delaunay/sort_by_key.h"
#include "memory/flat_array.h"

namespace apollonius::internal {

/// Points as a strided array: x at [k * stride], y at [k * stride + 1].
struct PointArray {
  std::span<const double> values;
  std::size_t stride;
  [[nodiscard]] std::size_t size() const { return values.size() / stride; }
};

/// Sorts points along a Hilbert curve over their bounding box, in steps; equal points in the order
/// of the input. The same on every platform. Cost: O(n), a radix sort. Takes 24 bytes a point for
/// its time: as much as a site, so that an array of sites that is made afterwards fits where that
/// was. The points must stay where they are. Throws std::bad_alloc when it is made, and in order().
class HilbertSort {
 public:
  explicit HilbertSort(PointArray points);

  /// Goes on by at most so many points, of which each is visited some times; are they sorted?
  bool advance(std::size_t most);
  /// Indices of the points along the curve. REQUIRES: sorted.
  [[nodiscard]] FlatArray<std::uint32_t> order() const;

 private:
  /// What is done with the points from at_ on.
  enum class Phase : std::uint8_t { kBounding, kPlacing, kSorting };

  void bound(std::size_t end);
  void place(std::size_t end);

  PointArray points_;
  std::unique_ptr<Keyed[]> room_;
  std::span<Keyed> entries_;
  KeySort sort_;
  Phase phase_ = Phase::kBounding;
  std::size_t at_ = 0;
  double lowX_, lowY_, highX_, highY_;
};

/// The order that a HilbertSort gives.
[[nodiscard]] FlatArray<std::uint32_t> hilbertOrder(PointArray points);

/// The items in randomised rounds, each in the order in which they are given: about half of them in
/// the last round, a quarter in the one before, and so on. Seeded: the same on every platform.
[[nodiscard]] FlatArray<std::uint32_t> brioOrder(std::span<const std::uint32_t> items);

}  // namespace apollonius::internal
