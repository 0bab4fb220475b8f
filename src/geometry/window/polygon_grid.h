// The segments of a region's polygon by the cells of a grid: does its border come near a curve?
#pragma once

#include <cstdint>

#include "geometry/curve/conic.h"
#include "geometry/window/polygon.h"
#include "geometry/window/segment_grid.h"

namespace apollonius::internal {

class PolygonGrid {
 public:
  /// REQUIRES: `polygon` lives as long.
  explicit PolygonGrid(const NormalizedPolygon& polygon);

  /// Has the triangle of a curve's ends and its control point anything of the border in it or on
  /// it, but for the curve's own ends? These are on segments, where that is not kNoSegment, up to
  /// rounding. Exact for the doubles there are. Cost: the grid's cells that the triangle meets, and
  /// the segments there.
  [[nodiscard]] bool meetsTriangle(const Conic& curve, std::uint32_t fromSegment,
                                   std::uint32_t toSegment) const;

 private:
  const NormalizedPolygon& polygon_;
  FlatArray<Segment> segments_;
  SegmentGrid grid_;
};

}  // namespace apollonius::internal
