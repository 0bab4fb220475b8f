#include "diagram/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>
#include <memory>

#include "base/flat_array.h"
#include "base/infinite.h"

namespace apollonius::internal {

namespace {

constexpr unsigned kCurveBits = 16;  // cells a side: 2^16

// How the curve lies in a square: as it is, or with the axes swapped, or turned around, or both.
constexpr unsigned kSwapped = 1, kTurned = 2, kWays = 4;

/// How many bits of each coordinate are looked up at once: with more, the table would be a kilobyte
/// of the wasm module.
constexpr unsigned kStepBits = 2, kStepCells = 1u << kStepBits;

constexpr unsigned stepOf(unsigned way, unsigned x, unsigned y) {
  return (way << kStepBits | x) << kStepBits | y;
}

/// For a way, and a cell of the kStepCells x kStepCells in a square: the position of the cell along
/// the curve in that square, times kWays, and the way of the curve in the cell.
constexpr auto kSteps = [] {
  std::array<std::uint8_t, std::size_t{kWays} * kStepCells * kStepCells> steps{};
  for (unsigned first = 0; first < kWays; ++first) {
    for (unsigned x = 0; x < kStepCells; ++x) {
      for (unsigned y = 0; y < kStepCells; ++y) {
        unsigned position = 0, way = first;
        for (unsigned bit = kStepBits; bit-- > 0;) {
          const unsigned turn = way / kTurned;
          const unsigned a = (x >> bit & 1) ^ turn, b = (y >> bit & 1) ^ turn;
          const bool isSwapped = (way & kSwapped) != 0;
          const unsigned right = isSwapped ? b : a, upper = isSwapped ? a : b;
          position = position << 2 | ((3 * right) ^ upper);
          // The curve in the quarter is a reflected copy: in the lower quarters the axes are
          // swapped, and in the right one of them turned around as well.
          if (upper == 0) way ^= right != 0 ? kSwapped | kTurned : kSwapped;
        }
        steps[stepOf(first, x, y)] = static_cast<std::uint8_t>(position * kWays + way);
      }
    }
  }
  return steps;
}();

/// Position of cell (x, y) along the Hilbert curve that fills the square of 2^kCurveBits cells a
/// side.
std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0, way = 0;
  for (unsigned shift = kCurveBits; shift > 0;) {
    shift -= kStepBits;
    const unsigned step =
        kSteps[stepOf(way, x >> shift & (kStepCells - 1), y >> shift & (kStepCells - 1))];
    position = position << (2 * kStepBits) | step / kWays;
    way = step % kWays;
  }
  return position;
}

// Points of a cell whose order is left as it is: a walk among them has a step or two.
constexpr std::size_t kFewPoints = 4;

// Only two thirds are used: see the header.
constexpr std::size_t kBytesOfSite = 24;
static_assert(kBytesOfSite == 3 * sizeof(Keyed));

}  // namespace

HilbertSort::HilbertSort(PointArray points)
    : points_(points),
      room_(std::make_unique_for_overwrite<Keyed[]>(3 * (points.size() + 2))),
      entries_(room_.get(), points.size()),
      other_(room_.get() + points.size(), points.size()) {
  ends_[0] = points.size();
  beginCell();
}

void HilbertSort::beginCell() {
  at_ = begin_;
  box_ = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  phase_ = Phase::kBounding;
}

void HilbertSort::bound(std::size_t end) {
  Box box = box_;
  for (; at_ < end; ++at_) {
    const double* const point = &points_.values[pointOf(at_) * points_.stride];
    box.lowX = std::min(box.lowX, point[0]);
    box.highX = std::max(box.highX, point[0]);
    box.lowY = std::min(box.lowY, point[1]);
    box.highY = std::max(box.highY, point[1]);
  }
  box_ = box;
}

/// Writes the index on the curve of each point.
void HilbertSort::indexPoints(std::size_t end) {
  const Box box = box_;
  const double extent = std::max(box.highX - box.lowX, box.highY - box.lowY);
  const double scale = extent > 0 ? (std::uint32_t{1} << kCurveBits) / extent : 0;
  constexpr double kLast = (std::uint32_t{1} << kCurveBits) - 1;
  for (; at_ < end; ++at_) {
    const std::size_t k = pointOf(at_);
    const double* const point = &points_.values[k * points_.stride];
    const double x = (point[0] - box.lowX) * scale, y = (point[1] - box.lowY) * scale;
    entries_[at_] = {hilbertIndex(static_cast<std::uint32_t>(std::min(x, kLast)),
                                  static_cast<std::uint32_t>(std::min(y, kLast))),
                     static_cast<std::uint32_t>(k)};
  }
}

/// The sort may have left the entries in the other array. Those of a cell are copied back; for
/// those of all points the arrays change their names.
void HilbertSort::endSorting() {
  const std::span<const Keyed> sorted = sort_->sorted();
  if (!sorted.empty() && sorted.data() != &entries_[begin_]) {
    if (level_ == 0) {
      std::swap(entries_, other_);
    } else {
      std::copy(sorted.begin(), sorted.end(), &entries_[begin_]);
    }
  }
  sort_.reset();
  at_ = begin_;
  phase_ = Phase::kLooking;
}

/// Looks for the next cell with many points, from begin_, where a cell begins, on; at_ is in that
/// cell or behind it. Cells are visited depth first.
void HilbertSort::look(std::size_t most) {
  for (std::size_t k = 0; k < most; ++k) {
    while (begin_ == ends_[level_]) {
      if (level_ == 0) {
        phase_ = Phase::kSorted;
        return;
      }
      --level_;
    }
    if (at_ < ends_[level_] && entries_[at_].key == entries_[begin_].key) {
      ++at_;
      continue;
    }
    if (at_ - begin_ > kFewPoints) {
      assert(level_ + 1 < kMostLevels);
      ends_[++level_] = at_;
      beginCell();
      return;
    }
    begin_ = at_;
  }
}

bool HilbertSort::advance(std::size_t most) {
  const std::size_t end = ends_[level_];
  switch (phase_) {
    case Phase::kBounding:
      bound(at_ + std::min(most, end - at_));
      if (at_ < end) break;
      if (level_ > 0 && box_.lowX == box_.highX && box_.lowY == box_.highY) {
        begin_ = end;  // all points are equal
        phase_ = Phase::kLooking;
        break;
      }
      at_ = begin_;
      phase_ = Phase::kIndexing;
      break;
    case Phase::kIndexing:
      indexPoints(at_ + std::min(most, end - at_));
      if (at_ < end) break;
      sort_.emplace(entries_.subspan(begin_, end - begin_), other_.subspan(begin_, end - begin_));
      phase_ = Phase::kSorting;
      break;
    case Phase::kSorting:
      if (sort_->advance(most)) endSorting();
      break;
    case Phase::kLooking:
      look(most);
      break;
    case Phase::kSorted:
      break;
  }
  return phase_ == Phase::kSorted;
}

FlatArray<std::uint32_t> HilbertSort::order() const {
  FlatArray<std::uint32_t> order(entries_.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = entries_[k].value;
  return order;
}

FlatArray<std::uint32_t> hilbertOrder(PointArray points) {
  HilbertSort sort(points);
  while (!sort.advance(std::numeric_limits<std::size_t>::max())) {
  }
  return sort.order();
}

FlatArray<std::uint32_t> brioOrder(std::span<const std::uint32_t> items) {
  const std::size_t n = items.size();
  // The round, counted from the last, is the number of leading zeros of a random word: 0 with
  // probability 1/2, and so on; for many sites a third of it, so 7/8 are in the last round. Then
  // holes are a little larger (4.1 faces instead of 4.0), but the way along the curve is shorter,
  // and more of it is still in the cache. Few sites are there anyway.
  constexpr std::size_t kRounds = 65, kMany = std::size_t{1} << 13;
  const std::size_t zerosOfRound = n < kMany ? 1 : 3;
  const auto roundOf = [zerosOfRound](std::size_t k) {
    std::uint64_t z = (k + 1ull) * 0x9E3779B97F4A7C15ull;  // splitmix64
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<std::size_t>(std::countl_zero(z ^ (z >> 31))) / zerosOfRound;
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
