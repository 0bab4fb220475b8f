// What a Region holds: its polygon, and how that lies on the diagram that it was last used with.
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/window/polygon_clip.h"
#include "geometry/window/polygon_grid.h"

namespace apollonius::internal {

struct RegionState {
  NormalizedPolygon polygon;
  double area = 0;

  /// Laid over a diagram whose state has this number; anew only if it is not the last one. Throws
  /// std::bad_alloc.
  [[nodiscard]] const ClippedDiagram& clippedOn(const DiagramCore& core, std::uint64_t state) {
    if (clippedDiagram_ == nullptr || state_ != state) {
      clippedDiagram_.reset();
      clippedDiagram_ = std::make_unique<ClippedDiagram>(core, polygon);
      state_ = state;
    }
    return *clippedDiagram_;
  }

  /// Made at its first use. Throws std::bad_alloc.
  [[nodiscard]] const PolygonGrid& polygonGrid() {
    if (grid_ == nullptr) grid_ = std::make_unique<PolygonGrid>(polygon);
    return *grid_;
  }

 private:
  std::unique_ptr<PolygonGrid> grid_;
  std::unique_ptr<ClippedDiagram> clippedDiagram_;
  std::uint64_t state_ = 0;
};

}  // namespace apollonius::internal
