// The border of a rectangle (border.h).
#pragma once

#include "geometry/window/border.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

class RectangleSides final : public Border {
 public:
  explicit RectangleSides(const Rectangle& box) : box_(box) {}

  /// A rectangle is convex, so only where the curve begins and ends on one side.
  [[nodiscard]] bool isNear(const Conic& curve, std::uint32_t /*fromSegment*/,
                            std::uint32_t /*toSegment*/) const override {
    const Point a = curve.p0, b = curve.p2;
    return areOn(box_.xmin, a.x, b.x) || areOn(box_.xmax, a.x, b.x) || areOn(box_.ymin, a.y, b.y) ||
           areOn(box_.ymax, a.y, b.y);
  }
  [[nodiscard]] bool holds(const Conic& /*curve*/, Point apex, std::uint32_t /*fromSegment*/,
                           std::uint32_t /*toSegment*/) const override {
    return box_.holds(apex);
  }
  [[nodiscard]] bool moveInside(Point& p) const override {
    p = box_.nearestTo(p);
    return p.x == box_.xmin || p.x == box_.xmax || p.y == box_.ymin || p.y == box_.ymax;
  }
  /// Does the piece run counter-clockwise along one side? Not where rounding has exchanged two
  /// contacts (rectangle_border.h).
  [[nodiscard]] bool isSimple(Point a, Point b) const override {
    return (areOn(box_.ymin, a.y, b.y) && b.x >= a.x) ||
           (areOn(box_.xmax, a.x, b.x) && b.y >= a.y) ||
           (areOn(box_.ymax, a.y, b.y) && b.x <= a.x) || (areOn(box_.xmin, a.x, b.x) && b.y <= a.y);
  }

 private:
  static bool areOn(double side, double a, double b) { return a == side && b == side; }

  Rectangle box_;
};

}  // namespace apollonius::internal
