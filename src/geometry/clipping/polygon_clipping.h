// Clipping to a window of any shape. It keeps where the window's rings pass through the cells, so
// it serves one state of the diagram; making it costs what ClippedDiagram does.
#pragma once

#include "geometry/clipping/clipping.h"
#include "geometry/window/polygon_clip.h"
#include "geometry/window/polygon_grid.h"

namespace apollonius::internal {

class PolygonClipping final : public Clipping {
 public:
  /// REQUIRES: both live as long, and the diagram stays as it is.
  PolygonClipping(const DiagramCore& core, const NormalizedPolygon& polygon)
      : clippedDiagram_(core, polygon) {}

  [[nodiscard]] const Rectangle& box() const override { return clippedDiagram_.polygon().box; }
  [[nodiscard]] const Border& border() const override { return grid(); }
  void visitRings(FunctionRef<void(std::span<const Point>)> visit) const override;
  [[nodiscard]] std::unique_ptr<CellClipper> cells(Parts parts) const override;
  void visitEdges(EdgeVisitor& visitor) const override;
  void measureCells(Measure what, std::vector<double>& measures) const override;
  [[nodiscard]] std::unique_ptr<NaturalNeighbors> naturalNeighbors() const override;
  void drawEdges(Tolerance tolerance, Portion& portion, Path& path) const override;

 private:
  [[nodiscard]] const PolygonGrid& grid() const;

  ClippedDiagram clippedDiagram_;
  mutable std::unique_ptr<PolygonGrid> grid_;  // made at its first use
};

}  // namespace apollonius::internal
