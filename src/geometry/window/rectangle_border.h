// Finds the parts of the window's border that belong to a cell, from the points where the cell's
// boundary leaves and enters the window.
//
// Counter-clockwise along the border, the cell begins at each point where its boundary
// (counter-clockwise, the cell on the left) leaves the window, and ends where it enters: leaves and
// enters alternate. Rounding can swap two that are close. So they are not matched by their order
// along the border, but as two sorted lists whose k-th entries belong together; then the effect of
// rounding is as small as rounding itself. The first leave belongs to the first enter or to the
// second: the choice with (almost) no disorder is taken, unless the nearest sites of points between
// contradict.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// A point where a cell's boundary meets the window's border.
struct BorderContact {
  int side;
  double position;  ///< Rectangle::positionOf
  Point point;
  std::uint32_t piece;  ///< the piece of the boundary that ends here (leaves) or starts here
  bool leaves;
};

/// A part of the border, counter-clockwise from where a piece leaves to where a piece enters, with
/// the corners on the way.
struct BorderArc {
  std::uint32_t from, to;  ///< indices of contacts
  int firstCorner = 0, cornerCount = 0;
};

/// Matches the contacts of a cell, and sorts them by position. As many leave as enter, unless edges
/// are invalid.
void linkBorderArcs(const DiagramCore& core, Slot site, const Rectangle& window,
                    FlatArray<BorderContact>& contacts, FlatArray<BorderArc>& arcs);

/// The site that owns the whole window if no edge meets it: the one nearest to most of its corners
/// and its middle, or kNoSlot. REQUIRES: not empty.
[[nodiscard]] Slot ownerOfWindow(const DiagramCore& core, const Rectangle& window);

}  // namespace apollonius::internal
