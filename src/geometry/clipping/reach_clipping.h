// Clips to a window and to the reach of the sites (reach_cell.h). Takes cells one by one from a
// clipping to the window.
#pragma once

#include "apollonius/reach.h"
#include "geometry/clipping/clipping.h"

namespace apollonius::internal {

class ReachClipping final : public Clipping {
 public:
  /// REQUIRES: all of them live as long, and the diagram stays as it is.
  ReachClipping(const DiagramCore& core, const Clipping& window, const Reach& reach)
      : core_(core), window_(window), reach_(reach) {}

  [[nodiscard]] const Rectangle& box() const override { return window_.box(); }
  [[nodiscard]] const Border& border() const override { return window_.border(); }
  void visitRings(FunctionRef<void(std::span<const Point>)> visit) const override;
  [[nodiscard]] std::unique_ptr<CellClipper> cells(Parts parts) const override;
  /// Visits the pieces that two cells share.
  void visitEdges(EdgeVisitor& visitor) const override;
  void measureCells(Measure what, std::vector<double>& measures) const override;
  [[nodiscard]] std::unique_ptr<NaturalNeighbors> naturalNeighbors() const override;
  /// Draws the edges that two cells share, and the arcs where cells end without a neighbor.
  void drawEdges(Tolerance tolerance, Portion& portion, Path& path) const override;

 private:
  const DiagramCore& core_;
  const Clipping& window_;
  const Reach& reach_;
};

}  // namespace apollonius::internal
