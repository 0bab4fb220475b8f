#include "diagram/hint_grid.h"

#include <cmath>
#include <new>

namespace apollonius::internal {

void HintGrid::rebuild(std::size_t sites, const Site& low, const Site& high) noexcept {
  try {
    side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(sites))) + 1;
    cells_.assign(side_ * side_, Cell{});
    low_ = low;
    const auto cells = static_cast<double>(side_);
    scaleX_ = high.x > low.x ? cells / (high.x - low.x) : 0;
    scaleY_ = high.y > low.y ? cells / (high.y - low.y) : 0;
    noted_ = 0;
  } catch (const std::bad_alloc&) {
    clear();
  }
}

void HintGrid::fillGaps() noexcept {
  for (std::size_t row = 0; row < side_; ++row) {
    for (std::size_t column = 0; column < side_; ++column) {
      Cell& cell = cells_[row * side_ + column];
      if (cell.count > 0) continue;
      const auto take = [&](const Cell& beside) {
        if (beside.count > 0) cell.site = beside.site;
      };
      if (row > 0) take(*(&cell - side_));
      if (row + 1 < side_) take(*(&cell + side_));
      if (column > 0) take(*(&cell - 1));
      if (column + 1 < side_) take(*(&cell + 1));
    }
  }
}

}  // namespace apollonius::internal
