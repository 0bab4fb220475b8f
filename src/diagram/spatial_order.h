// Orders for bulk operations: along a Hilbert curve, so that consecutive points are close together,
// and in randomised rounds of doubling size, each along the curve (biased randomised insertion
// order, Amenta, Choi and Rote), so that the expected cost stays that of a random order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "memory/flat_array.h"

namespace apollonius::internal {

/// Points as a strided array: x at [k * stride], y at [k * stride + 1].
struct PointArray {
  std::span<const double> values;
  std::size_t stride;
  [[nodiscard]] std::size_t size() const { return values.size() / stride; }
};

/// Indices of the points along a Hilbert curve over their bounding box; equal points in the order
/// of the input. The same on every platform. Cost: O(n), a radix sort. Takes 24 bytes a point for a
/// while: as much as a site, so that an array of sites that is made afterwards fits where that was.
[[nodiscard]] FlatArray<std::uint32_t> hilbertOrder(PointArray points);

/// The items in randomised rounds, each in the order in which they are given: about half of them in
/// the last round, a quarter in the one before, and so on. Seeded: the same on every platform.
[[nodiscard]] FlatArray<std::uint32_t> brioOrder(std::span<const std::uint32_t> items);

}  // namespace apollonius::internal
