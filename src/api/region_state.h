// What a Region holds: its outline, and how that lies on the diagram that it was last used with.
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/window/polygon_clip.h"
#include "geometry/window/polygon_grid.h"

namespace apollonius::internal {

struct RegionState {
  Outline outline;
  double area = 0;

  /// Laid over a diagram whose state has this number; anew only if it is not the last one. Throws
  /// std::bad_alloc.
  [[nodiscard]] const Overlay& overlayOn(const DiagramCore& core, std::uint64_t state) {
    if (overlay_ == nullptr || state_ != state) {
      overlay_.reset();
      overlay_ = std::make_unique<Overlay>(core, outline);
      state_ = state;
    }
    return *overlay_;
  }

  /// Made at its first use. Throws std::bad_alloc.
  [[nodiscard]] const OutlineGrid& outlineGrid() {
    if (grid_ == nullptr) grid_ = std::make_unique<OutlineGrid>(outline);
    return *grid_;
  }

 private:
  std::unique_ptr<OutlineGrid> grid_;
  std::unique_ptr<Overlay> overlay_;
  std::uint64_t state_ = 0;
};

}  // namespace apollonius::internal
