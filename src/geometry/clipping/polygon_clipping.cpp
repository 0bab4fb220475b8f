#include "geometry/clipping/polygon_clipping.h"

#include "geometry/cell/polygon_cell.h"
#include "geometry/draw/render.h"

namespace apollonius::internal {

const PolygonGrid& PolygonClipping::grid() const {
  if (grid_ == nullptr) grid_ = std::make_unique<PolygonGrid>(clippedDiagram_.polygon());
  return *grid_;
}

void PolygonClipping::visitRings(FunctionRef<void(std::span<const Point>)> visit) const {
  const NormalizedPolygon& polygon = clippedDiagram_.polygon();
  for (std::size_t k = 0; k < polygon.ringCount(); ++k) visit(polygon.ring(k));
}

std::unique_ptr<CellClipper> PolygonClipping::cells(Parts parts) const {
  return std::make_unique<PolygonCellClipper>(clippedDiagram_, parts);
}

void PolygonClipping::visitEdges(EdgeVisitor& visitor) const {
  clippedDiagram_.visitEdges(VertexPrecision::kReproducible, [&](HalfedgeId h, const Edge& edge,
                                                                 const InsideInterval& piece) {
    if (clippedDiagram_.isTouch(h, edge, piece)) return;
    visitor.visit(h, {piece.curve, piece.startsAtVertex, piece.endsAtVertex});
  });
}

void PolygonClipping::measureCells(Measure what, std::vector<double>& measures) const {
  internal::measureCells(clippedDiagram_, what, measures);
}

std::unique_ptr<NaturalNeighbors> PolygonClipping::naturalNeighbors() const {
  return std::make_unique<NaturalNeighbors>(clippedDiagram_, grid());
}

void PolygonClipping::drawEdges(Tolerance tolerance, Portion& portion, Path& path) const {
  internal::drawEdges(clippedDiagram_, tolerance, portion, path);
}

}  // namespace apollonius::internal
