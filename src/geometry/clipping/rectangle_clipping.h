// Clipping to a rectangle. It keeps nothing of the diagram: a cell is clipped in O(d log d) after
// any change.
#pragma once

#include "geometry/clipping/clipping.h"
#include "geometry/window/rectangle_sides.h"

namespace apollonius::internal {

class RectangleClipping final : public Clipping {
 public:
  /// REQUIRES: `core` lives as long.
  RectangleClipping(const DiagramCore& core, const Rectangle& box)
      : core_(core), box_(box), sides_(box) {}

  [[nodiscard]] const Rectangle& box() const override { return box_; }
  [[nodiscard]] const Border& border() const override { return sides_; }
  void visitRings(FunctionRef<void(std::span<const Point>)> visit) const override;
  [[nodiscard]] std::unique_ptr<CellClipper> cells(Parts parts) const override;
  void visitEdges(EdgeVisitor& visitor) const override;
  void measureCells(Measure what, std::vector<double>& measures) const override;
  [[nodiscard]] std::unique_ptr<NaturalNeighbors> naturalNeighbors() const override;
  void drawEdges(Tolerance tolerance, Portion& portion, Path& path) const override;

 private:
  const DiagramCore& core_;
  Rectangle box_;
  RectangleSides sides_;
};

}  // namespace apollonius::internal
