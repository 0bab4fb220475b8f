#include "geometry/cell/boundary_piece.h"

#include "geometry/curve/moments.h"
#include "number/fp.h"
#include "number/sum.h"

namespace apollonius::internal {

Area areaOf(std::span<const BoundaryPiece> boundary, Point origin) {
  Area area;
  Sum sum;  // boundaries can have as many pieces as there are sites
  double size = 0;
  for (const BoundaryPiece& piece : boundary) {
    const Point a = piece.curve.p0 - origin, b = piece.curve.p2 - origin;
    sum.add(cross(a, b) / 2);
    sum.add(areaBeyondChord(piece.curve));
    size += absolute(a.x * b.y) + absolute(a.y * b.x);
  }
  area.value = sum.value();
  // Each cross product: a rounding of each of the four differences, of the two products, and of
  // their difference.
  area.rounding = 4 * kUnitRoundoff * size;
  return area;
}

}  // namespace apollonius::internal
