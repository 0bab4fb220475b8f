// Orders for bulk operations: along a Hilbert curve, so that consecutive points are close together,
// and in randomised rounds of growing size, each along the curve (biased randomised insertion
// order, Amenta, Choi and Rote), so that the expected cost stays that of a random order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"

namespace apollonius::internal {

/// Points as a strided array: x at [k * stride], y at [k * stride + 1].
struct PointArray {
  std::span<const double> values;
  std::size_t stride;
  [[nodiscard]] std::size_t size() const { return values.size() / stride; }
};

/// Sorts points along a Hilbert curve, in steps; equal points in the order of the input. The same
/// on every platform.
///
/// The curve passes through the cells of a square grid over the bounding box of all points. A cell
/// that holds many has a curve of its own over the bounding box of its points, and so on: however
/// far one point is from the others, and whatever the scales of the coordinates, points that follow
/// one another are close together.
///
/// Cost: O(n), a radix sort, for each level of cells; random points have one, an outlier makes a
/// second. Takes 24 bytes a point for its time: as much as a site, so that an array of sites that
/// is made afterwards fits where that was. The points must stay where they are. Throws
/// std::bad_alloc when it is made, and in order().
class HilbertSort {
 public:
  explicit HilbertSort(PointArray points);

  /// Goes on by about this many visits of a point. Returns whether the points are sorted.
  bool advance(std::size_t most);
  /// Indices of the points along the curve. REQUIRES: sorted.
  [[nodiscard]] FlatArray<std::uint32_t> order() const;

 private:
  /// The work on a cell, whose points from at_ on are still to be visited. The first cell is the
  /// box of all points.
  enum class Phase : std::uint8_t { kBounding, kIndexing, kSorting, kLooking, kSorted };

  struct Box {
    double lowX, lowY, highX, highY;
  };

  /// The levels of cells. A cell's points differ by at most 2^-15 of the extent of the cell above
  /// (2^-16, and roundings). Extents are at most 2^334, and at least the smallest difference of two
  /// coordinates, 2^-333 · 2^-52: 49 levels.
  static constexpr std::size_t kMostLevels = 49;

  void beginCell();
  void bound(std::size_t end);
  void indexPoints(std::size_t end);
  void endSorting();
  void look(std::size_t most);

  /// The index of the point of entry k of the cell. Before the points of the first cell are
  /// indexed there are no entries.
  [[nodiscard]] std::size_t pointOf(std::size_t k) const {
    return level_ == 0 ? k : entries_[k].value;
  }

  PointArray points_;
  std::unique_ptr<Keyed[]> room_;
  std::span<Keyed> entries_, other_;
  std::optional<KeySort> sort_;
  Phase phase_ = Phase::kBounding;
  std::size_t begin_ = 0;  // where the current cell begins in entries_
  std::size_t at_ = 0;
  std::size_t level_ = 0;                        // level of the current cell
  std::array<std::size_t, kMostLevels> ends_{};  // by level: the end of the current cell, and of
                                                 // those that it is in
  Box box_{};
};

/// The order that a HilbertSort gives.
[[nodiscard]] FlatArray<std::uint32_t> hilbertOrder(PointArray points);

/// The items in randomised rounds, each in the order in which they are given: about half of them in
/// the last round (of many, seven eighths), as large a share of the rest in the one before, and so
/// on. Seeded: the same on every platform.
[[nodiscard]] FlatArray<std::uint32_t> brioOrder(std::span<const std::uint32_t> items);

}  // namespace apollonius::internal
