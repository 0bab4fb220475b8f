// The segments of a region's polygon by the cells of a grid: the border of that window.
#pragma once

#include <cstdint>

#include "geometry/window/border.h"
#include "geometry/window/polygon.h"
#include "geometry/window/segment_grid.h"

namespace apollonius::internal {

class PolygonGrid final : public Border {
 public:
  /// REQUIRES: `polygon` lives as long.
  explicit PolygonGrid(const NormalizedPolygon& polygon);

  /// Has the triangle of a curve's ends and its control point anything of the border in it or on
  /// it, but for the curve's own ends? These are on segments, where that is not kNoSegment, up to
  /// rounding. Exact for the doubles there are. Cost: the grid's cells that the triangle meets, and
  /// the segments there.
  [[nodiscard]] bool isNear(const Conic& curve, std::uint32_t fromSegment,
                            std::uint32_t toSegment) const override;
  [[nodiscard]] bool holds(const Conic& curve, Point apex, std::uint32_t fromSegment,
                           std::uint32_t toSegment) const override {
    return !isNear({curve.p0, apex, 1, curve.p2}, fromSegment, toSegment);
  }
  /// Is surely nothing of the border in a rectangle or on its sides? Cost: the grid's cells that it
  /// meets, and the segments there, until one is.
  [[nodiscard]] bool isClearOf(const Rectangle& box) const;
  /// It may run anywhere: isSimple() says so of all cells at the border.
  [[nodiscard]] bool moveInside(Point& p) const override {
    p = polygon_.box.nearestTo(p);
    return false;
  }
  /// Never sure: the border may come back to a point, or pass by as close as doubles are.
  [[nodiscard]] bool isSimple(Point /*from*/, Point /*to*/) const override { return false; }

 private:
  const NormalizedPolygon& polygon_;
  FlatArray<Segment> segments_;
  SegmentGrid grid_;
};

}  // namespace apollonius::internal
