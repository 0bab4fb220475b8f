// The window: an axis-parallel rectangle, its four sides and places on its border.
//
//            side 2
//      3 ─────────────── 2
//      │                 │
//  s 3 │                 │ side 1
//      │                 │
//      0 ─────────────── 1
//            side 0
//
// Sides are numbered counter-clockwise from the lower left corner; corner k is where side k starts.
// A point on a side belongs to the border and counts as outside: what only touches the window is
// not in it.
#pragma once

#include <algorithm>
#include <array>

#include "number/fp.h"
#include "predicate/point.h"

namespace apollonius::internal {

struct Rectangle {
  double xmin, ymin, xmax, ymax;

  [[nodiscard]] double width() const { return xmax - xmin; }
  [[nodiscard]] double height() const { return ymax - ymin; }
  [[nodiscard]] double diagonal() const { return length({width(), height()}); }
  [[nodiscard]] Point center() const { return middle({xmin, ymin}, {xmax, ymax}); }
  [[nodiscard]] bool holds(Point p) const {
    return p.x > xmin && p.x < xmax && p.y > ymin && p.y < ymax;
  }
  void include(Point p) {
    xmin = std::min(xmin, p.x);
    ymin = std::min(ymin, p.y);
    xmax = std::max(xmax, p.x);
    ymax = std::max(ymax, p.y);
  }
  [[nodiscard]] Point nearestTo(Point p) const {
    return {std::clamp(p.x, xmin, xmax), std::clamp(p.y, ymin, ymax)};
  }

  [[nodiscard]] Point corner(int k) const {
    return {k == 1 || k == 2 ? xmax : xmin, k >= 2 ? ymax : ymin};
  }
  /// Outer normal of a side; the window is where normal · p < offset.
  [[nodiscard]] static Point normal(int side) {
    constexpr std::array<Point, 4> kNormals{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return kNormals[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] double offset(int side) const {
    return side == 0 ? -ymin : side == 1 ? xmax : side == 2 ? ymax : -xmin;
  }
  /// Is the point beyond a side, or on its line? Exact.
  [[nodiscard]] bool isBeyond(int side, Point p) const {
    return side == 0   ? p.y <= ymin
           : side == 1 ? p.x >= xmax
           : side == 2 ? p.y >= ymax
                       : p.x <= xmin;
  }

  /// The point of a side that is nearest to p.
  [[nodiscard]] Point onSide(int side, Point p) const {
    const Point a = corner(side), b = corner((side + 1) % 4);
    const auto clamped = [](double x, double low, double high) {
      return x > low ? std::min(x, high) : low;
    };  // NaN: low
    if (side % 2 == 0) return {clamped(p.x, xmin, xmax), a.y};
    return {b.x, clamped(p.y, ymin, ymax)};
  }
  /// The position of a border point: from 0 (corner 0) to 4, counter-clockwise, a side for each
  /// unit.
  [[nodiscard]] double positionOf(int side, Point p) const {
    const Point a = corner(side);
    const double part =
        side % 2 == 0 ? absolute(p.x - a.x) / width() : absolute(p.y - a.y) / height();
    return side + std::min(part, 1.0);
  }
  /// The point at a position from 0 to 4.
  [[nodiscard]] Point at(double position) const {
    const int side = std::min(static_cast<int>(position), 3);
    const Point a = corner(side), b = corner((side + 1) % 4);
    const double t = position - side;
    return onSide(side, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  }
};

}  // namespace apollonius::internal
