// A grid of hints for starts of searches: for each cell of a square grid over the sites, a site
// with its centre there. Where sites are spread evenly, the nearest of the sites of the four
// closest cells is mostly the nearest of all, and reading these cells replaces the descent through
// the hierarchy. Cells that hold many sites give no answer: there the hierarchy is better.
//
// The grid is only a hint. Entries become stale when sites leave or move, and their slots go to
// sites elsewhere. The caller checks that the site is visible and still close: walks from afar cost
// far more than the hierarchy. If the grid runs out of memory it is dropped.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "diagram/id_pool.h"
#include "predicate/site.h"

namespace apollonius::internal {

class HintGrid {
 public:
  /// Visits the slots of sites whose centres were in the four cells closest to (x, y), one of each
  /// cell or of one beside it; none if the cell of (x, y) holds many sites. Reading four cells
  /// takes hardly longer than one: no address depends on another read.
  template <class Visit>
  void forEachNear(double x, double y, Visit visit) const {
    if (cells_.empty()) return;
    const Closest column = closestTo((x - low_.x) * scaleX_),
                  row = closestTo((y - low_.y) * scaleY_);
    const Cell* const rows[] = {&cells_[row.own * side_], &cells_[row.beside * side_]};
    if (rows[0][column.own].count > kFew) return;
    for (const Cell* cells : rows) {
      for (const std::size_t k : {column.own, column.beside}) {
        if (cells[k].count <= kFew && cells[k].site != kEmptySlot) visit(Slot{cells[k].site});
      }
    }
  }

  /// Is the site's centre in the cell of (x, y) or beside it? REQUIRES: forEachNear() has named it.
  [[nodiscard]] bool isClose(const Site& site, double x, double y) const {
    const auto differ = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    return differ(columnOf(site.x), columnOf(x)) <= 1 && differ(rowOf(site.y), rowOf(y)) <= 1;
  }

  void insert(Slot slot, const Site& site) {
    ++noted_;
    if (cells_.empty()) return;
    Cell& cell = cells_[cellOf(site.x, site.y)];
    cell.site = slot & kEmptySlot;
    if (cell.count <= kFew) ++cell.count;
  }
  void remove(const Site& site) {
    if (cells_.empty()) return;
    Cell& cell = cells_[cellOf(site.x, site.y)];
    if (cell.count > 0 && cell.count <= kFew) --cell.count;
  }

  void move(Slot slot, const Site& from, const Site& to) {
    if (cells_.empty() || cellOf(from.x, from.y) == cellOf(to.x, to.y)) return;
    remove(from);
    insert(slot, to);
  }

  /// Is a rebuild, which looks at `slots` slots, worth it by now? Few of these slots may have
  /// visible sites.
  [[nodiscard]] bool isOutgrown(std::size_t slots) const {
    return noted_ > kLeast && noted_ > 2 * cells_.size() && noted_ > slots / 64;
  }

  /// Starts anew with all cells empty, for `sites` sites within a box. Then insert() each of them,
  /// and call fillGaps().
  void rebuild(std::size_t sites, const Site& low, const Site& high) noexcept;

  /// Gives each cell without a site that of a cell beside it. (With random sites, a third of the
  /// cells have none.)
  void fillGaps() noexcept;

  void clear() noexcept { *this = HintGrid{}; }

 private:
  friend class DiagramBreaker;  // tests break a structure on purpose

  static constexpr std::size_t kLeast = 64;  // below, walks are short anyway
  static constexpr std::uint32_t kFew = 6;

  static constexpr unsigned kSiteBits = 29;
  static constexpr Slot kEmptySlot = (Slot{1} << kSiteBits) - 1;
  static_assert(kMostSites == std::size_t{1} << kSiteBits);  // the last slot is lost for the grid,
                                                             // which is no more than a hint

  struct Cell {
    Slot site : kSiteBits = kEmptySlot;
    std::uint32_t count : 3 = 0;  // number of sites inserted; once at kFew + 1, it stays there
  };

  /// The row or column of cells at a position, and the one beside it that is closer to the
  /// position; the same at the border.
  struct Closest {
    std::size_t own, beside;
  };
  [[nodiscard]] Closest closestTo(double position) const {
    const std::size_t own = clamped(position);
    const bool isLow = position - static_cast<double>(own) < 0.5;
    if (isLow) return {own, own > 0 ? own - 1 : own};
    return {own, own + 1 < side_ ? own + 1 : own};
  }
  [[nodiscard]] std::size_t columnOf(double x) const { return clamped((x - low_.x) * scaleX_); }
  [[nodiscard]] std::size_t rowOf(double y) const { return clamped((y - low_.y) * scaleY_); }
  [[nodiscard]] std::size_t cellOf(double x, double y) const {
    return rowOf(y) * side_ + columnOf(x);
  }
  [[nodiscard]] std::size_t clamped(double position) const {
    if (!(position > 0)) return 0;
    return position < static_cast<double>(side_ - 1) ? static_cast<std::size_t>(position)
                                                     : side_ - 1;
  }

  FlatArray<Cell> cells_;  // side_ * side_, row by row
  std::size_t side_ = 0;
  std::size_t noted_ = 0;
  Site low_;
  double scaleX_ = 0, scaleY_ = 0;
};

}  // namespace apollonius::internal
