#include "geometry/window/polygon_grid.h"

#include <algorithm>

#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

FlatArray<Segment> segmentsOf(const NormalizedPolygon& polygon) {
  FlatArray<Segment> segments;
  for (std::size_t k = 0; k < polygon.ringCount(); ++k) {
    for (std::uint32_t at = polygon.starts[k]; at < polygon.starts[k + 1]; ++at)
      segments.push_back({at, at + 1 < polygon.starts[k + 1] ? at + 1 : polygon.starts[k]});
  }
  return segments;
}

/// A triangle, counter-clockwise.
struct Triangle {
  Point a, b, c;

  /// Is a segment outside? Two convex shapes are apart if the line of a side of one separates them.
  [[nodiscard]] bool isApartFrom(Point p, Point q) const {
    const auto areRightOf = [&](Point from, Point to) {
      return orient2d(from, to, p) == Sign::kNegative && orient2d(from, to, q) == Sign::kNegative;
    };
    if (areRightOf(a, b) || areRightOf(b, c) || areRightOf(c, a)) return true;
    const Sign side = orient2d(p, q, a);
    return side != Sign::kZero && orient2d(p, q, b) == side && orient2d(p, q, c) == side;
  }
};

/// Does a ray from a triangle's corner `at` to p, with the other corners counter-clockwise after
/// it, stay outside?
bool leaves(Point at, Point next, Point last, Point p) {
  return p == at || orient2d(at, next, p) == Sign::kNegative ||
         orient2d(at, last, p) == Sign::kPositive;
}

}  // namespace

PolygonGrid::PolygonGrid(const NormalizedPolygon& polygon)
    : polygon_(polygon),
      segments_(segmentsOf(polygon)),
      grid_(polygon.points, segments_, polygon.box) {}

bool PolygonGrid::isNear(const Conic& curve, std::uint32_t fromSegment,
                         std::uint32_t toSegment) const {
  if (fromSegment == toSegment && fromSegment != kNoSegment) return true;
  const Sign turn = orient2d(curve.p0, curve.p1, curve.p2);
  if (turn == Sign::kZero) return false;  // as straight as doubles can tell
  const bool isLeft = turn == Sign::kPositive;
  const Triangle triangle{curve.p0, isLeft ? curve.p1 : curve.p2, isLeft ? curve.p2 : curve.p1};
  const auto isMet = [&](std::uint32_t number) {
    const Point p = polygon_.points[segments_[number].from],
                q = polygon_.points[segments_[number].to];
    const bool startsOnIt = number == fromSegment || p == curve.p0 || q == curve.p0;
    const bool endsOnIt = number == toSegment || p == curve.p2 || q == curve.p2;
    if (startsOnIt && endsOnIt) return true;
    if (startsOnIt) {
      return !(leaves(triangle.a, triangle.b, triangle.c, p) &&
               leaves(triangle.a, triangle.b, triangle.c, q));
    }
    if (endsOnIt) {
      const Point next = isLeft ? curve.p0 : curve.p1, last = isLeft ? curve.p1 : curve.p0;
      return !(leaves(curve.p2, next, last, p) && leaves(curve.p2, next, last, q));
    }
    return !triangle.isApartFrom(p, q);
  };
  return grid_.isAnyCell({triangle.a, triangle.b, triangle.c}, [&](std::size_t cell) {
    const auto numbers = grid_.at(cell);
    return std::any_of(numbers.begin(), numbers.end(), isMet);
  });
}

bool PolygonGrid::isClearOf(const Rectangle& box) const {
  // A segment is approximated by its box.
  const auto isMet = [&](std::uint32_t number) {
    const Point p = polygon_.points[segments_[number].from],
                q = polygon_.points[segments_[number].to];
    return std::min(p.x, q.x) <= box.xmax && std::max(p.x, q.x) >= box.xmin &&
           std::min(p.y, q.y) <= box.ymax && std::max(p.y, q.y) >= box.ymin;
  };
  return !grid_.isAnyCell({box.corner(0), box.corner(1), box.corner(2), box.corner(3)},
                          [&](std::size_t cell) {
                            const auto numbers = grid_.at(cell);
                            return std::any_of(numbers.begin(), numbers.end(), isMet);
                          });
}

}  // namespace apollonius::internal
