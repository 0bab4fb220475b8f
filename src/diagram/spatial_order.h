// Orders for bulk operations: along a Hilbert curve, so that consecutive points are close together, and in randomised rounds of
// doubling size, each along the curve (biased randomised insertion order, Amenta, Choi and Rote), so that the expected cost
// stays that of a random order.
#pragma once

#include <cstddef>
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

/// The position of something in a list, and the key to sort it by.
struct KeyedPosition {
  std::uint32_t key, position;
};

/// Sorts by key; equal keys stay in the order of their positions. REQUIRES: positions that rise. Cost: O(n), a radix sort.
void sortByKey(std::vector<KeyedPosition>& entries);

/// Indices of the points along a Hilbert curve over their bounding box; equal points in the order of the input. The same on every
/// platform. Cost: O(n).
[[nodiscard]] std::vector<std::uint32_t> hilbertOrder(PointArray points);

/// Writes the numbers 0 … n-1 to the array of n in randomised rounds, rising in each: about half of them in the last round, a quarter in the one before, and
/// so on. Seeded: the same on every platform.
void randomizedRounds(std::span<std::uint32_t> order) noexcept;

}  // namespace apollonius
