#include "diagram/spatial_order.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace apollonius {

namespace {

constexpr unsigned kCurveBits = 16;  // cells a side: 2^16

/// Position of cell (x, y) along the Hilbert curve that fills the square of 2^kCurveBits cells a side.
std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0;
  for (std::uint32_t side = 1u << (kCurveBits - 1); side > 0; side >>= 1) {
    const std::uint32_t right = (x & side) != 0, upper = (y & side) != 0;
    position = position << 2 | ((3 * right) ^ upper);
    // The curve in the quarter is a reflected copy: swap the axes in the lower quarters, and turn around in the right one.
    if (upper == 0) {
      if (right != 0) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return position;
}

/// Keys (round, position on the curve) in one word, the point's index beside it.
struct Entry {
  std::uint64_t key;
  std::uint32_t point;
};

std::vector<Entry> curveEntries(PointArray points) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double lowX = kInfinite, lowY = kInfinite, highX = -kInfinite, highY = -kInfinite;
  const std::size_t n = points.size();
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
  std::vector<Entry> entries(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = (points.values[k * points.stride] - lowX) * scale;
    const double y = (points.values[k * points.stride + 1] - lowY) * scale;
    entries[k] = {hilbertIndex(static_cast<std::uint32_t>(std::min(x, kLast)), static_cast<std::uint32_t>(std::min(y, kLast))),
                  static_cast<std::uint32_t>(k)};
  }
  return entries;
}

std::vector<std::uint32_t> sorted(std::vector<Entry>& entries) {
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; });
  std::vector<std::uint32_t> order(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) order[k] = entries[k].point;
  return order;
}

}  // namespace

std::vector<std::uint32_t> hilbertOrder(PointArray points) {
  std::vector<Entry> entries = curveEntries(points);
  return sorted(entries);
}

std::vector<std::uint32_t> insertionOrder(PointArray points) {
  std::vector<Entry> entries = curveEntries(points);
  // A point is in the last round with probability 1/2, in the one before with 1/4, and so on: leading zeros of a random word.
  for (Entry& entry : entries) {
    std::uint64_t z = (entry.point + 1ull) * 0x9E3779B97F4A7C15ull;  // splitmix64
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    const auto round = static_cast<std::uint64_t>(std::countl_zero(z ^ (z >> 31)));
    entry.key |= (64 - round) << 32;
  }
  return sorted(entries);
}

}  // namespace apollonius
