// The state of a Region: its polygon, and the last diagram that it was used with, clipped to it.
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/clipping/polygon_clipping.h"

namespace apollonius::internal {

struct RegionState {
  NormalizedPolygon polygon;
  double area = 0;
  Point centroid;

  /// For a diagram whose state has this number; made anew only if it is not the last one. Throws
  /// std::bad_alloc.
  [[nodiscard]] const Clipping& clippingOf(const DiagramCore& core, std::uint64_t state) {
    if (clipping_ == nullptr || state_ != state) {
      clipping_.reset();
      clipping_ = std::make_unique<PolygonClipping>(core, polygon);
      state_ = state;
    }
    return *clipping_;
  }

 private:
  std::unique_ptr<PolygonClipping> clipping_;
  std::uint64_t state_ = 0;
};

}  // namespace apollonius::internal
