// The part of a cell within a distance of its site's centre (coverage): cell and disk are
// star-shaped about the same point, so their intersection is one region, and along an edge the
// distance from the centre is (D/2) cosh t + A, or - A (bisector.h): no equation is to be solved.
#pragma once

#include "diagram/diagram_core.h"
#include "geometry/cell/cell_clipper.h"

namespace apollonius::internal {

class DiscCellClipper final : public CellClipper {
 public:
  /// Of this radius about the centre of each site.
  DiscCellClipper(const DiagramCore& core, double radius)
      : CellClipper(Parts::kWithArea), core_(core), radius_(radius) {}

  /// Pieces of the cell's edges and circular arcs, of which the neighbor is kNoSite. Without parts
  /// for a radius of 0 or less, too. Cost: O(d).
  const Cell& find(Slot site) override;

 private:
  const DiagramCore& core_;
  double radius_;
  Cell cell_;
};

}  // namespace apollonius::internal
