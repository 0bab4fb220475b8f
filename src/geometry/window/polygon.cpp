#include "geometry/window/polygon.h"

#include <algorithm>

#include "geometry/window/arrangement.h"
#include "number/fp.h"
#include "number/sum.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

Rectangle boxOf(std::span<const Point> points) {
  if (points.empty()) return {};
  Rectangle box{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const Point p : points) box.include(p);
  return box;
}

}  // namespace

Area areaOf(std::span<const Point> ring) {
  Sum sum;
  // Each cross product has a rounding of each of the four differences, of the two products, and of
  // their difference.
  double roundings = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    const Point a = ring[k] - ring[0], b = ring[k + 1] - ring[0];
    sum.add(cross(a, b) / 2);
    roundings += 4 * (absolute(a.x * b.y) + absolute(a.y * b.x));
  }
  // A point that moves changes the area by half of its way times the distance between the points
  // beside it, at most.
  for (std::size_t k = 0, before = ring.size() - 1; k < ring.size(); before = k++) {
    const Point way = ring[k + 1 < ring.size() ? k + 1 : 0] - ring[before];
    roundings += (absolute(ring[k].x * way.y) + absolute(ring[k].y * way.x)) / 2;
  }
  return {sum.value(), kUnitRoundoff * roundings};
}

NormalizedPolygon normalizePolygon(std::span<const double> coordinates,
                                   std::span<const std::uint32_t> starts) {
  NormalizedPolygon polygon;
  FlatArray<Point> given;
  for (std::size_t k = 0; k + 1 < coordinates.size(); k += 2)
    given.push_back({coordinates[k], coordinates[k + 1]});
  const Rectangle box = boxOf(given);
  Arrangement lines(box);
  for (std::size_t k = 0; k + 1 < starts.size(); ++k)
    lines.addRing(coordinates.subspan(2 * std::size_t{starts[k]},
                                      2 * std::size_t{starts[k + 1] - starts[k]}));
  if (!(box.width() > 0 && box.height() > 0) || !lines.split()) {
    polygon.starts.assign(1, 0);
    return polygon;
  }
  lines.orient();
  lines.link(polygon);
  polygon.box = boxOf(polygon.points);
  return polygon;
}

bool NormalizedPolygon::holds(Point p) const {
  bool isInside = false;  // so far, by the crossings with the ray from p to the right
  for (std::size_t k = 0; k < ringCount(); ++k) {
    const std::span<const Point> own = ring(k);
    Point a = own.back();
    for (const Point b : own) {
      const bool isAcross = (a.y <= p.y) != (b.y <= p.y);
      if (isAcross || (std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y))) {
        const Sign side = orient2d(a, b, p);
        if (side == Sign::kZero && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x))
          return true;
        if (isAcross && (side == Sign::kPositive) == (a.y <= p.y)) isInside = !isInside;
      }
      a = b;
    }
  }
  return isInside;
}

}  // namespace apollonius::internal
