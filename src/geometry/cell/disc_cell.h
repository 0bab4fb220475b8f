// The part of a cell within a distance of its site's centre (coverage): cell and disk are
// star-shaped about the same point, so their intersection is one region, and along an edge the
// distance from the centre is (D/2) cosh t + A, or - A (bisector.h): no equation is to be solved.
#pragma once

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "geometry/cell/boundary_piece.h"

namespace apollonius::internal {

/// Its boundary, counter-clockwise: pieces of the cell's edges and circular arcs (neighbor
/// kNoSite). Empty for a hidden site or a radius of 0 or less.
void cellWithin(const DiagramCore& core, Slot site, double radius,
                FlatArray<BoundaryPiece>& boundary);

}  // namespace apollonius::internal
