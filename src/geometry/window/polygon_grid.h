// The border of a region as a window: the segments of its polygon by the cells of a grid.
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

  /// Is a part of the border in or on the triangle of a curve's ends and its control point, other
  /// than at the curve's own ends? These are on the segments given up to rounding, unless
  /// kNoSegment. Exact for these doubles. Cost: the grid's cells that the triangle meets, and the
  /// segments there.
  [[nodiscard]] bool isNear(const Conic& curve, std::uint32_t fromSegment,
                            std::uint32_t toSegment) const override;
  [[nodiscard]] bool holds(const Conic& curve, Point apex, std::uint32_t fromSegment,
                           std::uint32_t toSegment) const override {
    return !isNear({curve.p0, apex, 1, curve.p2}, fromSegment, toSegment);
  }
  /// Is surely no part of the border in a rectangle or on its sides? Cost: the grid's cells that it
  /// meets, and the segments there, up to the first one found.
  [[nodiscard]] bool isClearOf(const Rectangle& box) const;
  /// Always false: isSimple() is already unsure of every border cell.
  [[nodiscard]] bool moveInside(Point& p) const override {
    p = polygon_.box.nearestTo(p);
    return false;
  }
  /// Never sure: the border may return to a point, or pass it as close as doubles are.
  [[nodiscard]] bool isSimple(Point /*from*/, Point /*to*/) const override { return false; }

 private:
  const NormalizedPolygon& polygon_;
  FlatArray<Segment> segments_;
  SegmentGrid grid_;
};

}  // namespace apollonius::internal
