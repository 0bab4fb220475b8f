#include "diagram/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <utility>

namespace apollonius {

namespace {

constexpr unsigned kCurveBits = 16;  // cells a side: 2^16

/// Position of cell (x, y) along the Hilbert curve that fills the square of 2^kCurveBits cells a side.
std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0;
  for (std::uint32_t side = 1u << (kCurveBits - 1); side > 0; side >>= 1) {
    const std::uint32_t right = (x & side) != 0, upper = (y & side) != 0;
    position = position << 2 | ((3 * right) ^ upper);
    // The curve in the quarter is a reflected copy: in the lower quarters the axes are swapped, and in the right one of them turned
    // around as well. Written without branches, which would be taken at random.
    const std::uint32_t flip = 0u - (right & (upper ^ 1u));
    x ^= flip;
    y ^= flip;
    const std::uint32_t swapped = (x ^ y) & (0u - (upper ^ 1u));
    x ^= swapped;
    y ^= swapped;
  }
  return position;
}

/// A position on the curve, and which point is there.
struct Entry {
  std::uint32_t key;
  std::uint32_t point;
};

void fillEntries(PointArray points, std::span<Entry> entries) {
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
    entries[k] = {hilbertIndex(static_cast<std::uint32_t>(std::min(x, kLast)), static_cast<std::uint32_t>(std::min(y, kLast))),
                  static_cast<std::uint32_t>(k)};
  }
}

/// Sorts by key, stably: least significant digits first. Returns where they are then, in one of the arrays of equal size.
std::span<Entry> radixSorted(std::span<Entry> entries, std::span<Entry> other) {
  constexpr unsigned kDigitBits = 11, kDigits = 3;
  constexpr std::uint32_t kDigitMask = (1u << kDigitBits) - 1;
  std::vector<std::array<std::uint32_t, kDigits>> starts(std::size_t{1} << kDigitBits);
  const auto digit = [](std::uint32_t key, unsigned d) { return key >> (d * kDigitBits) & kDigitMask; };
  for (const Entry& entry : entries) {
    for (unsigned d = 0; d < kDigits; ++d) ++starts[digit(entry.key, d)][d];
  }
  std::array<std::uint32_t, kDigits> sum{};
  for (auto& start : starts) {
    for (unsigned d = 0; d < kDigits; ++d) {
      const std::uint32_t count = start[d];
      start[d] = sum[d];
      sum[d] += count;
    }
  }
  for (unsigned d = 0; d < kDigits; ++d) {
    for (const Entry& entry : entries) other[starts[digit(entry.key, d)][d]++] = entry;
    std::swap(entries, other);
  }
  return entries;
}

}  // namespace

std::vector<std::uint32_t> hilbertOrder(PointArray points) {
  const std::size_t n = points.size();
  // Only two thirds are used: see the header.
  constexpr std::size_t kBytesOfSite = 24;
  static_assert(kBytesOfSite == 3 * sizeof(Entry));
  const auto room = std::make_unique_for_overwrite<Entry[]>(3 * (n + 2));
  std::span<Entry> entries{room.get(), n};
  fillEntries(points, entries);
  constexpr std::size_t kFew = 512;  // a radix sort has 2^11 counters to sum up
  if (entries.size() > kFew) {
    entries = radixSorted(entries, {room.get() + n, n});
  } else {
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; });
  }
  std::vector<std::uint32_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[k] = entries[k].point;
  return order;
}

std::vector<std::uint32_t> inRandomizedRounds(std::span<const std::uint32_t> items) {
  const std::size_t n = items.size();
  // The round, counted from the last, is the number of leading zeros of a random word: 0 with probability 1/2, and so on.
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
  std::vector<std::uint32_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[start[roundOf(k)]++] = items[k];
  return order;
}

}  // namespace apollonius
