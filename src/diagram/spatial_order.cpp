#include "diagram/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>

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

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Only two thirds are used: see the header.
constexpr std::size_t kBytesOfSite = 24;
static_assert(kBytesOfSite == 3 * sizeof(Keyed));

}  // namespace

HilbertSort::HilbertSort(PointArray points)
    : points_(points),
      room_(std::make_unique_for_overwrite<Keyed[]>(3 * (points.size() + 2))),
      entries_(room_.get(), points.size()),
      sort_(entries_, {room_.get() + points.size(), points.size()}),
      lowX_(kInfinite),
      lowY_(kInfinite),
      highX_(-kInfinite),
      highY_(-kInfinite) {}

void HilbertSort::bound(std::size_t end) {
  double lowX = lowX_, lowY = lowY_, highX = highX_, highY = highY_;
  for (std::size_t k = at_; k < end; ++k) {
    const double x = points_.values[k * points_.stride], y = points_.values[k * points_.stride + 1];
    lowX = std::min(lowX, x);
    highX = std::max(highX, x);
    lowY = std::min(lowY, y);
    highY = std::max(highY, y);
  }
  lowX_ = lowX, lowY_ = lowY, highX_ = highX, highY_ = highY;
}

/// Writes the position on the curve of each point.
void HilbertSort::place(std::size_t end) {
  const double lowX = lowX_, lowY = lowY_;
  const double extent = std::max(highX_ - lowX, highY_ - lowY);
  const double scale = extent > 0 ? (std::uint32_t{1} << kCurveBits) / extent : 0;
  constexpr double kLast = (std::uint32_t{1} << kCurveBits) - 1;
  for (std::size_t k = at_; k < end; ++k) {
    const double x = (points_.values[k * points_.stride] - lowX) * scale;
    const double y = (points_.values[k * points_.stride + 1] - lowY) * scale;
    entries_[k] = {hilbertIndex(static_cast<std::uint32_t>(std::min(x, kLast)),
                                static_cast<std::uint32_t>(std::min(y, kLast))),
                   static_cast<std::uint32_t>(k)};
  }
}

bool HilbertSort::advance(std::size_t most) {
  if (phase_ == Phase::kSorting) return sort_.advance(most);
  const std::size_t end = at_ + std::min(most, entries_.size() - at_);
  if (phase_ == Phase::kBounding) {
    bound(end);
  } else {
    place(end);
  }
  at_ = end;
  if (at_ == entries_.size()) {
    phase_ = phase_ == Phase::kBounding ? Phase::kPlacing : Phase::kSorting;
    at_ = 0;
  }
  return false;
}

FlatArray<std::uint32_t> HilbertSort::order() const {
  const std::span<const Keyed> sorted = sort_.sorted();
  FlatArray<std::uint32_t> order(sorted.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = sorted[k].value;
  return order;
}

FlatArray<std::uint32_t> hilbertOrder(PointArray points) {
  HilbertSort sort(points);
  while (!sort.advance(points.size())) {
  }
  return sort.order();
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
