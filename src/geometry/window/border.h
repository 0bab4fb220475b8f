// The border of a window, for polygons of cells. It tells where an edge must be approximated more
// closely than the tolerance demands, and where a ring of points may cross itself. Each kind of
// window has its own: RectangleSides (rectangle_sides.h) and PolygonGrid (polygon_grid.h).
#pragma once

#include <cstdint>

#include "geometry/curve/conic.h"

namespace apollonius::internal {

class Border {
 public:
  Border() = default;
  Border(const Border&) = delete;
  Border& operator=(const Border&) = delete;
  virtual ~Border() = default;

  /// May the chord of a curve inside the window cross the border, where the curve does not? The
  /// curve's ends are on these segments of a polygon, up to rounding, unless they are kNoSegment.
  [[nodiscard]] virtual bool isNear(const Conic& curve, std::uint32_t fromSegment,
                                    std::uint32_t toSegment) const = 0;
  /// Is no part of the border in the triangle of the ends of such a curve and a point?
  [[nodiscard]] virtual bool holds(const Conic& curve, Point apex, std::uint32_t fromSegment,
                                   std::uint32_t toSegment) const = 0;
  /// Moves a point that rounding has put beyond the window's box to a side of the box. True if the
  /// border may then run through the point without the cell's ring having it there.
  [[nodiscard]] virtual bool moveInside(Point& point) const = 0;
  /// Does a piece of the border surely not cross another one of the same cell?
  [[nodiscard]] virtual bool isSimple(Point from, Point to) const = 0;
};

}  // namespace apollonius::internal
