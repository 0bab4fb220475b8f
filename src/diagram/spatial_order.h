// Orders for bulk operations: along a Hilbert curve, so that consecutive points are close together, and in randomised rounds of
// doubling size, each along the curve (biased randomised insertion order, Amenta, Choi and Rote), so that the expected cost
// stays that of a random order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace apollonius {

/// Points as a strided array: x at [k * stride], y at [k * stride + 1].
struct PointArray {
  std::span<const double> values;
  std::size_t stride;
  [[nodiscard]] std::size_t size() const { return values.size() / stride; }
};

/// Indices of the points along a Hilbert curve over their bounding box. The same on every platform.
[[nodiscard]] std::vector<std::uint32_t> hilbertOrder(PointArray points);

/// Indices of the points in randomised rounds, each along a Hilbert curve. Seeded: the same on every platform.
[[nodiscard]] std::vector<std::uint32_t> insertionOrder(PointArray points);

}  // namespace apollonius
