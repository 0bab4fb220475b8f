#include "diagram/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>

#include "delaunay/sort_by_key.h"
#include "memory/flat_array.h"

namespace apollonius::internal {

namespace {

constexpr unsigned kCurveBits = 16;  // cells a side: 2^16

/// Position of cell (x, y) along the Hilbert curve that fills the square of 2^kCurveBits cells a
/// side.
std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0;
  for (std::uint32_t side = 1u << (kCurveBits - 1); side > 0; side >>= 1) {
    const std::uint32_t right = (x & side) != 0, upper = (y & side) != 0;
    position = position << 2 | ((3 * right) ^ upper);
    // The curve in the quarter is a reflected copy: in the lower quarters the axes are swapped, and
    // in the right one of them turned around as well. Written without branches, which would be
    // taken at random.
    const std::uint32_t flip = 0u - (right & (upper ^ 1u));
    x ^= flip;
    y ^= flip;
    const std::uint32_t swapped = (x ^ y) & (0u - (upper ^ 1u));
    x ^= swapped;
    y ^= swapped;
  }
  return position;
}

/// Writes the position on the curve of each point.
void fillEntries(PointArray points, std::span<Keyed> entries) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double lowX = kInfinite, lowY = kInfinite, highX = -kInfinite, highY = -kInfinite;
  const std::size_t n = entries.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double x = points.values[k * points.stride], y = points.values[k * points.stride + 1];
    lowX = std::min(lowX, x);
    highX = std::max(highX, x);
    lowY = std::min(lowY, y);
    highY = std::max(highY, y);
  }
  const double extent = std::max(highX - lowX, highY - lowY);
  const double scale = extent > 0 ? (std::uint32_t{1} << kCurveBits) / extent : 0;
  constexpr double kLast = (std::uint32_t{1} << kCurveBits) - 1;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = (points.values[k * points.stride] - lowX) * scale;
    const double y = (points.values[k * points.stride + 1] - lowY) * scale;
    entries[k] = {hilbertIndex(static_cast<std::uint32_t>(std::min(x, kLast)),
                               static_cast<std::uint32_t>(std::min(y, kLast))),
                  static_cast<std::uint32_t>(k)};
  }
}

}  // namespace

FlatArray<std::uint32_t> hilbertOrder(PointArray points) {
  const std::size_t n = points.size();
  // Only two thirds are used: see the header.
  constexpr std::size_t kBytesOfSite = 24;
  static_assert(kBytesOfSite == 3 * sizeof(Keyed));
  const auto room = std::make_unique_for_overwrite<Keyed[]>(3 * (n + 2));
  std::span<Keyed> entries{room.get(), n};
  fillEntries(points, entries);
  entries = sortByKey(entries, {room.get() + n, n});
  FlatArray<std::uint32_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[k] = entries[k].value;
  return order;
}

FlatArray<std::uint32_t> brioOrder(std::span<const std::uint32_t> items) {
  const std::size_t n = items.size();
  // The round, counted from the last, is the number of leading zeros of a random word: 0 with
  // probability 1/2, and so on.
  constexpr std::size_t kRounds = 65;
  const auto roundOf = [](std::size_t k) {
    std::uint64_t z = (k + 1ull) * 0x9E3779B97F4A7C15ull;  // splitmix64
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<std::size_t>(std::countl_zero(z ^ (z >> 31)));
  };
  std::array<std::size_t, kRounds> start{};
  for (std::size_t k = 0; k < n; ++k) ++start[roundOf(k)];
  std::size_t sum = 0;
  for (std::size_t round = kRounds; round-- > 0;) {
    const std::size_t count = start[round];
    start[round] = sum;
    sum += count;
  }
  FlatArray<std::uint32_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[start[roundOf(k)]++] = items[k];
  return order;
}

}  // namespace apollonius::internal
