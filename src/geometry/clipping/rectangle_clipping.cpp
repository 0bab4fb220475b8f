#include "geometry/clipping/rectangle_clipping.h"

#include "geometry/cell/rectangle_cell.h"
#include "geometry/draw/render.h"
#include "geometry/window/rectangle_clip.h"

namespace apollonius::internal {

void RectangleClipping::visitRings(FunctionRef<void(std::span<const Point>)> visit) const {
  const Point corners[] = {box_.corner(0), box_.corner(1), box_.corner(2), box_.corner(3)};
  visit(corners);
}

std::unique_ptr<CellClipper> RectangleClipping::cells(Parts parts) const {
  return std::make_unique<RectangleCellClipper>(core_, box_, parts);
}

void RectangleClipping::visitEdges(EdgeVisitor& visitor) const {
  forEachClippedPiece(core_.delaunay(), box_, VertexPrecision::kReproducible,
                      [&](HalfedgeId h, const ClippedPiece& piece) {
                        if (piece.isTouch) return;
                        visitor.visit(
                            h, {piece.curve, piece.fromSide == kNoSide, piece.toSide == kNoSide});
                      });
}

void RectangleClipping::measureCells(Measure what, std::vector<double>& measures) const {
  internal::measureCells(core_, box_, what, measures);
}

std::unique_ptr<NaturalNeighbors> RectangleClipping::naturalNeighbors() const {
  return std::make_unique<NaturalNeighbors>(core_, box_);
}

void RectangleClipping::drawEdges(Tolerance tolerance, Portion& portion, Path& path) const {
  internal::drawEdges(core_, box_, tolerance, portion, path);
}

}  // namespace apollonius::internal
