// The largest circle inside a cell of the sphere: room for a label or a symbol.
#pragma once

#include "sphere/cell.h"
#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// A circle on the unit sphere: its centre, and its radius as an angle.
struct InnerCircle {
  Direction centre;
  double radius = 0;
};

/// The largest circle inside the cell of a visible site, which reaches beyond its centre: the
/// radius is at least 0.999 of the largest possible, and the circle is inside up to rounding.
/// Throws std::bad_alloc. Returns false if the search does not end, as in cells that are thousands
/// of times as long as wide. Cost: some hundred times O(d), and for thin cells their length in
/// widths.
[[nodiscard]] bool findInnerCircle(const ProjectedDiagram& diagram, VertexId node,
                                   const AngularReach& reach, InnerCircle& circle);

}  // namespace apollonius::internal::sphere
