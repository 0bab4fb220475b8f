#include "geometry/inscribed/inner_circle.h"

#include <algorithm>

#include "number/fp.h"

namespace apollonius::internal {

void copyCurves(const Cell& cell, FlatArray<Conic>& curves) {
  curves.clear();
  for (const BoundaryPiece& piece : cell.pieces) curves.push_back(piece.curve);
}

Rectangle boxOf(std::span<const Conic> curves) {
  const Point first = curves[0].p0;
  Rectangle box{first.x, first.y, first.x, first.y};
  for (const Conic& curve : curves)
    for (const Point p : {curve.p0, curve.p1, curve.p2}) box.include(p);
  return box;
}

double grainOf(const Rectangle& box) {
  return powerOfTwo(-50) * std::max(std::max(absolute(box.xmin), absolute(box.xmax)),
                                    std::max(absolute(box.ymin), absolute(box.ymax)));
}

bool InnerCircleFinder::find(std::span<const Conic> curves, std::span<const std::uint32_t> starts,
                             double aspect, Place& circle) {
  if (aspect != 1) {
    // With narrower x the ellipse is a circle, and conics are conics.
    narrowed_.assign(curves);
    for (Conic& curve : narrowed_)
      for (Point* p : {&curve.p0, &curve.p1, &curve.p2}) p->x /= aspect;
    curves = narrowed_;
  }
  const Rectangle box = boxOf(curves);
  border_.clear(grainOf(box) / 2);
  for (std::size_t k = 1; k < starts.size(); ++k)
    border_.addRing(curves.subspan(starts[k - 1], starts[k] - starts[k - 1]));
  // A point of the border is a circle, too: where no double is inside, the only one.
  circle = {curves[0].p0, 0};
  const bool isFound = search_.find(box, grainOf(box), circle);
  circle.at.x *= aspect;
  return isFound;
}

}  // namespace apollonius::internal
